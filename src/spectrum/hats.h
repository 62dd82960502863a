// Hats: the basis functions of linear interpolation between wavelengths ("nodes").
#pragma once

#include <vector>

#include "spectrum/spectral_distribution.h"

namespace goniolux::spectrum {

/// The wavelengths that the observer's tables cover, nm.
inline constexpr double visibleFrom = 360, visibleTo = 830;

/// 1 at its node, straight down to 0 at the neighbours, and 1 beyond an outermost node; not zero between `from` and
/// `to` only.
struct Hat {
  SpectralDistribution shape;
  double from, to;
};

/// One hat a node (ascending, nm); they sum to 1 at every visible wavelength.
std::vector<Hat> hats(const std::vector<double>& nodes);

}  // namespace goniolux::spectrum
