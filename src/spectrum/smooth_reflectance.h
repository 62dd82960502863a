// Smooth reflectance: the smoothest spectral reflectance between 0 and 1 that has a given colour under D65, for
// materials that are known by their colour only.
#pragma once

#include <array>
#include <optional>

#include "spectrum/spectral_distribution.h"

namespace goniolux::spectrum {

/// Reflectance with tristimulus values X, Y, Z (CIE 1931, under D65, Y = 1 for the perfect diffuser). Of all
/// reflectances (1 + tanh z(lambda)) / 2 with that colour, the one whose z changes least: S. A. Burns, "Numerical
/// methods for smoothest reflectance reconstruction", Color Research & Application 45(1), 2020 ("LHTSS"), here with
/// straight lines between nodes 10 nm apart from 360 to 830 nm, integrated exactly: the colour is met to rounding.
/// Greys are exactly flat. nullopt: no reflectance has this colour.
std::optional<SpectralDistribution> reflectanceFromXyz(const std::array<double, 3>& xyz);

/// The same for encoded sRGB values 0..1 (IEC 61966-2-1). Equal values give an exactly flat reflectance.
std::optional<SpectralDistribution> reflectanceFromSrgb(const std::array<double, 3>& rgb);

}  // namespace goniolux::spectrum
