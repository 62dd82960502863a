// Ideal mirror: all light goes to the mirror direction, times a reflectance that does not depend on the angle.
#include <algorithm>

#include "reflection/models.h"

namespace goniolux::reflection {
namespace {

class Mirror final : public Bsdf {
 public:
  Mirror(const material::Material& material, const spectrum::SpectralQuadrature& quadrature) {
    for (const double rho : spectrum::atNodes(material.spectra.at("reflectance"), quadrature))
      reflectance_.push_back(static_cast<float>(rho));
  }

  void evaluate(const core::Vec3&, const core::Vec3&, float* values) const override {
    std::fill_n(values, reflectance_.size(), 0.0f);
  }

  bool sample(const core::Vec3& out, const core::Vec2&, BsdfSample& chosen, float* weight) const override {
    chosen.direction = {-out.x, -out.y, out.z};
    chosen.specular = true;
    std::copy(reflectance_.begin(), reflectance_.end(), weight);
    return true;
  }

  [[nodiscard]] bool isSpecular() const override { return true; }
  [[nodiscard]] double largestReflectance() const override {
    return *std::max_element(reflectance_.begin(), reflectance_.end());
  }

 private:
  std::vector<float> reflectance_;
};

}  // namespace

ReflectionModel mirrorModel() {
  ReflectionModel model;
  model.name = "mirror";
  model.title = "Ideal mirror";
  core::Parameter reflectance;
  reflectance.key = "reflectance";
  reflectance.title = "specular reflectance";
  reflectance.unit = "1";
  reflectance.kind = core::ParameterKind::spectrum;
  reflectance.required = true;
  reflectance.minimum = 0;
  reflectance.maximum = 1;
  reflectance.help = "regular spectral reflectance, the same at every angle";
  model.parameters = {reflectance};
  model.make = [](const material::Material& m, const spectrum::SpectralQuadrature& q) -> std::unique_ptr<Bsdf> {
    return std::make_unique<Mirror>(m, q);
  };
  return model;
}

}  // namespace goniolux::reflection
