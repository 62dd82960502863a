// Lambert's law: the same radiance in all directions, f = rho / pi. Reciprocal; hemispherical reflectance rho.
#include <algorithm>
#include <cmath>

#include "reflection/directions.h"
#include "reflection/models.h"

namespace goniolux::reflection {
namespace {

class Lambert final : public Bsdf {
 public:
  Lambert(const material::Material& material, const spectrum::SpectralQuadrature& quadrature) : Bsdf({}) {
    for (const double rho : spectrum::atNodes(material.spectra.at("diffuse"), quadrature)) {
      reflectance_.push_back(static_cast<float>(rho));
      overPi_.push_back(static_cast<float>(rho / core::pi));
    }
  }

  void evaluate(const core::Vec3& out, const core::Vec3& in, const Interface&, float* values) const override {
    const bool sameSide = out.z * in.z > 0;
    for (std::size_t k = 0; k < overPi_.size(); ++k) values[k] = sameSide ? overPi_[k] : 0.0f;
  }

  [[nodiscard]] double density(const core::Vec3& out, const core::Vec3& in, const Interface&) const override {
    return out.z * in.z > 0 ? std::abs(in.z) / core::pi : 0;
  }

  // Cosine-distributed directions: f cos / density = rho.
  bool sample(const core::Vec3&, const core::Vec2& u, const Interface&, BsdfSample& chosen,
              float* weight) const override {
    chosen.direction = cosineDirection(u);
    chosen.density = chosen.direction.z / core::pi;
    std::copy(reflectance_.begin(), reflectance_.end(), weight);
    return true;
  }

  void diffuseReflectance(float* values) const override { std::copy(reflectance_.begin(), reflectance_.end(), values); }
  [[nodiscard]] bool isLambertian() const override { return true; }
  [[nodiscard]] double largestReflectance() const override {
    return static_cast<double>(*std::max_element(reflectance_.begin(), reflectance_.end()));
  }

 protected:
  [[nodiscard]] std::size_t nodes() const override { return reflectance_.size(); }

 private:
  std::vector<float> reflectance_, overPi_;
};

}  // namespace

ReflectionModel lambertModel() {
  ReflectionModel model;
  model.name = "lambert";
  model.title = "Perfectly diffuse reflection (Lambert)";
  model.parameters = {
      fraction("diffuse", "spectral reflectance", true, "diffuse reflectance", "J. H. Lambert, Photometria, 1760")};
  model.make = [](const material::Material& m, const spectrum::SpectralQuadrature& q) -> std::unique_ptr<Bsdf> {
    return std::make_unique<Lambert>(m, q);
  };
  return model;
}

}  // namespace goniolux::reflection
