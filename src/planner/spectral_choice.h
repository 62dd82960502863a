// The choice of wavelengths: the smallest set that meets the accuracy asked for.
#pragma once

#include <string>
#include <vector>

#include "planner/spectral_error.h"
#include "spectrum/schemes.h"
#include "spectrum/spectral_quadrature.h"

namespace goniolux::planner {

/// What the choice of wavelengths may spoil; the members mean what those of SpectralError mean.
struct SpectralAllowance {
  double illuminance = 0.002;
  bool pictures = false;  ///< luminance and colour count
  double luminance = 0.005, colour = 1;
  int leastCount = 1;      ///< nodes that are wanted in any case: where glass disperses each node goes its own way
  bool melanopic = false;  ///< as good an illuminance by the melanopic response is wanted, too
};

struct SpectralChoice {
  spectrum::SpectralQuadrature quadrature;
  SpectralError error;
};

/// One node when every finish is grey; else adapted nodes, as few as suffice; for scenes that sixteen do not do justice
/// to, the control's coarser relatives up to the control itself.
SpectralChoice chooseWavelengths(const std::vector<Finish>& finishes,
                                 const std::vector<spectrum::SpectralDistribution>& sources,
                                 const SpectralAllowance& allowance);

/// A scheme by name (spectrum/schemes.h) with a number of samples that it can have; the allowance tells adapted nodes
/// what to favour.
SpectralChoice wavelengthsOf(const spectrum::SpectralScheme& scheme, int count, const std::vector<Finish>& finishes,
                             const std::vector<spectrum::SpectralDistribution>& sources,
                             const SpectralAllowance& allowance);

/// Weights for wavelengths (nm, ascending) that are given, whatever they were chosen for, and how good they are for
/// these sources.
SpectralChoice atWavelengths(const std::vector<double>& wavelengths, const std::vector<Finish>& finishes,
                             const std::vector<spectrum::SpectralDistribution>& sources,
                             const SpectralAllowance& allowance);

}  // namespace goniolux::planner
