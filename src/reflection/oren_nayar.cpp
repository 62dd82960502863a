// Rough diffuse surfaces (matt paint, plaster, clay): Lambertian facets that shadow and light each other, so that the
// surface looks flatter than Lambert's law and brighter towards the lamp.
//
// The model of M. Oren and S. Nayar (SIGGRAPH 1994) in the form of Y. Fujii, with the light of multiple scattering
// among the facets put back: J. Portsmouth, P. Kutz and S. Hill, "EON: A practical energy-preserving rough diffuse
// BRDF", JCGT 14(1), 2025. Reciprocal; a white surface reflects all light in every direction.
#include <algorithm>
#include <cmath>

#include "reflection/directions.h"
#include "reflection/models.h"

namespace goniolux::reflection {
namespace {

constexpr double c1 = 0.5 - 2 / (3 * core::pi), c2 = 2.0 / 3 - 28 / (15 * core::pi);

class OrenNayar final : public Bsdf {
 public:
  OrenNayar(const material::Material& material, const spectrum::SpectralQuadrature& quadrature) : Bsdf({}) {
    const auto given = material.numbers.find("roughness");
    roughness_ = given == material.numbers.end() ? 0.5 : given->second;
    a_ = 1 / (1 + c1 * roughness_);
    mean_ = a_ * (1 + c2 * roughness_);
    for (const double r : spectrum::atNodes(material.spectra.at("diffuse"), quadrature)) {
      // The reflectance of a single facet that makes the surface reflect r of diffuse light:
      // r = rho mean / (1 - rho (1 - mean)).
      const double rho = r / (mean_ + r * (1 - mean_));
      reflectance_.push_back(static_cast<float>(r));
      single_.push_back(static_cast<float>(rho / core::pi));
      multiple_.push_back(
          static_cast<float>(rho * rho * mean_ / ((1 - rho * (1 - mean_)) * core::pi * std::max(1e-12, 1 - mean_))));
    }
  }

  void evaluate(const core::Vec3& out, const core::Vec3& in, const Interface&, float* values) const override {
    if (out.z <= 0 || in.z <= 0) {
      std::fill_n(values, single_.size(), 0.0f);
      return;
    }
    const double s = glm::dot(out, in) - out.z * in.z;
    const double overT = s > 0 ? s / std::max(out.z, in.z) : s;
    const auto first = static_cast<float>(a_ * (1 + roughness_ * overT));
    const auto lost = static_cast<float>(std::max(0.0, 1 - albedo(out.z)) * std::max(0.0, 1 - albedo(in.z)));
    for (std::size_t k = 0; k < single_.size(); ++k) values[k] = single_[k] * first + multiple_[k] * lost;
  }

  [[nodiscard]] double density(const core::Vec3& out, const core::Vec3& in, const Interface&) const override {
    return out.z > 0 && in.z > 0 ? in.z / core::pi : 0;
  }

  bool sample(const core::Vec3& out, const core::Vec2& u, const Interface& at, BsdfSample& chosen,
              float* weight) const override {
    chosen.direction = cosineDirection(u);
    chosen.density = chosen.direction.z / core::pi;
    evaluate(out, chosen.direction, at, weight);
    for (std::size_t k = 0; k < single_.size(); ++k) weight[k] *= static_cast<float>(core::pi);
    return true;
  }

  [[nodiscard]] double largestReflectance() const override {
    return std::min(
        1.0, static_cast<double>(*std::max_element(reflectance_.begin(), reflectance_.end())) * (1 + roughness_));
  }

 protected:
  [[nodiscard]] std::size_t nodes() const override { return single_.size(); }

 private:
  // Directional albedo of single scattering by white facets.
  [[nodiscard]] double albedo(double mu) const {
    const double sine = std::sqrt(std::max(0.0, 1 - mu * mu));
    const double cube = sine * sine * sine;
    // (1 - sine^3) / mu - without the 0/0 at grazing
    const double overMu = mu > 1e-6 ? sine * (1 - cube) / mu : 1.5 * mu;
    const double g = sine * (std::acos(std::clamp(mu, -1.0, 1.0)) - sine * mu) + 2.0 / 3 * (overMu - sine);
    return a_ + roughness_ * a_ / core::pi * g;
  }

  double roughness_, a_, mean_;
  std::vector<float> reflectance_, single_, multiple_;
};

}  // namespace

ReflectionModel orenNayarModel() {
  ReflectionModel model;
  model.name = "oren-nayar";
  model.title = "Rough diffuse reflection (Oren-Nayar, energy-preserving)";
  model.parameters = {fraction("diffuse", "spectral reflectance", true,
                               "reflectance of diffuse light, as an integrating sphere finds it",
                               "Oren and Nayar 1994; Portsmouth, Kutz and Hill 2025"),
                      plainNumber("roughness", "roughness", 0, 1, "0 = Lambert's law, 1 = very rough; default 0.5")};
  model.make = [](const material::Material& m, const spectrum::SpectralQuadrature& q) -> std::unique_ptr<Bsdf> {
    return std::make_unique<OrenNayar>(m, q);
  };
  return model;
}

}  // namespace goniolux::reflection
