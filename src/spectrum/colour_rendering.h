// Colour rendering indices of CIE 13.3-1995.
#pragma once

#include <array>

#include "spectrum/spectral_distribution.h"

namespace goniolux::spectrum {

struct ColourRendering {
  double ra = 0;                     ///< general index: the mean of the first eight special ones
  std::array<double, 14> special{};  ///< R1 to R14
};

/// Test colour method: reference is Planck's radiator below a correlated colour temperature of 5000 K, CIE daylight
/// from there on (to 25000 K, then daylight of 25000 K). Tristimulus values by tristimulus() of colorimetry.h. Sources
/// far from white get a number too; it means little. The source must have luminous power.
ColourRendering colourRendering(const SpectralDistribution& source);

}  // namespace goniolux::spectrum
