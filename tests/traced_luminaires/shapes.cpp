#include "traced_luminaires/shapes.h"

#include <cmath>

#include "geometry/placement.h"

namespace goniolux::traced {

using core::Vec2;
using core::Vec3;
using geometry::Shape;

Shape turned(const std::vector<Vec2>& profile) {
  Shape shape;
  shape.partNames = {"all"};
  for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
    const Vec2 &a = profile[i], &b = profile[i + 1];
    const Vec3 base(0, 0, a.y), top(0, 0, b.y);
    shape.patches.push_back(a.x == b.x ? geometry::makeCylinderPatch(base, top, a.x, 0)
                                       : geometry::makeConePatch(base, top, a.x, b.x, 0));
  }
  return shape;
}

Shape disc(const Vec3& center, double radius) {
  Shape shape;
  shape.partNames = {"all"};
  shape.patches.push_back(geometry::makeDiscPatch(center, {0, 0, 1}, radius, 0));
  return shape;
}

Shape quads(const std::vector<Vec3>& corners) {
  Shape shape;
  shape.partNames = {"all"};
  for (std::size_t i = 0; i + 3 < corners.size(); i += 4) {
    const auto first = static_cast<std::uint32_t>(shape.mesh.vertices.size());
    for (std::size_t k = 0; k < 4; ++k) shape.mesh.vertices.push_back(corners[i + k]);
    shape.mesh.triangles.push_back({first, first + 1, first + 2});
    shape.mesh.triangles.push_back({first, first + 2, first + 3});
    shape.mesh.parts.insert(shape.mesh.parts.end(), {0, 0});
  }
  return shape;
}

Shape rectangle(const Vec3& center, const Vec3& u, const Vec3& v) {
  return quads({center - u - v, center + u - v, center + u + v, center - u + v});
}

Shape trough(const std::vector<Vec2>& profile, double length, bool alongY, bool ends) {
  const double half = 0.5 * length;
  const auto at = [&](const Vec2& p, double along) { return alongY ? Vec3(p.x, along, p.y) : Vec3(along, p.x, p.y); };
  std::vector<Vec3> corners;
  for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
    corners.insert(corners.end(),
                   {at(profile[i], -half), at(profile[i + 1], -half), at(profile[i + 1], half), at(profile[i], half)});
    if (!ends) continue;
    for (const double along : {-half, half})
      corners.insert(corners.end(), {at(profile[i], along), at(profile[i + 1], along), at({profile[i + 1].x, 0}, along),
                                     at({profile[i].x, 0}, along)});
  }
  return quads(corners);
}

Shape tube(const Vec3& center, const Vec3& axis, double length, double diameter) {
  Shape shape;
  shape.partNames = {"all"};
  const Vec3 half = axis * (0.5 * length);
  shape.patches.push_back(geometry::makeCylinderPatch(center - half, center + half, 0.5 * diameter, 0));
  shape.patches.push_back(geometry::makeDiscPatch(center - half, -axis, 0.5 * diameter, 0));
  shape.patches.push_back(geometry::makeDiscPatch(center + half, axis, 0.5 * diameter, 0));
  return shape;
}

Shape sphere(const Vec3& center, double radius) {
  Shape shape;
  shape.partNames = {"all"};
  shape.patches.push_back(geometry::makeSpherePatch(center, radius, 0));
  return shape;
}

std::vector<Vec2> parabola(const Vec2& focus, double focalLength, double degrees, double from, double to,
                           int segments) {
  const double tilt = degrees * core::degree;
  const Vec2 axis(std::sin(tilt), -std::cos(tilt)), across(std::cos(tilt), std::sin(tilt));
  std::vector<Vec2> points;
  for (int i = 0; i <= segments; ++i) {
    const double phi = (from + (to - from) * i / segments) * core::degree;
    const double r = 2 * focalLength / (1 - std::cos(phi));
    points.push_back(focus + r * (std::cos(phi) * axis + std::sin(phi) * across));
  }
  return points;
}

}  // namespace goniolux::traced
