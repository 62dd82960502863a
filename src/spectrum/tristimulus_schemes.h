// Tristimulus schemes: colours multiplied as if they were spectra. Control cases; see schemes.h.
#pragma once

#include "spectrum/schemes.h"

namespace goniolux::spectrum {

/// A reflectance is its X, Y, Z under all the sources together, relative to white's.
SpectralQuadrature xyzScheme(const SchemeInput& input);
/// The same after the linear matrix of IEC 61966-2-1: components outside the gamut are negative and stay so.
SpectralQuadrature rgbScheme(const SchemeInput& input);

}  // namespace goniolux::spectrum
