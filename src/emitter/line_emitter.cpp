// A line: every element of its length has the distribution's shape, I(d)/length per metre; it has no geometry. Without
// a distribution it is a thin diffuse tube: I(d) = I_perp sin(angle to the line), flux = pi^2 I_perp.
#include <algorithm>
#include <cmath>

#include "emitter/opening_emitter.h"
#include "emitter/quadrature.h"

namespace goniolux::emitter {
namespace {

using core::Vec3;

class LineEmitter final : public OpeningEmitter {
 public:
  LineEmitter(const Opening& opening, const Vec3& center, const Output& output)
      : OpeningEmitter(center, 0.5 * opening.length, output),
        axis_(glm::normalize(opening.axis)),
        length_(opening.length) {
    // projectedArea is sin(angle), as if the line were 1 m2 across; uniformLuminance_ is then I_perp = flux / pi^2.
    setEmittingArea(core::pi);
  }

  // Equiangular as seen from the point: constant for a far element's inverse square.
  [[nodiscard]] IncidentLight sample(const Vec3& point, const core::Vec2& u) const override {
    const Span span = look(point);
    const double angle = span.from + (span.to - span.from) * u.x;
    const double z = std::clamp(span.along + span.distance * std::tan(angle), -0.5 * length_, 0.5 * length_);
    const Vec3 toElement = center_ + axis_ * z - point;
    const double squared = glm::dot(toElement, toElement);
    if (squared == 0) return {};
    const double distance = std::sqrt(squared);
    const Vec3 direction = toElement / distance;
    // (I / length) / squared / pdf, with pdf = distance / ((to - from) squared) along the line
    return {direction, distance, intensity(-direction) / length_ * (span.to - span.from) / span.distance};
  }

  [[nodiscard]] double roughSolidAngle(const Vec3&) const override { return 0; }

  [[nodiscard]] Illuminance illuminance(const Vec3& point, const Vec3& normal, double tolerance) const override {
    if (const auto far = fromCentre(point, normal, tolerance)) return *far;
    const QuadratureResult sum = integrateSquare(
        [&](const core::Vec2& u) {
          const IncidentLight light = sample(point, u);
          return light.normalIlluminance * std::max(0.0, glm::dot(light.direction, normal));
        },
        tolerance);
    return {sum.value, sum.bound};
  }
  [[nodiscard]] double luminance(const Vec3&, const Vec3&) const override { return 0; }  // has no surface to be seen

 protected:
  [[nodiscard]] bool isCentred() const override { return true; }
  [[nodiscard]] double projectedArea(const Vec3& direction) const override {
    const double cosine = std::min(1.0, std::abs(glm::dot(axis_, direction)));
    return std::sqrt(1 - cosine * cosine);
  }
  [[nodiscard]] int patchCount() const override { return 0; }
  [[nodiscard]] Element element(int, const core::Vec2&, const Vec3&) const override { return {}; }

 private:
  struct Span {
    double along, distance, from, to;
  };
  [[nodiscard]] Span look(const Vec3& point) const {
    const Vec3 d = point - center_;
    const double along = glm::dot(d, axis_);
    const double distance = std::max(glm::length(d - axis_ * along), 1e-9 * length_);
    return {along, distance, std::atan2(-0.5 * length_ - along, distance), std::atan2(0.5 * length_ - along, distance)};
  }

  Vec3 axis_;
  double length_;
};

}  // namespace

std::unique_ptr<Emitter> makeLineEmitter(const Opening& opening, const Vec3& center, const Output& output) {
  return std::make_unique<LineEmitter>(opening, center, output);
}

}  // namespace goniolux::emitter
