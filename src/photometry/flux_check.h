// The three fluxes of a photometric file: exact (of the interpolant that is used), zonal-constant (what laboratories
// print), declared.
#pragma once

#include "photometry/photometric_file.h"

namespace goniolux::photometry {

/// Flux by the zonal-constant method: every zone between two stated vertical angles counts with its exact solid angle
/// (its zonal constant) and the mean of the intensities at its two bounds; planes are averaged by the trapezoidal rule,
/// lm.
double zonalConstantFlux(const TabulatedDistribution& distribution);

/// Two fluxes that should be one and part by more than this fraction get a warning.
inline constexpr double fluxAgreement = 0.02;

/// Adds warnings where the fluxes part, or where more light leaves than the lamps give.
void warnOfFluxes(PhotometricFile& file);

}  // namespace goniolux::photometry
