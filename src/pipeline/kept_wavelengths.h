// A group's light kept per wavelength, so that another lamp spectrum needs no new trace.
//
// The lamps' flux says how much light there is, their spectrum only how reflections filter it. With every finish as it
// is at one wavelength the room is grey, and its illuminance holds for light of that wavelength from lamps of any
// spectrum. A lamp's own result is the sum over the wavelengths kept, with weights fitted to the
// lamp's spectrum on the light paths that are likely in the room (planner/spectral_choice.h).
#pragma once

#include <string>
#include <vector>

#include "planner/spectral_choice.h"
#include "project/project.h"
#include "project/results.h"
#include "scene/world.h"

namespace goniolux::pipeline {

class KeptWavelengths {
 public:
  /// As few wavelengths as meet a tenth of the grids' accuracy for lamps of every kind: incandescent, daylight,
  /// halophosphate, triphosphor, phosphor LED. They depend on the finishes alone, not on the project's lamps; one where
  /// every finish is grey.
  KeptWavelengths(const project::Project& project, const scene::World& world);

  [[nodiscard]] const std::vector<double>& wavelengths() const { return wavelengths_; }
  /// Weights for a lamp, and bounds of what the choice of wavelengths spoils with it.
  [[nodiscard]] planner::SpectralChoice with(const spectrum::SpectralDistribution& lamp) const;
  /// The results of the lamp from those kept, one per wavelength, in their order. The bound of with() is the part
  /// "spectral" of every half-width.
  [[nodiscard]] project::Results of(const spectrum::SpectralDistribution& lamp,
                                    const std::vector<project::Results>& kept, const project::Project& project) const;

 private:
  std::vector<planner::Finish> finishes_;
  planner::SpectralAllowance allowance_;
  std::vector<double> wavelengths_;
};

/// The project with every finish as it is at `wavelength` (nm), and illuminance for melanopic quantities, whose weights
/// are the lamp's.
project::Project atWavelength(const project::Project& project, double wavelength);

/// The spectrum of a group's lamps, or of the surfaces that emit. InputError names a group whose lamps differ: its
/// light has no one spectrum that could be exchanged.
spectrum::SpectralDistribution lampSpectrumOf(const project::Project& project, const std::string& group);

}  // namespace goniolux::pipeline
