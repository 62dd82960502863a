#include "geometry/surface_points.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "geometry/clipped_quadric.h"
#include "geometry/quadric_intersect.h"
#include "geometry/queries.h"

namespace goniolux::geometry {

using core::Mat3;
using core::Mat4;
using core::pi;
using core::Vec2;
using core::Vec3;
using Kind = QuadricPatch::Kind;

namespace {

// A line along one of three axes, through a place of its square, and one of two crossings: each equally likely, so an
// element with normal n is met with density (|n_x| + |n_y| + |n_z|) / 24.
constexpr double quadricChoices = 24;

PatchPoint quadricPoint(const QuadricPatch& patch, const Vec2& u) {
  const double six = 6 * u.x;
  const int choice = std::min(static_cast<int>(six), 5), axis = choice / 2;
  Vec3 direction(0), origin(0);
  direction[axis] = 1;
  origin[(axis + 1) % 3] = 2 * (six - choice) - 1;
  origin[(axis + 2) % 3] = 2 * u.y - 1;
  double t[4];
  const int count = intersectClippedQuadric(patch.form, origin, direction, -2, 2, t);
  if (choice % 2 >= count) return {};
  PatchPoint point;
  point.position = origin + t[choice % 2] * direction;
  const Vec3 normal = canonicalNormal(patch, point.position);
  const double length = glm::length(normal);
  if (!(length > 0)) return {};  // the apex of a cone
  point.normal = normal / length;
  point.area = quadricChoices / (std::abs(point.normal.x) + std::abs(point.normal.y) + std::abs(point.normal.z));
  return point;
}

}  // namespace

PatchPoint patchPoint(const QuadricPatch& patch, const Vec2& u) {
  if (patch.kind == Kind::quadric) return quadricPoint(patch, u);
  PatchPoint point;
  const double angle = 2 * pi * u.y, k = patch.ratio;
  const Vec3 around(std::cos(angle), std::sin(angle), 0);
  switch (patch.kind) {
    case Kind::disc:
      point.position = around * std::sqrt(k * k + (1 - k * k) * u.x);
      point.area = pi * (1 - k * k);
      break;
    case Kind::sphere: {  // Archimedes: bands of equal height have equal areas
      const double z = 2 * u.x - 1;
      point.position = around * std::sqrt(std::max(0.0, 1 - z * z)) + Vec3(0, 0, z);
      point.area = 4 * pi;
      break;
    }
    case Kind::cylinder:
      point.position = around + Vec3(0, 0, u.x);
      point.area = 2 * pi;
      break;
    case Kind::cone: {  // the area grows as r dr; z = (r - 1) / (k - 1) without its pole at k = 1
      const double r = std::sqrt(1 + (k * k - 1) * u.x);
      point.position = around * r + Vec3(0, 0, (k + 1) * u.x / (r + 1));
      point.area = pi * (1 + k) * std::hypot(1.0, k - 1);
      break;
    }
    case Kind::torus: {
      const double tube = 2 * pi * u.x, across = 1 + k * std::cos(tube);
      point.position = around * across + Vec3(0, 0, k * std::sin(tube));
      point.area = 4 * pi * pi * k * across;
      break;
    }
    case Kind::quadric:
      break;
  }
  point.normal = glm::normalize(canonicalNormal(patch, point.position));
  return point;
}

double largestPatchPointArea(const QuadricPatch& patch) {
  if (patch.kind == Kind::quadric) return quadricChoices;
  if (patch.kind == Kind::torus) return 4 * pi * pi * patch.ratio * (1 + patch.ratio);
  return patchPoint(patch, {0.5, 0.5}).area;
}

Mat3 cofactor(const Mat3& m) {
  return {glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1])};
}

SurfacePoints::SurfacePoints(const Shape& shape, const Mat4& transform) : shape_(shape), transform_(transform) {
  sign_ = glm::determinant(Mat3(transform)) < 0 ? -1 : 1;
  double sum = 0;
  const Mat3 areas = cofactor(Mat3(transform));
  for (const auto& t : shape.mesh.triangles) {
    const Vec3 &a = shape.mesh.vertices[t[0]], &b = shape.mesh.vertices[t[1]], &c = shape.mesh.vertices[t[2]];
    cumulative_.push_back(sum += 0.5 * glm::length(areas * glm::cross(b - a, c - a)));
  }
  for (const QuadricPatch& patch : shape.patches) {
    Piece piece;
    piece.map = transform * patch.placement;
    piece.areas = cofactor(Mat3(piece.map));
    // Largest stretch of an area: the row sums of C^T C bound its largest eigenvalue, and are it for similarities.
    const Mat3 square = glm::transpose(piece.areas) * piece.areas;
    double largest = 0;
    for (int i = 0; i < 3; ++i)
      largest = std::max(largest, std::abs(square[i].x) + std::abs(square[i].y) + std::abs(square[i].z));
    piece.most = std::sqrt(largest) * largestPatchPointArea(patch);
    cumulative_.push_back(sum += piece.most);
    patches_.push_back(piece);
  }
  const double whole = area(shape, transform);
  if (!(whole > 0 && sum > 0)) throw std::invalid_argument("the shape has no area; give it an extent");
  density_ = 1 / whole;
}

SurfacePlace SurfacePoints::sample(core::Sampler& random) const {
  const std::size_t triangles = shape_.mesh.triangles.size();
  for (;;) {
    const auto found = std::upper_bound(cumulative_.begin(), cumulative_.end() - 1, random.next() * cumulative_.back());
    const auto index = static_cast<std::size_t>(found - cumulative_.begin());
    const Vec2 u = random.next2();
    if (index < triangles) {
      const auto& t = shape_.mesh.triangles[index];
      const Vec3 &a = shape_.mesh.vertices[t[0]], &b = shape_.mesh.vertices[t[1]], &c = shape_.mesh.vertices[t[2]];
      const double root = std::sqrt(u.x);
      const Vec3 point = a * (1 - root) + b * (root * (1 - u.y)) + c * (root * u.y);
      const Vec3 normal = cofactor(Mat3(transform_)) * glm::cross(b - a, c - a);
      return {Vec3(transform_ * glm::dvec4(point, 1)), sign_ * glm::normalize(normal), shape_.mesh.parts[index]};
    }
    const QuadricPatch& patch = shape_.patches[index - triangles];
    const Piece& piece = patches_[index - triangles];
    const PatchPoint point = patchPoint(patch, u);
    const double keep = random.next();
    if (!(point.area > 0)) continue;
    const Vec3 normal = piece.areas * point.normal;
    const double stretch = glm::length(normal);
    if (!(keep * piece.most < point.area * stretch * (1 + 1e-12))) continue;
    // Outward stays outward under a reflection, while the cofactor matrix turns with it.
    const double sign = glm::determinant(Mat3(piece.map)) < 0 ? -1 : 1;
    return {Vec3(piece.map * glm::dvec4(point.position, 1)), sign / stretch * normal, patch.part};
  }
}

}  // namespace goniolux::geometry
