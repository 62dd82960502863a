// Flat openings: rectangle and disc perpendicular to the aim, and diffusely emitting triangles. A flat opening emits on
// each side what the distribution sends to that side; without a distribution it has the same luminance on both sides.
#include <algorithm>
#include <array>
#include <cmath>

#include "emitter/lambertian_forms.h"
#include "emitter/opening_emitter.h"
#include "emitter/spherical_rectangle.h"

namespace goniolux::emitter {
namespace {

using core::Vec2;
using core::Vec3;

// Nearer than this many lengths, directions are sampled instead of points: the inverse square would make points noisy.
constexpr double nearLengths = 3;

class FlatOpening : public OpeningEmitter {
 public:
  FlatOpening(const Opening& opening, const Vec3& center, double boundingRadius, double area, const Output& output)
      : OpeningEmitter(center, boundingRadius, output), axis_(axesOf(opening, output.frame).z), area_(area) {
    setEmittingArea(2 * area);
    lambertianFront_ =
        output.distribution && output.distribution->isLambertian() && opening.along == Opening::Along::aim;
    frontLuminance_ = !output.distribution ? uniformLuminance_ : lambertianFront_ ? intensity(axis_) / area : 0;
  }

 protected:
  [[nodiscard]] double projectedArea(const Vec3& direction) const override {
    return area_ * std::abs(glm::dot(axis_, direction));
  }
  // L cos = I / A: the projected area's cosine cancels, so grazing directions stay finite.
  [[nodiscard]] double elementIntensity(const Vec3&, const Vec3& direction) const override {
    return intensity(direction) / area_;
  }
  [[nodiscard]] bool isCentred() const override { return true; }
  /// Luminance of the side that `point` sees, when uniform over directions; negative when it is not.
  [[nodiscard]] double uniformSide(const Vec3& point) const {
    if (!output_.distribution) return uniformLuminance_;
    if (!lambertianFront_) return -1;
    return glm::dot(point - center_, axis_) > 0 ? frontLuminance_ : 0;
  }
  [[nodiscard]] bool hasClosedForm() const override { return lambertianFront_ || !output_.distribution; }

  Vec3 axis_;
  double area_;
  bool lambertianFront_ = false;
  double frontLuminance_ = 0;
};

class RectangleEmitter final : public FlatOpening {
 public:
  RectangleEmitter(const Opening& opening, const Vec3& center, const Output& output)
      : FlatOpening(opening, center, 0.5 * std::hypot(opening.length, opening.width), opening.length * opening.width,
                    output),
        edgeX_(axesOf(opening, output.frame).x * opening.length),
        edgeY_(axesOf(opening, output.frame).y * opening.width),
        corner_(center - 0.5 * edgeX_ - 0.5 * edgeY_),
        size_(std::max(opening.length, opening.width)) {}

  [[nodiscard]] IncidentLight sample(const Vec3& point, const Vec2& u) const override {
    const Vec3 toCenter = center_ - point;
    const double height = std::abs(glm::dot(toCenter, axis_));
    if (glm::dot(toCenter, toCenter) > nearLengths * nearLengths * size_ * size_ || height < 1e-9 * size_)
      return fromElement(point, corner_ + edgeX_ * u.x + edgeY_ * u.y, axis_, 1 / area_);
    const SphericalRectangle rectangle(corner_, edgeX_, edgeY_, point);
    if (!rectangle.isSound()) return fromElement(point, corner_ + edgeX_ * u.x + edgeY_ * u.y, axis_, 1 / area_);
    const Vec3 toElement = rectangle.sample(u) - point;
    const double squared = glm::dot(toElement, toElement), distance = std::sqrt(squared);
    const Vec3 direction = toElement / distance;
    const double cosine = std::abs(glm::dot(direction, axis_));
    if (cosine <= 0) return {};
    return {direction, distance, elementIntensity(axis_, -direction) / cosine * rectangle.solidAngle()};
  }

  [[nodiscard]] Illuminance illuminance(const Vec3& point, const Vec3& normal, double tolerance) const override {
    const double side = uniformSide(point);
    if (side < 0) return OpeningEmitter::illuminance(point, normal, tolerance);
    if (side == 0) return {};
    const std::array<Vec3, 4> corners{corner_, corner_ + edgeX_, corner_ + edgeX_ + edgeY_, corner_ + edgeY_};
    return {side * polygonFactor(corners, point, normal), 0};
  }

 protected:
  [[nodiscard]] int patchCount() const override { return 1; }
  [[nodiscard]] Element element(int, const Vec2& uv, const Vec3&) const override {
    return {corner_ + edgeX_ * uv.x + edgeY_ * uv.y, axis_, area_};
  }

 private:
  Vec3 edgeX_, edgeY_, corner_;
  double size_;
};

// A disc, or an ellipse: the image of the unit disc under the two half axes.
class DiscEmitter final : public FlatOpening {
 public:
  DiscEmitter(const Opening& opening, const Vec3& center, const Output& output)
      : FlatOpening(opening, center, 0.5 * std::max(diametersOf(opening).x, diametersOf(opening).y),
                    0.25 * core::pi * diametersOf(opening).x * diametersOf(opening).y, output),
        x_(axesOf(opening, output.frame).x * (0.5 * diametersOf(opening).x)),
        y_(axesOf(opening, output.frame).y * (0.5 * diametersOf(opening).y)),
        round_(isRound(opening)) {}

  [[nodiscard]] bool hasClosedForm() const override { return round_ && FlatOpening::hasClosedForm(); }

  [[nodiscard]] IncidentLight sample(const Vec3& point, const Vec2& u) const override {
    const Vec3 toCenter = center_ - point;
    const double height = std::abs(glm::dot(toCenter, axis_));
    const double near = nearLengths * 2 * boundingRadius_;
    if (glm::dot(toCenter, toCenter) > near * near || height < 1e-9 * boundingRadius_)
      return fromElement(point, onDisc(u), axis_, 1 / area_);
    // Directions over the rectangle about the disc; what misses the disc carries no light.
    const SphericalRectangle rectangle(center_ - x_ - y_, x_ * 2.0, y_ * 2.0, point);
    if (!rectangle.isSound()) return fromElement(point, onDisc(u), axis_, 1 / area_);
    const Vec3 element = rectangle.sample(u);
    const Vec3 fromCenter = element - center_, toElement = element - point;
    const double a = glm::dot(fromCenter, x_) / glm::dot(x_, x_), b = glm::dot(fromCenter, y_) / glm::dot(y_, y_);
    if (a * a + b * b > 1) return {};
    const double distance = glm::length(toElement);
    const Vec3 direction = toElement / distance;
    const double cosine = std::abs(glm::dot(direction, axis_));
    if (cosine <= 0) return {};
    return {direction, distance, elementIntensity(axis_, -direction) / cosine * rectangle.solidAngle()};
  }

  [[nodiscard]] Illuminance illuminance(const Vec3& point, const Vec3& normal, double tolerance) const override {
    const double side = uniformSide(point);
    if (side == 0) return {};
    if (side > 0 && round_)
      if (const auto factor = discFactor(center_, axis_, boundingRadius_, point, normal)) return {side * *factor, 0};
    return OpeningEmitter::illuminance(point, normal, tolerance);
  }

 protected:
  [[nodiscard]] int patchCount() const override { return 1; }
  // Polar map: smooth in both coordinates, as quadrature likes it.
  [[nodiscard]] Element element(int, const Vec2& uv, const Vec3&) const override {
    const double angle = 2 * core::pi * uv.y;
    return {center_ + (x_ * std::cos(angle) + y_ * std::sin(angle)) * uv.x, axis_, 2 * area_ * uv.x};
  }

 private:
  // Uniform over the disc, keeping neighbours together (Shirley and Chiu, 1997).
  [[nodiscard]] Vec3 onDisc(const Vec2& u) const {
    const double a = 2 * u.x - 1, b = 2 * u.y - 1;
    if (a == 0 && b == 0) return center_;
    const bool wide = std::abs(a) > std::abs(b);
    const double r = wide ? a : b;
    const double angle = wide ? 0.25 * core::pi * (b / a) : 0.5 * core::pi - 0.25 * core::pi * (a / b);
    return center_ + (x_ * std::cos(angle) + y_ * std::sin(angle)) * r;
  }

  Vec3 x_, y_;  // half axes
  bool round_;
};

class TriangleEmitter final : public Emitter {
 public:
  TriangleEmitter(const Vec3& a, const Vec3& b, const Vec3& c, double exitance)
      : corners_{a, b, c}, luminance_(exitance / core::pi) {
    const Vec3 across = glm::cross(b - a, c - a);
    area_ = 0.5 * glm::length(across);
    normal_ = area_ > 0 ? across / (2 * area_) : Vec3(0, 0, 1);
    center_ = (a + b + c) / 3.0;
    radius_ = std::max({glm::length(a - center_), glm::length(b - center_), glm::length(c - center_)});
  }

  [[nodiscard]] IncidentLight sample(const Vec3& point, const Vec2& u) const override {
    const Vec3 toCenter = center_ - point;
    const double height = std::abs(glm::dot(corners_[0] - point, normal_));
    if (height <= 1e-12 * radius_) return {};
    const double far = 2 * nearLengths * radius_;
    if (glm::dot(toCenter, toCenter) > far * far) {
      const double root = std::sqrt(u.x);
      const Vec3 element = corners_[0] * (1 - root) + corners_[1] * (root * (1 - u.y)) + corners_[2] * (root * u.y);
      const Vec3 toElement = element - point;
      const double squared = glm::dot(toElement, toElement), distance = std::sqrt(squared);
      const Vec3 direction = toElement / distance;
      return {direction, distance, luminance_ * std::abs(glm::dot(direction, normal_)) * area_ / squared};
    }
    // Near: uniform over the solid angle.
    double solidAngle = 0;
    const Vec3 direction = sphericalTriangle(point, u, solidAngle);
    const double cosine = std::abs(glm::dot(direction, normal_));
    if (!(solidAngle > 0) || cosine <= 0) return {};
    return {direction, height / cosine, luminance_ * solidAngle};
  }
  [[nodiscard]] Illuminance illuminance(const Vec3& point, const Vec3& normal, double) const override {
    return {luminance_ * polygonFactor(corners_, point, normal), 0};
  }
  [[nodiscard]] double luminance(const Vec3&, const Vec3&) const override { return luminance_; }
  [[nodiscard]] double importance(const Vec3& point, const Vec3& normal) const override {
    const Vec3 toCenter = center_ - point;
    const double distance = std::max(glm::length(toCenter), 1e-12);
    const double cosine = glm::dot(toCenter, normal) / distance, spread = std::min(1.0, radius_ / distance);
    if (cosine <= -spread) return 0;
    const double facing = std::max(cosine, 0.25 * (cosine + spread));
    const double slant = std::max(std::abs(glm::dot(toCenter, normal_)) / distance, 0.1 * spread);
    return luminance_ * slant * facing * area_ / std::max(distance * distance, radius_ * radius_);
  }
  [[nodiscard]] double roughSolidAngle(const Vec3& point) const override {
    const Vec3 toCenter = center_ - point;
    const double distance = std::max(glm::length(toCenter), 1e-12), reach = std::max(distance, 0.5 * radius_);
    return std::min(2 * core::pi, area_ * std::abs(glm::dot(toCenter, normal_)) / distance / (reach * reach));
  }
  [[nodiscard]] Vec3 aim() const override { return normal_; }
  [[nodiscard]] double flux() const override { return 2 * core::pi * luminance_ * area_; }
  [[nodiscard]] bool hasClosedForm() const override { return true; }

 private:
  // J. Arvo, "Stratified Sampling of Spherical Triangles", SIGGRAPH 1995.
  [[nodiscard]] Vec3 sphericalTriangle(const Vec3& point, const Vec2& u, double& solidAngle) const {
    const Vec3 a = glm::normalize(corners_[0] - point), b = glm::normalize(corners_[1] - point),
               c = glm::normalize(corners_[2] - point);
    const auto unit = [](const Vec3& v) {
      const double length = glm::length(v);
      return length > 0 ? v / length : Vec3(0);
    };
    const Vec3 ab = unit(glm::cross(a, b)), bc = unit(glm::cross(b, c)), ca = unit(glm::cross(c, a));
    const auto dihedral = [](const Vec3& p, const Vec3& q) {
      return std::acos(std::clamp(-glm::dot(p, q), -1.0, 1.0));
    };
    const double alpha = dihedral(ca, ab), beta = dihedral(ab, bc), gamma = dihedral(bc, ca);
    solidAngle = alpha + beta + gamma - core::pi;
    if (!(solidAngle > 0)) return a;
    const double part = u.x * solidAngle, s = std::sin(part - alpha), t = std::cos(part - alpha);
    const double sinAlpha = std::sin(alpha), cosAlpha = std::cos(alpha), cosSide = glm::dot(a, b);
    const double p = t - cosAlpha, q = s + sinAlpha * cosSide;
    const double denominator = (q * s + p * t) * sinAlpha;
    const double cosine =
        std::clamp(denominator != 0 ? ((q * t - p * s) * cosAlpha - q) / denominator : 1.0, -1.0, 1.0);
    const Vec3 corner = a * cosine + unit(c - a * glm::dot(c, a)) * std::sqrt(1 - cosine * cosine);
    const double z = 1 - u.y * (1 - glm::dot(corner, b));
    return b * z + unit(corner - b * glm::dot(corner, b)) * std::sqrt(std::max(0.0, 1 - z * z));
  }

  std::array<Vec3, 3> corners_;
  Vec3 normal_, center_;
  double luminance_, area_ = 0, radius_ = 0;
};

}  // namespace

std::unique_ptr<Emitter> makeRectangleEmitter(const Opening& opening, const Vec3& center, const Output& output) {
  return std::make_unique<RectangleEmitter>(opening, center, output);
}

std::unique_ptr<Emitter> makeDiscEmitter(const Opening& opening, const Vec3& center, const Output& output) {
  return std::make_unique<DiscEmitter>(opening, center, output);
}

std::unique_ptr<Emitter> makeTriangleEmitter(const Vec3& a, const Vec3& b, const Vec3& c, double exitance) {
  return std::make_unique<TriangleEmitter>(a, b, c, exitance);
}

}  // namespace goniolux::emitter
