// The registry of spectral sampling schemes: how a few numbers carried by rays stand for a spectrum. Adding one is a
// function and a line in schemes.cpp; the project reader, the planner and the studies take it from there.
#pragma once

#include <string>
#include <vector>

#include "spectrum/adapted_quadrature.h"
#include "spectrum/spectral_quadrature.h"

namespace goniolux::spectrum {

/// What a scheme may look at. `control` is controlQuadrature(sources); `paths` are light paths at its wavelengths.
struct SchemeInput {
  int count = 9;
  const std::vector<SpectralDistribution>& sources;
  const SpectralQuadrature& control;
  const std::vector<LightPath>& paths;
  double offset = 0.5;  ///< 0 to 1: where in their strata a random scheme puts its wavelengths
};

struct SpectralScheme {
  std::string name, title;
  int defaultCount = 9, leastCount = 1, mostCount = 471;
  /// A control case that shows what goes wrong: not for photometric numbers.
  bool distorts = false;
  SpectralQuadrature (*make)(const SchemeInput& input) = nullptr;
};

const std::vector<SpectralScheme>& spectralSchemes();
/// nullptr for an unknown name.
const SpectralScheme* findSpectralScheme(const std::string& name);

}  // namespace goniolux::spectrum
