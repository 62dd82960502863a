// Phong's model as the paper states it:
//   I = k_d sum (N.L)(object colour) + k_s sum (R.V)^n I_j + I_a
// As meant, the diffuse sum has I_j and the ambient term the object's colour, with I_j = E / pi: the diffuse sum is
// then Lambert's law. As printed, both are missing and I_j = E.
#include <algorithm>

#include "reflection/paper_models.h"

namespace goniolux::reflection {
namespace {

class Phong : public PaperShading {
 public:
  using PaperShading::PaperShading;

  void addSource(const core::Vec3& out, const core::Vec3& in, double e, const Interface&,
                 float* values) const override {
    if (in.z <= 0) return;
    const double intensity = asPrinted_ ? e : e / core::pi;
    const auto diffuse = static_cast<float>(in.z * (asPrinted_ ? 1 : intensity));
    const auto highlight = static_cast<float>(mirrorHighlight(out, in, terms_.n) * intensity);
    for (std::size_t i = 0; i < nodes(); ++i) values[i] += terms_.kdRd[i] * diffuse + terms_.ks[i] * highlight;
  }
  void ambientFactor(float* values) const override { ambientColour(values); }
  // No global terms.
  void reflectedFactor(const core::Vec3&, const Interface&, float* values) const override { none(values); }
  void transmittedFactor(const core::Vec3&, const Interface&, float* values) const override { none(values); }
};

}  // namespace

ShadingModel phongModel() {
  return {"phong", "Phong's model as in the paper (not for photometric numbers)", paperParameters(),
          makePaperShading<Phong>};
}

}  // namespace goniolux::reflection
