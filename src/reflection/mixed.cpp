// A textured finish: at each place a convex mixture of whole finishes, f = sum of s_i f_i with shares s_i that add up
// to
// 1. So it is reciprocal and conserves energy where its parts do. Parts scatter into all directions (Lobes::single is
// off): mirrors and clear glass have no texture.
#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "reflection/bsdf.h"

namespace goniolux::reflection {
namespace {

using core::Vec2;
using core::Vec3;

Lobes lobesOf(const std::vector<std::unique_ptr<Bsdf>>& parts) {
  Lobes lobes;
  for (const auto& part : parts) {
    lobes.glossy = lobes.glossy || part->lobes().glossy;
    lobes.transmits = lobes.transmits || part->lobes().transmits;
  }
  return lobes;
}

class Mixed final : public Bsdf {
 public:
  Mixed(std::vector<std::unique_ptr<Bsdf>> parts, std::vector<double> shares, std::size_t nodes)
      : Bsdf(lobesOf(parts)), parts_(std::move(parts)), shares_(std::move(shares)), nodes_(nodes) {}

  void evaluate(const Vec3& out, const Vec3& in, const Interface& at, float* values) const override {
    std::fill_n(values, nodes_, 0.0f);
    thread_local std::vector<float> part;
    part.resize(nodes_);
    forParts(at, [&](const Bsdf& bsdf, float share) {
      bsdf.evaluate(out, in, at, part.data());
      for (std::size_t k = 0; k < nodes_; ++k) values[k] += share * part[k];
    });
  }

  [[nodiscard]] double density(const Vec3& out, const Vec3& in, const Interface& at) const override {
    double sum = 0;
    forParts(at, [&](const Bsdf& bsdf, float share) { sum += static_cast<double>(share) * bsdf.density(out, in, at); });
    return sum;
  }

  // A part by its share, a direction by the part; weighted by the whole mixture, so that choosing adds no noise where
  // the parts scatter alike.
  bool sample(const Vec3& out, const Vec2& u, const Interface& at, BsdfSample& chosen, float* weight) const override {
    const Bsdf* part = nullptr;
    double from = 0, width = 0;
    forParts(at, [&](const Bsdf& bsdf, float share) {
      if (part != nullptr && u.x < from + width) return;
      part = &bsdf;
      from += width;
      width = static_cast<double>(share);
    });
    if (part == nullptr || !(width > 0)) return false;
    const double v = std::clamp((u.x - from) / width, 0.0, 0x1.fffffep-1);
    if (!part->sample(out, {v, u.y}, at, chosen, weight)) return false;
    if (allLambertian_) {
      diffuseReflectanceAt(at, weight);
      return true;
    }
    chosen.density = density(out, chosen.direction, at);
    if (!(chosen.density > 0)) return false;
    evaluate(out, chosen.direction, at, weight);
    const auto factor = static_cast<float>(std::abs(chosen.direction.z) / chosen.density);
    for (std::size_t k = 0; k < nodes_; ++k) weight[k] *= factor;
    return true;
  }

  void diffuseReflectance(float* values) const override { diffuseReflectanceAt({}, values); }
  void diffuseReflectanceAt(const Interface& at, float* values) const override {
    std::fill_n(values, nodes_, 0.0f);
    thread_local std::vector<float> part;
    part.resize(nodes_);
    forParts(at, [&](const Bsdf& bsdf, float share) {
      bsdf.diffuseReflectance(part.data());
      for (std::size_t k = 0; k < nodes_; ++k) values[k] += share * part[k];
    });
  }
  [[nodiscard]] bool isLambertian() const override { return allLambertian_; }
  [[nodiscard]] double largestReflectance() const override {
    double largest = 0;
    for (const auto& part : parts_) largest = std::max(largest, part->largestReflectance());
    return largest;
  }

 protected:
  [[nodiscard]] std::size_t nodes() const override { return nodes_; }

 private:
  template <typename Use>
  void forParts(const Interface& at, const Use& use) const {
    if (at.mixture != nullptr) {
      for (std::uint32_t i = 0; i < at.mixture->count; ++i)
        use(*parts_[at.mixture->component[i]], at.mixture->share[i]);
      return;
    }
    for (std::size_t i = 0; i < parts_.size(); ++i)
      if (shares_[i] > 0) use(*parts_[i], static_cast<float>(shares_[i]));
  }

  std::vector<std::unique_ptr<Bsdf>> parts_;
  std::vector<double> shares_;
  std::size_t nodes_;
  bool allLambertian_ =
      std::all_of(parts_.begin(), parts_.end(), [](const auto& part) { return part->isLambertian(); });
};

}  // namespace

std::unique_ptr<Bsdf> makeBsdf(const material::Material& material, const spectrum::SpectralQuadrature& quadrature) {
  if (material.components.empty()) {
    const ReflectionModel* model = findReflectionModel(material.model);
    assert(model != nullptr);  // the project reader refuses unknown models
    return model->make(material, quadrature);
  }
  std::vector<std::unique_ptr<Bsdf>> parts;
  for (const material::Material& component : material.components) parts.push_back(makeBsdf(component, quadrature));
  return std::make_unique<Mixed>(std::move(parts), material.shares, quadrature.wavelengths.size());
}

}  // namespace goniolux::reflection
