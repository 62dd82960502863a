// Whitted's model as the paper states it:
//   I = k_d sum (N.L)(object colour) + k_s sum (N.H)^n I_j + I_a + k_s I_r + k_t I_t
// As meant and as printed: see phong.cpp.
#include <algorithm>

#include "reflection/paper_models.h"

namespace goniolux::reflection {
namespace {

class Whitted : public PaperShading {
 public:
  using PaperShading::PaperShading;

  void addSource(const core::Vec3& out, const core::Vec3& in, double e, const Interface&,
                 float* values) const override {
    if (in.z <= 0) return;
    const double intensity = asPrinted_ ? e : e / core::pi;
    const auto diffuse = static_cast<float>(in.z * (asPrinted_ ? 1 : intensity));
    const auto highlight = static_cast<float>(halfwayHighlight(out, in, terms_.n) * intensity);
    for (std::size_t i = 0; i < nodes(); ++i) values[i] += terms_.kdRd[i] * diffuse + terms_.ks[i] * highlight;
  }
  void ambientFactor(float* values) const override { ambientColour(values); }
  void reflectedFactor(const core::Vec3&, const Interface&, float* values) const override {
    std::copy(terms_.ks.begin(), terms_.ks.end(), values);
  }
  void transmittedFactor(const core::Vec3&, const Interface&, float* values) const override {
    std::copy(terms_.kt.begin(), terms_.kt.end(), values);
  }
  void attenuate(const Travel&, float*) const override {}  // the model knows no F
};

}  // namespace

ShadingModel whittedModel() {
  return {"whitted", "Whitted's model as in the paper (not for photometric numbers)", paperParameters(),
          makePaperShading<Whitted>};
}

}  // namespace goniolux::reflection
