// A thin sheet that scatters: paper, lamp shades, opal film, leaves. Light leaves both sides by Lambert's law,
// whichever side it came from. No body: a surface of its own.
#include <algorithm>
#include <cmath>

#include "reflection/directions.h"
#include "reflection/models.h"

namespace goniolux::reflection {
namespace {

class DiffuseTransmission final : public Bsdf {
 public:
  DiffuseTransmission(const material::Material& material, const spectrum::SpectralQuadrature& quadrature)
      : Bsdf({.transmits = true}) {
    const auto reflected = material.spectra.find("diffuse");
    const auto r = reflected == material.spectra.end() ? std::vector<double>(quadrature.wavelengths.size(), 0)
                                                       : spectrum::atNodes(reflected->second, quadrature);
    const auto t = spectrum::atNodes(material.spectra.at("transmission"), quadrature);
    double mostReflected = 0, mostThrough = 0;
    for (std::size_t k = 0; k < r.size(); ++k) {
      reflectance_.push_back(static_cast<float>(r[k]));
      transmittance_.push_back(static_cast<float>(t[k]));
      mostReflected = std::max(mostReflected, r[k]);
      mostThrough = std::max(mostThrough, t[k]);
      largest_ = std::max(largest_, r[k] + t[k]);
    }
    share_ = mostReflected + mostThrough > 0 ? mostReflected / (mostReflected + mostThrough) : 1;
  }

  void evaluate(const core::Vec3& out, const core::Vec3& in, const Interface&, float* values) const override {
    const auto& curve = out.z * in.z > 0 ? reflectance_ : transmittance_;
    const auto overPi = static_cast<float>(1 / core::pi);
    for (std::size_t k = 0; k < curve.size(); ++k) values[k] = curve[k] * overPi;
  }
  [[nodiscard]] double density(const core::Vec3& out, const core::Vec3& in, const Interface&) const override {
    return (out.z * in.z > 0 ? share_ : 1 - share_) * std::abs(in.z) / core::pi;
  }
  bool sample(const core::Vec3&, const core::Vec2& given, const Interface&, BsdfSample& chosen,
              float* weight) const override {
    core::Vec2 u = given;
    const bool reflects = split(share_, u);
    chosen.direction = cosineDirection(u);
    const double p = reflects ? share_ : 1 - share_;
    chosen.density = p * chosen.direction.z / core::pi;
    if (!(chosen.density > 0)) return false;
    if (!reflects) chosen.direction.z = -chosen.direction.z;
    const auto& curve = reflects ? reflectance_ : transmittance_;
    for (std::size_t k = 0; k < curve.size(); ++k) weight[k] = curve[k] / static_cast<float>(p);
    return true;
  }

  void diffuseReflectance(float* values) const override { std::copy(reflectance_.begin(), reflectance_.end(), values); }
  [[nodiscard]] double largestReflectance() const override { return largest_; }

 protected:
  [[nodiscard]] std::size_t nodes() const override { return reflectance_.size(); }

 private:
  std::vector<float> reflectance_, transmittance_;
  double share_ = 1, largest_ = 0;
};

}  // namespace

ReflectionModel diffuseTransmissionModel() {
  ReflectionModel model;
  model.name = "diffuse-transmission";
  model.title = "Thin sheet that scatters light to both sides: paper, lamp shades, opal film";
  model.parameters = {fraction("diffuse", "diffuse reflectance", false, "of either side; default 0"),
                      fraction("transmission", "diffuse transmittance", true, "with the reflectance at most 1")};
  model.complaint = [](const material::Material& m) { return sumComplaint(m, "diffuse", "transmission"); };
  model.make = [](const material::Material& m, const spectrum::SpectralQuadrature& q) -> std::unique_ptr<Bsdf> {
    return std::make_unique<DiffuseTransmission>(m, q);
  };
  return model;
}

}  // namespace goniolux::reflection
