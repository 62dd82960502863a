#include "reflection/shading.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "reflection/fresnel.h"
#include "reflection/paper_models.h"
#include "reflection/roughness.h"

namespace goniolux::reflection {
namespace {

using core::Vec3;
using spectrum::SpectralDistribution;

class BsdfShading final : public LocalShading {
 public:
  BsdfShading(std::shared_ptr<const Bsdf> bsdf, std::size_t nodes) : bsdf_(std::move(bsdf)), nodes_(nodes) {}

  void addSource(const Vec3& out, const Vec3& in, double e, const Interface& at, float* values) const override {
    thread_local std::vector<float> f;
    f.resize(nodes_);
    bsdf_->evaluate(out, in, at, f.data());
    const auto factor = static_cast<float>(std::abs(in.z) * e);
    for (std::size_t i = 0; i < nodes_; ++i) values[i] += f[i] * factor;
  }
  void ambientFactor(float* values) const override { bsdf_->diffuseReflectance(values); }
  void reflectedFactor(const Vec3& out, const Interface& at, float* values) const override {
    if (bsdf_->lobes().mirror || !bsdf_->lobes().single) return bsdf_->mirrorReflectance(out.z, values);
    for (std::size_t i = 0; i < nodes_; ++i)
      values[i] =
          static_cast<float>(dielectricReflectance(std::clamp(out.z, 0.0, 1.0), at.beyond(i) / at.here(i)).mean());
  }
  void transmittedFactor(const Vec3& out, const Interface& at, float* values) const override {
    if (bsdf_->lobes().straight) return bsdf_->straightTransmittance(out.z, values);
    reflectedFactor(out, at, values);
    // Radiance, so with the change of the index.
    for (std::size_t i = 0; i < nodes_; ++i) {
      const double index = at.beyond(i) / at.here(i);
      values[i] = transmits() ? (1 - values[i]) / static_cast<float>(index * index) : 0.0f;
    }
  }
  [[nodiscard]] bool isLit() const override { return bsdf_->lobes().spread; }
  [[nodiscard]] bool seesBehind() const override { return bsdf_->lobes().spread && bsdf_->lobes().transmits; }
  [[nodiscard]] bool transmits() const override { return bsdf_->lobes().single && bsdf_->lobes().transmits; }
  [[nodiscard]] bool bends() const override { return !bsdf_->lobes().straight; }
  [[nodiscard]] const Medium* medium() const override { return bsdf_->medium(); }

 protected:
  [[nodiscard]] std::size_t nodes() const override { return nodes_; }

 private:
  std::shared_ptr<const Bsdf> bsdf_;
  std::size_t nodes_;
};

}  // namespace

void LocalShading::attenuate(const Travel& travel, float* values) const {
  if (travel.medium == nullptr || !travel.medium->absorbs) return;
  for (std::size_t i = 0; i < nodes(); ++i)
    values[i] *= std::exp(-travel.medium->attenuation[i] * static_cast<float>(travel.distance));
}

const std::vector<ShadingModel>& shadingModels() {
  static const std::vector<ShadingModel> models = {phongModel(), whittedModel(), hallModel()};
  return models;
}

const ShadingModel* findShadingModel(const std::string& name) {
  const auto& models = shadingModels();
  const auto found = std::find_if(models.begin(), models.end(), [&](const auto& m) { return m.name == name; });
  return found == models.end() ? nullptr : &*found;
}

std::unique_ptr<LocalShading> shadingOf(std::shared_ptr<const Bsdf> bsdf, std::size_t nodes) {
  return std::make_unique<BsdfShading>(std::move(bsdf), nodes);
}

material::Material inPaperTerms(const material::Material& material, const std::string& model) {
  if (findShadingModel(material.model) != nullptr) return material;
  material::Material result = material;
  const auto moved = [&](const char* from, const char* to) {
    const auto found = material.spectra.find(from);
    if (found != material.spectra.end()) result.spectra[to] = found->second;
  };
  const auto flat = [](double value) { return SpectralDistribution::flat(value); };
  if (material.model == "mirror") {
    moved("reflectance", "specular");
    result.spectra["fresnel"] = flat(1);  // R_f: the mirror's reflectance is in k_s, the same at every angle
    result.numbers["gloss"] = 1e4;
  } else if (material.model == "ward") {
    result.spectra["fresnel"] = flat(1);
    const double alpha = std::max(smoothest, roughnessOf(material));
    result.numbers["gloss"] = std::max(0.0, 2 / (alpha * alpha) - 2);
  } else if (material.model == "conductor") {
    result.spectra["specular"] = flat(1);
    const double alpha = std::max(smoothest, roughnessOf(material));
    result.numbers["gloss"] = std::max(0.0, 2 / (alpha * alpha) - 2);
  } else if (material.model == "dielectric") {
    const auto index = material.spectra.find("ior");
    const double n = index == material.spectra.end() ? 1.5 : index->second.continuum(555);
    const auto thickness = material.numbers.find("thickness_m");
    result.numbers["gloss"] = 1e4;
    if (thickness != material.numbers.end()) {  // a pane: straight through, with its reflectance at normal incidence
      result.spectra["ior"] = flat(1);
      result.spectra["fresnel"] = flat(slab(1, n, 0, thickness->second).reflectance);
    }
    const double normal = thickness != material.numbers.end() ? slab(1, n, 0, thickness->second).reflectance
                                                              : dielectricReflectance(1, n).mean();
    // Whitted's coefficients do not depend on the angle; Hall's come with Fresnel's.
    result.spectra["specular"] = flat(model == "hall" ? 1 : normal);
    result.spectra["transmission"] = flat(model == "hall" ? 1 : 1 - normal);
    if (const auto a = material.spectra.find("attenuation_per_m"); a != material.spectra.end()) {
      std::vector<SpectralDistribution::Sample> samples;
      for (int nm = 360; nm <= 830; nm += 5)
        samples.push_back({static_cast<double>(nm), std::exp(-a->second.continuum(nm))});
      result.spectra["transmittance_per_m"] =
          a->second.isFlat() ? flat(std::exp(-a->second.continuum(555)))
                             : SpectralDistribution::sampled(std::move(samples), SpectralDistribution::Outside::hold);
    }
  }
  return result;
}

}  // namespace goniolux::reflection
