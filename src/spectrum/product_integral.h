// Exact integrals over wavelength of products of up to three piecewise linear functions: source x observer x hat.
#pragma once

#include <initializer_list>

#include "spectrum/spectral_distribution.h"

namespace goniolux::spectrum {

/// Integral over [from, to] nm of the product of one to three distributions' continua, exact up to rounding, plus the
/// lines of the first, each seen through the continua of the others. Lines of the others do not count.
double integralOfProduct(std::initializer_list<const SpectralDistribution*> factors, double from, double to);

}  // namespace goniolux::spectrum
