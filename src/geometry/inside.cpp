#include "geometry/inside.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/clipped_quadric.h"
#include "geometry/quadric_intersect.h"
#include "geometry/queries.h"

namespace goniolux::geometry {

using core::Mat3;
using core::Mat4;
using core::Vec3;

namespace {

Vec3 apply(const Mat4& map, const Vec3& point) {
  return Vec3(map * glm::dvec4(point, 1));
}

// Distance from p to the triangle abc. — Ericson, Real-Time Collision Detection (2005), 5.1.5
double distanceToTriangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a, ac = c - a, ap = p - a;
  const double d1 = glm::dot(ab, ap), d2 = glm::dot(ac, ap);
  if (d1 <= 0 && d2 <= 0) return glm::length(ap);
  const Vec3 bp = p - b;
  const double d3 = glm::dot(ab, bp), d4 = glm::dot(ac, bp);
  if (d3 >= 0 && d4 <= d3) return glm::length(bp);
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return glm::distance(p, a + d1 / (d1 - d3) * ab);
  const Vec3 cp = p - c;
  const double d5 = glm::dot(ab, cp), d6 = glm::dot(ac, cp);
  if (d6 >= 0 && d5 <= d6) return glm::length(cp);
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return glm::distance(p, a + d2 / (d2 - d6) * ac);
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
    return glm::distance(p, b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b));
  }
  const double sum = va + vb + vc;
  return glm::distance(p, a + vb / sum * ab + vc / sum * ac);
}

}  // namespace

InsideTest::InsideTest(const Shape& shape, const Mat4& transform) {
  if (!shape.closed) return;
  bounds_ = bounds(shape, transform);
  mesh_ = &shape.mesh;
  toWorld_ = transform;
  winding_ = glm::determinant(Mat3(transform)) < 0 ? -1 : 1;
  for (const QuadricPatch& patch : shape.patches) {
    const Mat4 toCanonical = glm::inverse(transform * patch.placement);
    patches_.push_back({patch, toCanonical, glm::transpose(Mat3(toCanonical))});
  }
}

Vec3 InsideTest::corner(std::uint32_t vertex) const {
  return apply(toWorld_, mesh_->vertices[vertex]);
}

bool InsideTest::contains(const Vec3& point, double margin) const {
  if (bounds_.empty() || !bounds_.contains(point, -margin)) return false;
  if (!(meshWinding(point) + patchWinding(point) > 0.5)) return false;
  return !touchesMesh(point, margin) && std::none_of(patches_.begin(), patches_.end(), [&](const Patch& patch) {
    return touchesPatch(patch, point, margin);
  });
}

// Sum of signed solid angles over 4 pi. — Van Oosterom & Strackee, IEEE Trans. Biomed. Eng. 30 (1983), eq. 8
double InsideTest::meshWinding(const Vec3& point) const {
  double halfSolidAngle = 0;
  for (const auto& t : mesh_->triangles) {
    const Vec3 a = corner(t[0]) - point, b = corner(t[1]) - point, c = corner(t[2]) - point;
    const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
    const double numerator = glm::dot(a, glm::cross(b, c));
    const double denominator = la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb;
    halfSolidAngle += std::atan2(numerator, denominator);
  }
  return winding_ * halfSolidAngle / (2 * core::pi);
}

// Crossings along three rays, outward ones counted +1, inward ones -1; the middle of the three counts, since a ray may
// pass through a rim, where cap and side overlap.
double InsideTest::patchWinding(const Vec3& point) const {
  if (patches_.empty()) return 0;
  static const Vec3 directions[3] = {glm::normalize(Vec3(0.5772156649, 0.2614972128, 0.7744196801)),
                                     glm::normalize(Vec3(-0.6434105463, 0.7642236535, -0.1149420449)),
                                     glm::normalize(Vec3(0.1862820638, -0.9159655942, -0.3036630029))};
  double votes[3];
  for (int k = 0; k < 3; ++k) {
    votes[k] = 0;
    for (const Patch& patch : patches_) {
      const Vec3 origin = apply(patch.toCanonical, point);
      const Vec3 direction = Mat3(patch.toCanonical) * directions[k];
      double t[mostCrossings];
      const int count = intersectAll(patch.canonical, origin, direction, 0, std::numeric_limits<double>::infinity(), t);
      for (int i = 0; i < count; ++i) {
        const Vec3 normal = canonicalNormal(patch.canonical, origin + t[i] * direction);
        votes[k] += glm::dot(normal, direction) > 0 ? 1 : -1;
      }
    }
  }
  std::sort(votes, votes + 3);
  return votes[1];
}

bool InsideTest::touchesMesh(const Vec3& point, double margin) const {
  return std::any_of(mesh_->triangles.begin(), mesh_->triangles.end(), [&](const auto& t) {
    return distanceToTriangle(point, corner(t[0]), corner(t[1]), corner(t[2])) < margin;
  });
}

// First-order distance |f| / |grad f|, exact to first order near the surface, which is all that a small margin needs.
bool InsideTest::touchesPatch(const Patch& patch, const Vec3& point, double margin) const {
  const Vec3 p = apply(patch.toCanonical, point);
  const Mat3 linear(patch.toCanonical);
  // No farther beyond its rims than the margin, in canonical units: a patch does not go on for ever.
  const double reach = margin * std::sqrt(glm::dot(linear[0], linear[0]) + glm::dot(linear[1], linear[1]) +
                                          glm::dot(linear[2], linear[2]));
  double f = 0;
  Vec3 gradient = canonicalNormal(patch.canonical, p);
  switch (patch.canonical.kind) {
    case QuadricPatch::Kind::disc: {
      const double radius = std::hypot(p.x, p.y);
      if (radius > 1 + reach || radius < patch.canonical.ratio - reach) return false;
      f = p.z;
      break;
    }
    case QuadricPatch::Kind::sphere:
      f = 0.5 * (glm::dot(p, p) - 1);
      break;
    case QuadricPatch::Kind::cylinder:
      if (p.z < -reach || p.z > 1 + reach) return false;
      f = 0.5 * (p.x * p.x + p.y * p.y - 1);
      break;
    case QuadricPatch::Kind::cone: {
      if (p.z < -reach || p.z > 1 + reach) return false;
      const double radius = 1 + (patch.canonical.ratio - 1) * p.z;
      f = 0.5 * (p.x * p.x + p.y * p.y - radius * radius);
      break;
    }
    case QuadricPatch::Kind::torus: {
      const double across = std::hypot(p.x, p.y) - 1;
      f = 0.5 * (across * across + p.z * p.z - patch.canonical.ratio * patch.canonical.ratio);
      break;
    }
    case QuadricPatch::Kind::quadric:
      if (std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) > 1 + reach) return false;
      f = 0.5 * quadricValue(patch.canonical.form, p);
      break;
  }
  return std::abs(f) < margin * glm::length(patch.normalToWorld * gradient);
}

}  // namespace goniolux::geometry
