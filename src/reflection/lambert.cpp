// Lambert's law: the same radiance in all directions, f = rho / pi. Reciprocal; hemispherical reflectance rho.
#include <algorithm>
#include <cmath>

#include "reflection/models.h"

namespace goniolux::reflection {
namespace {

class Lambert final : public Bsdf {
 public:
  Lambert(const material::Material& material, const spectrum::SpectralQuadrature& quadrature) {
    for (const double rho : spectrum::atNodes(material.spectra.at("diffuse"), quadrature)) {
      reflectance_.push_back(static_cast<float>(rho));
      overPi_.push_back(static_cast<float>(rho / core::pi));
    }
  }

  void evaluate(const core::Vec3& out, const core::Vec3& in, float* values) const override {
    const bool sameSide = out.z * in.z > 0;
    for (std::size_t k = 0; k < overPi_.size(); ++k) values[k] = sameSide ? overPi_[k] : 0.0f;
  }

  // Cosine-distributed directions (Malley): f cos / density = rho.
  bool sample(const core::Vec3&, const core::Vec2& u, BsdfSample& chosen, float* weight) const override {
    const double r = std::sqrt(u.x), angle = 2 * core::pi * u.y;
    chosen.direction = {r * std::cos(angle), r * std::sin(angle), std::sqrt(std::max(0.0, 1 - u.x))};
    chosen.specular = false;
    std::copy(reflectance_.begin(), reflectance_.end(), weight);
    return true;
  }

  [[nodiscard]] double largestReflectance() const override {
    return *std::max_element(reflectance_.begin(), reflectance_.end());
  }

 private:
  std::vector<float> reflectance_, overPi_;
};

}  // namespace

ReflectionModel lambertModel() {
  ReflectionModel model;
  model.name = "lambert";
  model.title = "Perfectly diffuse reflection (Lambert)";
  core::Parameter diffuse;
  diffuse.key = "diffuse";
  diffuse.title = "spectral reflectance";
  diffuse.unit = "1";
  diffuse.kind = core::ParameterKind::spectrum;
  diffuse.required = true;
  diffuse.minimum = 0;
  diffuse.maximum = 1;
  diffuse.help = "hemispherical spectral reflectance rho(lambda)";
  diffuse.source = "J. H. Lambert, Photometria, 1760";
  model.parameters = {diffuse};
  model.make = [](const material::Material& m, const spectrum::SpectralQuadrature& q) -> std::unique_ptr<Bsdf> {
    return std::make_unique<Lambert>(m, q);
  };
  return model;
}

}  // namespace goniolux::reflection
