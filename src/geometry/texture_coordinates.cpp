#include "geometry/texture_coordinates.h"

#include <algorithm>
#include <cmath>

#include "geometry/quadric_intersect.h"

namespace goniolux::geometry {

using core::Vec2;
using core::Vec3;

namespace {

double turns(double y, double x) {
  const double turn = std::atan2(y, x) / (2 * core::pi);
  return turn < 0 ? turn + 1 : turn;
}

// Across a box, along the two axes that a face with this normal runs along.
Vec2 acrossBox(const Vec3& p, const Vec3& normal, const Bounds& box) {
  const Vec3 extent = glm::max(box.extent(), Vec3(1e-300)), q = (p - box.min) / extent, n = glm::abs(normal);
  if (n.z >= n.x && n.z >= n.y) return {q.x, q.y};
  return n.x >= n.y ? Vec2(q.y, q.z) : Vec2(q.x, q.z);
}

}  // namespace

Vec2 surfaceCoordinates(const QuadricPatch& patch, const Vec3& p) {
  using Kind = QuadricPatch::Kind;
  const double across = std::hypot(p.x, p.y);
  switch (patch.kind) {
    case Kind::disc:
      return {turns(p.y, p.x), across};
    case Kind::sphere:
      return {turns(p.y, p.x), 1 - std::atan2(across, p.z) / core::pi};
    case Kind::cylinder:
    case Kind::cone:
      return {turns(p.y, p.x), p.z};
    case Kind::torus:
      return {turns(p.y, p.x), turns(p.z, across - 1)};
    case Kind::quadric:
      break;
  }
  Bounds box;
  box.add(Vec3(-1));
  box.add(Vec3(1));
  return acrossBox(p, canonicalNormal(patch, p), box);
}

std::array<Vec2, 3> cornerCoordinates(const Mesh& mesh, const Bounds& box, std::size_t triangle) {
  if (!mesh.coordinates.empty()) {
    const auto& given = mesh.coordinates[triangle];
    return {Vec2(given[0]), Vec2(given[1]), Vec2(given[2])};
  }
  const auto& t = mesh.triangles[triangle];
  const Vec3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
  const Vec3 normal = glm::cross(b - a, c - a);
  return {acrossBox(a, normal, box), acrossBox(b, normal, box), acrossBox(c, normal, box)};
}

}  // namespace goniolux::geometry
