// A point: luminous intensity only, inverse square and cosine law.
#include <cmath>

#include "emitter/opening_emitter.h"

namespace goniolux::emitter {
namespace {

using core::Vec3;

class PointEmitter final : public Emitter {
 public:
  PointEmitter(const Vec3& center, const Output& output) : center_(center), output_(output) {
    // Without a distribution a point is isotropic.
    uniformIntensity_ = output.flux_lm / (4 * core::pi);
  }

  [[nodiscard]] IncidentLight sample(const Vec3& point, const core::Vec2&) const override {
    const Vec3 toSource = center_ - point;
    const double squared = glm::dot(toSource, toSource);
    if (squared == 0) return {};
    const double distance = std::sqrt(squared);
    const Vec3 direction = toSource / distance;
    return {direction, distance, intensity(-direction) / squared};
  }

  [[nodiscard]] Illuminance illuminance(const Vec3& point, const Vec3& normal, double) const override {
    const IncidentLight light = sample(point, {});
    return {light.normalIlluminance * std::max(0.0, glm::dot(light.direction, normal)), 0};
  }

  [[nodiscard]] double luminance(const Vec3&, const Vec3&) const override { return 0; }  // has no surface to be seen
  [[nodiscard]] double importance(const Vec3& point, const Vec3& normal) const override {
    return illuminance(point, normal, 0).value;
  }
  [[nodiscard]] Vec3 aim() const override { return output_.frame.aim; }
  [[nodiscard]] double flux() const override {
    return output_.distribution ? output_.scale * output_.distribution->flux() : output_.flux_lm;
  }
  [[nodiscard]] bool hasClosedForm() const override { return true; }

 private:
  [[nodiscard]] double intensity(const Vec3& direction) const {
    return output_.distribution ? output_.scale * output_.distribution->intensity(output_.frame.toLocal(direction))
                                : uniformIntensity_;
  }

  Vec3 center_;
  Output output_;
  double uniformIntensity_;
};

}  // namespace

std::unique_ptr<Emitter> makePointEmitter(const Vec3& center, const Output& output) {
  return std::make_unique<PointEmitter>(center, output);
}

}  // namespace goniolux::emitter
