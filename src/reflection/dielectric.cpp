// Smooth glass, water, plastics: Fresnel reflection and Snell's refraction at the surface of a closed shape, with
// Bouguer's absorption inside (docs/methods/reflection.md); or, with a thickness, a pane on a single surface.
//
// The index may depend on the wavelength: refracted rays then carry the light of one node (Interface::hero).
#include <algorithm>
#include <cmath>
#include <utility>

#include "reflection/directions.h"
#include "reflection/fresnel.h"
#include "reflection/index_of_refraction.h"
#include "reflection/models.h"
#include "reflection/rough_dielectric.h"
#include "reflection/roughness.h"

namespace goniolux::reflection {
namespace {

class Dielectric final : public Bsdf {
 public:
  explicit Dielectric(Medium medium)
      : Bsdf({.spread = false, .single = true, .transmits = true}), medium_(std::move(medium)) {}

  void evaluate(const core::Vec3&, const core::Vec3&, const Interface&, float* values) const override {
    std::fill_n(values, medium_.index.size(), 0.0f);
  }
  [[nodiscard]] double density(const core::Vec3&, const core::Vec3&, const Interface&) const override { return 0; }

  bool sample(const core::Vec3& out, const core::Vec2& u, const Interface& at, BsdfSample& chosen,
              float* weight) const override {
    const std::size_t count = medium_.index.size(), hero = at.hero;
    const double cosine = std::clamp(out.z, 0.0, 1.0);
    const double index = at.beyond(hero) / at.here(hero);
    const double reflected = dielectricReflectance(cosine, index).mean();
    const auto reflectanceAt = [&](std::size_t k) {
      return dielectricReflectance(cosine, at.beyond(k) / at.here(k)).mean();
    };
    chosen.specular = true;
    if (u.x < reflected) {
      chosen.direction = {-out.x, -out.y, out.z};
      chosen.density = reflected;
      for (std::size_t k = 0; k < count; ++k) weight[k] = static_cast<float>(reflectanceAt(k) / reflected);
      return true;
    }
    const double refracted = refractedCosine(cosine, index);
    if (refracted <= 0) return false;
    chosen.direction = {-out.x / index, -out.y / index, -refracted};
    chosen.density = 1 - reflected;
    chosen.scale = 1 / (index * index);
    for (std::size_t k = 0; k < count; ++k) {
      const bool goesAlong = at.beyond(k) / at.here(k) == index;
      chosen.dispersed = chosen.dispersed || !goesAlong;
      weight[k] = goesAlong ? static_cast<float>(chosen.scale) : 0.0f;
    }
    return true;
  }

  [[nodiscard]] const Medium* medium() const override { return &medium_; }
  [[nodiscard]] double largestReflectance() const override { return 1; }

 protected:
  [[nodiscard]] std::size_t nodes() const override { return medium_.index.size(); }

 private:
  Medium medium_;
};

class ThinPane final : public Bsdf {
 public:
  ThinPane(Medium medium, double thickness)
      : Bsdf({.spread = false, .single = true, .transmits = true, .straight = true, .mirror = true, .angular = true}),
        medium_(std::move(medium)),
        thickness_(thickness) {}

  void evaluate(const core::Vec3&, const core::Vec3&, const Interface&, float* values) const override {
    std::fill_n(values, medium_.index.size(), 0.0f);
  }
  [[nodiscard]] double density(const core::Vec3&, const core::Vec3&, const Interface&) const override { return 0; }

  bool sample(const core::Vec3& out, const core::Vec2& u, const Interface& at, BsdfSample& chosen,
              float* weight) const override {
    const double cosine = std::clamp(out.z, 0.0, 1.0);
    const Slab decides = paneAt(cosine, at.hero);
    const double sum = decides.reflectance + decides.transmittance;
    if (!(sum > 0)) return false;
    const double reflected = decides.reflectance / sum;
    const bool reflects = u.x < reflected;
    chosen.specular = true;
    chosen.straight = !reflects;
    chosen.direction = reflects ? core::Vec3(-out.x, -out.y, out.z) : -out;
    chosen.density = reflects ? reflected : 1 - reflected;
    reflects ? mirrorReflectance(cosine, weight) : straightTransmittance(cosine, weight);
    for (std::size_t k = 0; k < nodes(); ++k)
      weight[k] = static_cast<float>(static_cast<double>(weight[k]) / chosen.density);
    return true;
  }

  void mirrorReflectance(double cosine, float* values) const override {
    forNodes(values, [&](std::size_t k) { return paneAt(cosine, k).reflectance; });
  }
  void straightTransmittance(double cosine, float* values) const override {
    forNodes(values, [&](std::size_t k) { return paneAt(cosine, k).transmittance; });
  }
  [[nodiscard]] double largestReflectance() const override { return 1; }

 protected:
  [[nodiscard]] std::size_t nodes() const override { return medium_.index.size(); }

 private:
  [[nodiscard]] Slab paneAt(double cosine, std::size_t k) const {
    return slab(cosine, static_cast<double>(medium_.index[k]), static_cast<double>(medium_.attenuation[k]), thickness_);
  }
  // A pane without colour is one calculation, not one for each node.
  template <typename Value>
  void forNodes(float* values, const Value& value) const {
    for (std::size_t k = 0; k < nodes(); ++k) {
      const bool same =
          k > 0 && medium_.index[k] == medium_.index[k - 1] && medium_.attenuation[k] == medium_.attenuation[k - 1];
      values[k] = same ? values[k - 1] : static_cast<float>(value(k));
    }
  }

  Medium medium_;
  double thickness_;
};

}  // namespace

ReflectionModel dielectricModel() {
  ReflectionModel model;
  model.name = "dielectric";
  model.title = "Transparent: glass, water, smooth or rough (GGX); a pane where a thickness is given";
  core::Parameter attenuation;
  attenuation.key = "attenuation_per_m";
  attenuation.title = "attenuation coefficient";
  attenuation.unit = "1/m";
  attenuation.kind = core::ParameterKind::spectrum;
  attenuation.minimum = 0;
  attenuation.help = "Bouguer's law, per metre, whatever the units; default 0";
  model.parameters = {refractiveIndex("ior", false, "refractive index; default 1.5"), attenuation,
                      plainNumber("thickness_m", "thickness", 0, 1, "of a thin pane on one surface, in metres")};
  model.parameters.back().minimumIsAllowed = false;
  model.parameters.back().unit = "m";
  for (auto& parameter : roughnessParameters("default 0: smooth")) model.parameters.push_back(parameter);
  model.complaint = [](const material::Material& m) -> std::string {
    if (m.numbers.count("thickness_m") > 0 && roughnessOf(m) > 0)
      return "a pane with \"thickness_m\" is smooth; leave the roughness out, or make the glass a closed shape";
    return roughnessComplaint(m);
  };
  model.make = [](const material::Material& m, const spectrum::SpectralQuadrature& q) -> std::unique_ptr<Bsdf> {
    Medium medium = mediumOf(m, q);
    const auto thickness = m.numbers.find("thickness_m");
    if (thickness != m.numbers.end()) return std::make_unique<ThinPane>(std::move(medium), thickness->second);
    if (const double alpha = roughnessOf(m); alpha >= smoothest) return makeRoughDielectric(std::move(medium), alpha);
    return std::make_unique<Dielectric>(std::move(medium));
  };
  return model;
}

}  // namespace goniolux::reflection
