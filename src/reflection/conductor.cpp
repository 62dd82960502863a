// Metals: Fresnel reflection with a complex refractive index, smooth or rough (GGX microfacets).
//
// Rough: single scattering at the facets, plus a lobe that returns the light of multiple scattering, coloured by the
// metal: C. Kulla and A. Conty, "Revisiting Physically Based Shading at Imageworks", SIGGRAPH course 2017. Without it a
// white surface of alpha 1 loses 69 % of what arrives at normal incidence.
#include <algorithm>
#include <cmath>
#include <utility>

#include "reflection/directions.h"
#include "reflection/fresnel.h"
#include "reflection/ggx.h"
#include "reflection/index_of_refraction.h"
#include "reflection/models.h"
#include "reflection/roughness.h"

namespace goniolux::reflection {
namespace {

using core::Vec3;

struct Metal {
  std::vector<float> n, k;
  std::vector<float> mean;  ///< reflectance of diffuse light

  void reflectance(double cosine, float* values) const {
    for (std::size_t i = 0; i < n.size(); ++i)
      values[i] = i > 0 && n[i] == n[i - 1] && k[i] == k[i - 1]
                      ? values[i - 1]
                      : static_cast<float>(
                            conductorReflectance(cosine, static_cast<double>(n[i]), static_cast<double>(k[i])).mean());
  }
};

class SmoothConductor final : public Bsdf {
 public:
  explicit SmoothConductor(Metal metal)
      : Bsdf({.spread = false, .single = true, .mirror = true, .angular = true}), metal_(std::move(metal)) {}

  void evaluate(const Vec3&, const Vec3&, const Interface&, float* values) const override {
    std::fill_n(values, nodes(), 0.0f);
  }
  [[nodiscard]] double density(const Vec3&, const Vec3&, const Interface&) const override { return 0; }
  bool sample(const Vec3& out, const core::Vec2&, const Interface&, BsdfSample& chosen, float* weight) const override {
    chosen.direction = {-out.x, -out.y, out.z};
    chosen.specular = true;
    chosen.density = 1;
    metal_.reflectance(out.z, weight);
    return true;
  }
  void mirrorReflectance(double cosine, float* values) const override { metal_.reflectance(cosine, values); }
  [[nodiscard]] double largestReflectance() const override { return 1; }

 protected:
  [[nodiscard]] std::size_t nodes() const override { return metal_.n.size(); }

 private:
  Metal metal_;
};

class RoughConductor final : public Bsdf {
 public:
  RoughConductor(Metal metal, double alpha)
      : Bsdf({.glossy = alpha < 0.8}), metal_(std::move(metal)), ggx_(alpha), albedo_(reflectionAlbedo(ggx_)) {
    const double lost = std::max(1e-9, 1 - albedo_.mean());
    for (const float f : metal_.mean) {
      const double mean = static_cast<double>(f);
      const double again = mean * mean * albedo_.mean() / (1 - mean * (1 - albedo_.mean()));
      multiple_.push_back(static_cast<float>(again / (core::pi * lost)));
    }
  }

  void evaluate(const Vec3& out, const Vec3& in, const Interface&, float* values) const override {
    if (out.z <= 0 || in.z <= 0) {
      std::fill_n(values, nodes(), 0.0f);
      return;
    }
    const Vec3 h = glm::normalize(out + in);
    const double cosine = std::clamp(glm::dot(out, h), 0.0, 1.0);
    metal_.reflectance(cosine, values);
    const auto single =
        static_cast<float>(ggx_.normals(h.z) * ggx_.seenBoth(out.z, in.z) / std::max(1e-30, 4 * out.z * in.z));
    const auto lost = static_cast<float>((1 - albedo_.value(out.z)) * (1 - albedo_.value(in.z)));
    for (std::size_t k = 0; k < multiple_.size(); ++k) values[k] = values[k] * single + multiple_[k] * lost;
  }

  [[nodiscard]] double density(const Vec3& out, const Vec3& in, const Interface&) const override {
    if (out.z <= 0 || in.z <= 0) return 0;
    const Vec3 h = glm::normalize(out + in);
    const double facing = glm::dot(out, h);
    if (facing <= 0) return 0;
    const double first = firstShare(out.z);
    return first * ggx_.visibleDensity(out, h) / (4 * facing) + (1 - first) * in.z / core::pi;
  }

  bool sample(const Vec3& out, const core::Vec2& given, const Interface& at, BsdfSample& chosen,
              float* weight) const override {
    core::Vec2 u = given;
    if (out.z <= 0) return false;
    if (split(firstShare(out.z), u)) {
      const Vec3 h = ggx_.visibleNormal(out, u);
      chosen.direction = h * (2 * glm::dot(out, h)) - out;
    } else {
      chosen.direction = cosineDirection(u);
    }
    if (chosen.direction.z <= 0) return false;
    chosen.density = density(out, chosen.direction, at);
    if (!(chosen.density > 0)) return false;
    evaluate(out, chosen.direction, at, weight);
    const auto scale = static_cast<float>(chosen.direction.z / chosen.density);
    for (std::size_t k = 0; k < nodes(); ++k) weight[k] *= scale;
    return true;
  }

  [[nodiscard]] double largestReflectance() const override { return 1; }

 protected:
  [[nodiscard]] std::size_t nodes() const override { return metal_.n.size(); }

 private:
  [[nodiscard]] double firstShare(double cosine) const { return std::clamp(albedo_.value(cosine), 0.05, 1.0); }

  Metal metal_;
  Ggx ggx_;
  AlbedoTable albedo_;
  std::vector<float> multiple_;
};

Metal metalOf(const material::Material& material, const spectrum::SpectralQuadrature& quadrature) {
  Metal metal;
  metal.n = indexAtNodes(material.spectra.at("ior"), quadrature);
  const auto k = material.spectra.find("k");
  metal.k =
      k == material.spectra.end() ? std::vector<float>(metal.n.size(), 0.0f) : indexAtNodes(k->second, quadrature);
  for (std::size_t i = 0; i < metal.n.size(); ++i) {
    const bool same = i > 0 && metal.n[i] == metal.n[i - 1] && metal.k[i] == metal.k[i - 1];
    metal.mean.push_back(same ? metal.mean.back()
                              : static_cast<float>(diffuseConductorReflectance(static_cast<double>(metal.n[i]),
                                                                               static_cast<double>(metal.k[i]))));
  }
  return metal;
}

}  // namespace

ReflectionModel conductorModel() {
  ReflectionModel model;
  model.name = "conductor";
  model.title = "Metal, smooth or rough (GGX)";
  core::Parameter k;
  k.key = "k";
  k.title = "extinction coefficient";
  k.unit = "1";
  k.kind = core::ParameterKind::spectrum;
  k.minimum = 0;
  k.help = "imaginary part of the index, where \"ior\" is no .nk file; default 0";
  model.parameters = {refractiveIndex("ior", true, "n and k from an .nk file; or n"), k};
  for (auto& parameter : roughnessParameters("default 0: a mirror of metal")) model.parameters.push_back(parameter);
  model.complaint = [](const material::Material& m) { return roughnessComplaint(m); };
  model.make = [](const material::Material& m, const spectrum::SpectralQuadrature& q) -> std::unique_ptr<Bsdf> {
    const double alpha = roughnessOf(m);
    if (alpha < smoothest) return std::make_unique<SmoothConductor>(metalOf(m, q));
    return std::make_unique<RoughConductor>(metalOf(m, q), alpha);
  };
  return model;
}

}  // namespace goniolux::reflection
