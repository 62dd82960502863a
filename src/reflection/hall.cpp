// The paper's improved model:
//   I = k_d sum (N.L) R_d I_j + k_s sum (N.H)^n R_f I_j + k_s sum (N.H')^n T_f I_j
//       + I_a R_d + k_s R_f I_r F_r^d_r + k_s T_f I_t F_t^d_t
// R_f by Fresnel's equations: at V.H for highlights, at N.V for rays; T_f = k_t (1 - R_f), so that a material without
// k_t is opaque. As meant I_j = E / pi and F is a transmittance per unit length; as printed I_j = E, and the
// attenuation is the product F d.
#include <algorithm>
#include <cmath>

#include "reflection/paper_models.h"

namespace goniolux::reflection {
namespace {

class Hall : public PaperShading {
 public:
  using PaperShading::PaperShading;

  void addSource(const core::Vec3& out, const core::Vec3& in, double e, const Interface& at,
                 float* values) const override {
    const double intensity = asPrinted_ ? e : e / core::pi;
    thread_local std::vector<float> rf;
    rf.resize(nodes());
    if (in.z > 0) {
      const core::Vec3 h = glm::normalize(out + in);
      terms_.fresnel(std::clamp(glm::dot(out, h), 0.0, 1.0), at, rf.data());
      const auto diffuse = static_cast<float>(in.z * intensity);
      const auto highlight = static_cast<float>(halfwayHighlight(out, in, terms_.n) * intensity);
      for (std::size_t i = 0; i < nodes(); ++i)
        values[i] += terms_.kdRd[i] * diffuse + terms_.ks[i] * rf[i] * highlight;
    } else if (seesBehind()) {
      terms_.fresnel(std::clamp(out.z, 0.0, 1.0), at, rf.data());
      const auto highlight =
          static_cast<float>(throughHighlight(out, in, at.beyond(at.hero), at.here(at.hero), terms_.n) * intensity);
      for (std::size_t i = 0; i < nodes(); ++i) values[i] += terms_.ks[i] * terms_.kt[i] * (1 - rf[i]) * highlight;
    }
  }
  void ambientFactor(float* values) const override { std::copy(terms_.kdRd.begin(), terms_.kdRd.end(), values); }
  void reflectedFactor(const core::Vec3& out, const Interface& at, float* values) const override {
    terms_.fresnel(std::clamp(out.z, 0.0, 1.0), at, values);
    for (std::size_t i = 0; i < nodes(); ++i) values[i] *= terms_.ks[i];
  }
  void transmittedFactor(const core::Vec3& out, const Interface& at, float* values) const override {
    terms_.fresnel(std::clamp(out.z, 0.0, 1.0), at, values);
    for (std::size_t i = 0; i < nodes(); ++i) values[i] = terms_.ks[i] * terms_.kt[i] * (1 - values[i]);
  }
  void attenuate(const Travel& travel, float* values) const override {
    if (!asPrinted_) return LocalShading::attenuate(travel, values);
    for (std::size_t i = 0; i < nodes(); ++i) {
      const double a = travel.medium ? static_cast<double>(travel.medium->attenuation[i]) : 0.0;
      values[i] *= static_cast<float>(std::exp(-a) * travel.distance);
    }
  }
  [[nodiscard]] bool seesBehind() const override { return !terms_.opaque; }
};

}  // namespace

ShadingModel hallModel() {
  return {"hall", "Hall's improved model as in the paper (not for photometric numbers)", paperParameters(),
          makePaperShading<Hall>};
}

}  // namespace goniolux::reflection
