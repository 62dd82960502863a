// Ideal mirror: all light goes to the mirror direction, times a reflectance that does not depend on the angle.
#include <algorithm>

#include "reflection/models.h"

namespace goniolux::reflection {
namespace {

class Mirror final : public Bsdf {
 public:
  Mirror(const material::Material& material, const spectrum::SpectralQuadrature& quadrature)
      : Bsdf({.spread = false, .single = true, .mirror = true}) {
    for (const double rho : spectrum::atNodes(material.spectra.at("reflectance"), quadrature))
      reflectance_.push_back(static_cast<float>(rho));
  }

  void evaluate(const core::Vec3&, const core::Vec3&, const Interface&, float* values) const override {
    std::fill_n(values, reflectance_.size(), 0.0f);
  }
  [[nodiscard]] double density(const core::Vec3&, const core::Vec3&, const Interface&) const override { return 0; }

  bool sample(const core::Vec3& out, const core::Vec2&, const Interface&, BsdfSample& chosen,
              float* weight) const override {
    chosen.direction = {-out.x, -out.y, out.z};
    chosen.specular = true;
    chosen.density = 1;
    std::copy(reflectance_.begin(), reflectance_.end(), weight);
    return true;
  }

  void mirrorReflectance(double, float* values) const override {
    std::copy(reflectance_.begin(), reflectance_.end(), values);
  }
  [[nodiscard]] double largestReflectance() const override {
    return static_cast<double>(*std::max_element(reflectance_.begin(), reflectance_.end()));
  }

 protected:
  [[nodiscard]] std::size_t nodes() const override { return reflectance_.size(); }

 private:
  std::vector<float> reflectance_;
};

}  // namespace

ReflectionModel mirrorModel() {
  ReflectionModel model;
  model.name = "mirror";
  model.title = "Ideal mirror";
  model.parameters = {
      fraction("reflectance", "specular reflectance", true, "regular spectral reflectance, the same at every angle")};
  model.make = [](const material::Material& m, const spectrum::SpectralQuadrature& q) -> std::unique_ptr<Bsdf> {
    return std::make_unique<Mirror>(m, q);
  };
  return model;
}

}  // namespace goniolux::reflection
