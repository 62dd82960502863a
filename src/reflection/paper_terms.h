// The terms that the paper's three models share: a material's coefficients and curves, and the highlights.
#pragma once

#include <cmath>
#include <vector>

#include "reflection/shading.h"

namespace goniolux::reflection {

/// Symbols of the paper's Table 1.
struct PaperTerms {
  PaperTerms(const material::Material& material, const spectrum::SpectralQuadrature& quadrature);

  std::vector<float> kdRd;        ///< k_d R_d, "object colour"
  std::vector<float> ks, kt;      ///< k_s, k_t
  double n = 1;                   ///< glossiness
  Medium inside;                  ///< refractive index, and F as attenuation -ln F
  std::vector<float> constantRf;  ///< where R_f does not follow Fresnel's equations for `inside` (metals, mirrors)
  std::vector<float> k;           ///< of a metal: extinction coefficient
  bool opaque = true;

  /// R_f at an angle of incidence.
  void fresnel(double cosine, const Interface& at, float* values) const;
};

/// (N.H)^n with H halfway between the source and the view.
double halfwayHighlight(const core::Vec3& out, const core::Vec3& in, double n);
/// (R.V)^n with R the mirror direction of the source.
double mirrorHighlight(const core::Vec3& out, const core::Vec3& in, double n);
/// (N.H')^n for a source behind: H' = -(n1 L + n2 V) normalised, n1 and n2 the indices on the sides of source and
/// viewer; N.H' is 1 where Snell's law would send the light.
double throughHighlight(const core::Vec3& out, const core::Vec3& in, double sourceIndex, double viewerIndex, double n);

/// The keys of phong, whitted and hall.
std::vector<core::Parameter> paperParameters();

}  // namespace goniolux::reflection
