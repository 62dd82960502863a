// Elliptical volumes: ellipsoid and elliptical cylinder (caps included). Each is the image of the unit sphere, or of
// the unit cylinder, under its half axes: what a point sees of it is the image of what the point's original sees,
// because tangent planes stay tangent planes. An element's area grows by det(M) |M^-T n|.
#include <algorithm>
#include <cmath>

#include "emitter/opening_emitter.h"

namespace goniolux::emitter {
namespace {

using core::Vec2;
using core::Vec3;

class EllipticVolume : public OpeningEmitter {
 public:
  EllipticVolume(const Opening& opening, const Vec3& center, const Vec3& half, const Output& output,
                 double boundingRadius)
      : OpeningEmitter(center, boundingRadius, output), axes_(axesOf(opening, output.frame)), half_(half) {}

  // A patch by chance in proportion to its area, then a point of its visible part.
  [[nodiscard]] IncidentLight sample(const Vec3& point, const Vec2& u) const override {
    const double patches = patchCount();
    const int patch = std::min(static_cast<int>(u.x * patches), patchCount() - 1);
    const Element e = element(patch, {u.x * patches - patch, u.y}, point);
    if (e.area == 0) return {};
    return fromElement(point, e.point, e.normal, 1 / (patches * e.area));
  }

 protected:
  [[nodiscard]] Vec3 toUnit(const Vec3& world) const {
    const Vec3 d = world - center_;
    return {glm::dot(d, axes_.x) / half_.x, glm::dot(d, axes_.y) / half_.y, glm::dot(d, axes_.z) / half_.z};
  }
  [[nodiscard]] Vec3 components(const Vec3& world) const {
    return {glm::dot(world, axes_.x), glm::dot(world, axes_.y), glm::dot(world, axes_.z)};
  }
  // The element at a unit-space place with unit normal and area there.
  [[nodiscard]] Element mapped(const Vec3& place, const Vec3& normal, double area) const {
    const Vec3 stretched = normal / half_;
    const double length = glm::length(stretched);
    return {center_ + axes_.x * (place.x * half_.x) + axes_.y * (place.y * half_.y) + axes_.z * (place.z * half_.z),
            (axes_.x * stretched.x + axes_.y * stretched.y + axes_.z * stretched.z) / length,
            area * half_.x * half_.y * half_.z * length};
  }

  OpeningAxes axes_;
  Vec3 half_;
};

class EllipsoidEmitter final : public EllipticVolume {
 public:
  EllipsoidEmitter(const Opening& opening, const Vec3& center, const Output& output)
      : EllipticVolume(opening, center, 0.5 * diametersOf(opening), output,
                       0.5 * std::max({diametersOf(opening).x, diametersOf(opening).y, diametersOf(opening).z})) {
    // The surface area of an ellipsoid has no elementary form: the mean projected area is a quarter of it (Cauchy).
    constexpr int rings = 64;
    double mean = 0;
    for (int i = 0; i < rings; ++i)
      for (int j = 0; j < 2 * rings; ++j) {
        const double z = 1 - (2 * i + 1.0) / rings, phi = core::pi * (j + 0.5) / rings, s = std::sqrt(1 - z * z);
        mean += projected({s * std::cos(phi), s * std::sin(phi), z}) / (2.0 * rings * rings);
      }
    setEmittingArea(4 * mean);
  }

 protected:
  [[nodiscard]] double projectedArea(const Vec3& direction) const override { return projected(components(direction)); }
  [[nodiscard]] int patchCount() const override { return 1; }
  // The cap that the point sees, as SphereEmitter has it, in unit space.
  [[nodiscard]] Element element(int, const Vec2& uv, const Vec3& point) const override {
    const Vec3 toPoint = toUnit(point);
    const double distance = glm::length(toPoint);
    if (distance <= 1) return {};
    const Vec3 axis = toPoint / distance;
    Vec3 x, y;
    core::perpendiculars(axis, x, y);
    const double rim = 1 - 1 / distance;
    const double cosine = 1 - rim * uv.x * uv.x, sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
    const double angle = 2 * core::pi * uv.y;
    const Vec3 normal = axis * cosine + (x * std::cos(angle) + y * std::sin(angle)) * sine;
    return mapped(normal, normal, 2 * core::pi * rim * 2 * uv.x);
  }

 private:
  [[nodiscard]] double projected(const Vec3& d) const {
    const Vec3 h = half_;
    return core::pi * glm::length(Vec3(h.y * h.z * d.x, h.x * h.z * d.y, h.x * h.y * d.z));
  }
};

class EllipticCylinderEmitter final : public EllipticVolume {
 public:
  EllipticCylinderEmitter(const Opening& opening, const Vec3& center, const Output& output)
      : EllipticVolume(opening, center,
                       {0.5 * diametersOf(opening).x, 0.5 * diametersOf(opening).y, 0.5 * opening.height}, output,
                       0.5 * std::hypot(opening.height, std::max(diametersOf(opening).x, diametersOf(opening).y))) {
    // Perimeter of an ellipse by Ramanujan's second formula (relative error below 1e-9 up to 5:1, 4e-4 at a line).
    const double a = half_.x, b = half_.y, h = (a - b) * (a - b) / ((a + b) * (a + b));
    const double perimeter = core::pi * (a + b) * (1 + 3 * h / (10 + std::sqrt(4 - 3 * h)));
    setEmittingArea(perimeter * 2 * half_.z + 2 * core::pi * a * b);
  }

 protected:
  [[nodiscard]] double projectedArea(const Vec3& direction) const override {
    const Vec3 d = components(direction), h = half_;
    return 4 * h.z * std::hypot(h.y * d.x, h.x * d.y) + core::pi * h.x * h.y * std::abs(d.z);
  }
  [[nodiscard]] int patchCount() const override { return 2; }
  // Patch 0: the arc of the side that faces the point; patch 1: the cap that faces it.
  [[nodiscard]] Element element(int patch, const Vec2& uv, const Vec3& point) const override {
    const Vec3 p = toUnit(point);
    const double sideways = std::hypot(p.x, p.y);
    if (patch == 0) {
      if (sideways <= 1) return {};
      const double visible = std::acos(1 / sideways), phi = std::atan2(p.y, p.x) + visible * (2 * uv.y - 1);
      const Vec3 normal(std::cos(phi), std::sin(phi), 0);
      return mapped({normal.x, normal.y, 2 * uv.x - 1}, normal, 2 * 2 * visible);
    }
    if (std::abs(p.z) <= 1) return {};
    const double phi = 2 * core::pi * uv.y, top = p.z > 0 ? 1 : -1;
    return mapped({uv.x * std::cos(phi), uv.x * std::sin(phi), top}, {0, 0, top}, 2 * core::pi * uv.x);
  }
};

}  // namespace

std::unique_ptr<Emitter> makeEllipsoidEmitter(const Opening& opening, const Vec3& center, const Output& output) {
  return std::make_unique<EllipsoidEmitter>(opening, center, output);
}

std::unique_ptr<Emitter> makeEllipticCylinderEmitter(const Opening& opening, const Vec3& center, const Output& output) {
  return std::make_unique<EllipticCylinderEmitter>(opening, center, output);
}

}  // namespace goniolux::emitter
