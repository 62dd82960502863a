// Metrics of a luminous intensity distribution: what a luminaire sheet says. Angles in degrees, fluxes in lm (of the
// interpolant, exact for photometry type C, by quadrature to about 1e-4 for types A and B).
#pragma once

#include <array>
#include <optional>

#include "photometry/intensity_distribution.h"

namespace goniolux::photometry {

/// Flux within gamma from `from` to `to`, about the aim.
double zoneFlux(const TabulatedDistribution& distribution, double from, double to);

/// Zonal lumens: flux of the eighteen zones of 10 degrees of gamma.
std::array<double, 18> zonalLumens(const TabulatedDistribution& distribution);

struct IntensityPeak {
  double intensity_cd = 0, c = 0, gamma = 0;
};
/// The largest stated value and its direction in (C, gamma); the first in the table's order where several are equal.
IntensityPeak intensityPeak(const TabulatedDistribution& distribution);

/// The full plane through the aim made of the half planes at C and C + 180 degrees.
enum class PrincipalPlane { c0_180, c90_270 };

/// Full width, within a plane, of the directions that reach the given fraction of the largest intensity in that plane:
/// from the first to the last such direction of the hemisphere of that maximum, the lower one where both have it (so a
/// batwing's wings belong together), and on past the horizontal as far as they are reached without a gap. 0.5 gives the
/// beam angle, 0.1 the field angle. Empty when the plane is dark.
std::optional<double> fullWidth(const TabulatedDistribution& distribution, PrincipalPlane plane, double fraction);

/// CIE flux code (CIE 52, EN 13032-2), in percent: cone fluxes within solid angles of pi/2, pi and 3 pi/2 sr over that
/// of the lower hemisphere (N1, N2, N3), the share of the lower hemisphere (N4), and the light output ratio (N5; 100
/// without lamp flux).
std::array<double, 5> cieFluxCode(const TabulatedDistribution& distribution, std::optional<double> lampFlux);

}  // namespace goniolux::photometry
