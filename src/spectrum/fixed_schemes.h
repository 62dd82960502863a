// Schemes whose wavelengths do not depend on the scene; see schemes.h and docs/methods/spectra.md.
#pragma once

#include "spectrum/schemes.h"

namespace goniolux::spectrum {

/// Power, observer and reflectance sampled at the middles of equal steps over 380-780 nm; each channel is scaled so
/// that white is exact. Lines of a source go unseen, unless nothing else is there.
SpectralQuadrature pointScheme(const SchemeInput& input);
/// The same without the scaling: even white is wrong. [hall83] says "nine samples" and not where.
SpectralQuadrature paperScheme(const SchemeInput& input);
/// Power x observer integrated over equal bins of 400-700 nm (the outermost reach to the ends), reflectance sampled at
/// the bins' middles.
SpectralQuadrature binScheme(const SchemeInput& input);
/// Nodes of the Gauss quadrature with weight xbar + ybar + zbar over 360-830 nm; power x observer integrated against
/// the polynomial through the nodes. Weights can be negative.
SpectralQuadrature gaussScheme(const SchemeInput& input);
/// G. W. Meyer, "Wavelength selection for synthetic image generation", CVGIP 41, 1988: four wavelengths and a matrix to
/// X, Y, Z, here times the source's power and scaled so that white is exact.
SpectralQuadrature meyerScheme(const SchemeInput& input);
/// Wilkie et al., "Hero wavelength spectral sampling", EGSR 2014, with wavelengths in proportion to what the sources
/// send and the observer sees: the quantiles (k + offset) / count of that density. With a random offset the expected
/// response is exact, white too; a single offset is not.
SpectralQuadrature heroScheme(const SchemeInput& input);

}  // namespace goniolux::spectrum
