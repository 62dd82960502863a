// GGX microfacets, isotropic: normal distribution, masking and shadowing (Smith, height-correlated), sampling of
// visible normals, and the table that tells how much light a single scattering loses.
//
// Sources: B. Walter et al., "Microfacet Models for Refraction through Rough Surfaces", EGSR 2007; E. Heitz,
// "Understanding the Masking-Shadowing Function", JCGT 3(2), 2014, and "Sampling the GGX Distribution of Visible
// Normals", JCGT 7(4), 2018. alpha = sqrt(2) times the rms slope of a Beckmann surface of the same peak; of a Phong
// lobe (N.H)^n it is sqrt(2 / (n + 2)).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "core/vector.h"

namespace goniolux::reflection {

class Ggx {
 public:
  /// alpha in (0, 1].
  explicit Ggx(double alpha) : alpha_(alpha), alphaSquared_(alpha * alpha) {}

  [[nodiscard]] double alpha() const { return alpha_; }
  /// Density of microfacet normals per sr of facets, per area of the surface.
  [[nodiscard]] double normals(double cosine) const {
    if (cosine <= 0) return 0;
    const double root = 1 + (alphaSquared_ - 1) * cosine * cosine;
    return alphaSquared_ / (core::pi * root * root);
  }
  /// Smith's auxiliary function of a direction's cosine (its absolute value).
  [[nodiscard]] double lambda(double cosine) const {
    const double c2 = cosine * cosine;
    if (c2 <= 0) return 1e30;
    return 0.5 * (std::sqrt(1 + alphaSquared_ * (1 - c2) / c2) - 1);
  }
  [[nodiscard]] double seen(double cosine) const { return 1 / (1 + lambda(cosine)); }  ///< G1
  /// Seen from both directions, on the same side of the surface.
  [[nodiscard]] double seenBoth(double a, double b) const { return 1 / (1 + lambda(a) + lambda(b)); }
  /// A facet normal that is visible from `out` (out.z > 0). Its density is G1 D (out.h) / out.z.
  [[nodiscard]] core::Vec3 visibleNormal(const core::Vec3& out, const core::Vec2& u) const;
  [[nodiscard]] double visibleDensity(const core::Vec3& out, const core::Vec3& normal) const {
    if (out.z <= 0) return 0;
    return seen(out.z) * normals(normal.z) * std::max(0.0, glm::dot(out, normal)) / out.z;
  }

 private:
  double alpha_, alphaSquared_;
};

/// The share of light that a single scattering at white facets sends out, by the cosine of the view; linear between
/// nodes at cosines (i/(n-1))^2, so that its mean is the exact mean of what value() gives.
class AlbedoTable {
 public:
  static constexpr std::size_t nodes = 48;
  AlbedoTable() { values_.fill(1); }
  template <typename Albedo>
  explicit AlbedoTable(const Albedo& albedo) {
    for (std::size_t i = 0; i < nodes; ++i) values_[i] = std::min(1.0, albedo(cosineOf(i)));
    // 2 integral of E(mu) mu dmu of the straight pieces, exactly
    mean_ = 0;
    for (std::size_t i = 0; i + 1 < nodes; ++i) {
      const double a = cosineOf(i), b = cosineOf(i + 1), fa = values_[i], fb = values_[i + 1];
      mean_ += (b - a) * (fa * (2 * a + b) + fb * (a + 2 * b)) / 3;
    }
  }
  [[nodiscard]] double value(double cosine) const {
    const double place = std::sqrt(std::min(1.0, std::max(0.0, cosine))) * (nodes - 1);
    const auto i = std::min(static_cast<std::size_t>(place), nodes - 2);
    const double a = cosineOf(i), b = cosineOf(i + 1), t = (std::min(1.0, std::max(0.0, cosine)) - a) / (b - a);
    return values_[i] + t * (values_[i + 1] - values_[i]);
  }
  /// Of light from all directions (Lambertian incidence).
  [[nodiscard]] double mean() const { return mean_; }

 private:
  static double cosineOf(std::size_t i) {
    const double x = static_cast<double>(i) / (nodes - 1);
    return x * x;
  }
  std::array<double, nodes> values_{};
  double mean_ = 1;
};

/// E of a rough surface whose facets reflect everything.
AlbedoTable reflectionAlbedo(const Ggx& ggx);

}  // namespace goniolux::reflection
