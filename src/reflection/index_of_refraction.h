// What a transparent material's curves say at the nodes of a quadrature.
#pragma once

#include <string>

#include "reflection/bsdf.h"

namespace goniolux::reflection {

/// The parameter for a refractive index: a number, a curve, Cauchy's or Sellmeier's formula.
core::Parameter refractiveIndex(std::string key, bool required, std::string help);

/// From the curves "ior" (default 1.5) and "attenuation_per_m" (default 0).
Medium mediumOf(const material::Material& material, const spectrum::SpectralQuadrature& quadrature);

/// A refractive index at the nodes themselves: no fit, a refracted ray has one wavelength.
std::vector<float> indexAtNodes(const spectrum::SpectralDistribution& index,
                                const spectrum::SpectralQuadrature& quadrature);

}  // namespace goniolux::reflection
