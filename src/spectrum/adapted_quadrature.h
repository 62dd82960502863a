// Adapted quadrature: few wavelengths and positive weights, chosen for given sources and given light paths.
//
// A light path multiplies the spectrum of its source by a transmittance T(lambda): the product of the reflectances that
// it meets. Its response is the integral of source x observer x T, here sum_k W_k T(lambda_k): W by least squares over
// the given paths, lambda_k by a search. T is sampled, so products stay products at the nodes, however long the path.
#pragma once

#include <vector>

#include "spectrum/spectral_quadrature.h"

namespace goniolux::spectrum {

struct LightPath {
  std::vector<double> transmittance;  ///< at the wavelengths of the control
  /// Relative error of each channel that would be as bad as that of another path: the reciprocals weight the fit. 0: of
  /// no interest.
  Response tolerance{};
};

/// Errors are relative to the response, but to no less than this share of what arrives unreflected: a path that returns
/// less is too dark to matter.
inline constexpr double darkestShare = 0.02;

/// `count` nodes at least 1 nm apart with weights for each source of `control` (controlQuadrature() of the same
/// sources). All weights are at least 0 and white (T = 1) is exact, so for a T between a and b the response lies
/// between those of a and b, on paths that were not given too. Paths must have a tolerance above 0 somewhere.
/// Deterministic; takes some milliseconds.
SpectralQuadrature adaptedQuadrature(int count, const SpectralQuadrature& control, const std::vector<LightPath>& paths);

/// The same with nodes that are given (nm, ascending, one at least; each stands for the control's wavelength next to
/// it): only the weights are fitted.
SpectralQuadrature adaptedWeights(const std::vector<double>& wavelengths, const SpectralQuadrature& control,
                                  const std::vector<LightPath>& paths);

}  // namespace goniolux::spectrum
