#include "geometry/quadric_intersect.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/clipped_quadric.h"
#include "geometry/quadratic.h"
#include "geometry/torus_intersect.h"

namespace goniolux::geometry {

using core::Mat4;
using core::Vec3;

namespace {

constexpr double rimSlack = 1e-9;

double radiusAt(const QuadricPatch& patch, double z) {
  return patch.kind == QuadricPatch::Kind::cone ? 1 + (patch.ratio - 1) * z : 1.0;
}

}  // namespace

int intersectAll(const QuadricPatch& patch, const Vec3& origin, const Vec3& direction, double tMin, double tMax,
                 double (&t)[mostCrossings]) {
  using Kind = QuadricPatch::Kind;
  if (patch.kind == Kind::disc) {
    if (direction.z == 0) return 0;
    const double hit = -origin.z / direction.z;
    const double x = origin.x + hit * direction.x, y = origin.y + hit * direction.y;
    const double square = x * x + y * y;
    if (!(square <= 1 + 2 * rimSlack && square >= patch.ratio * patch.ratio - 2 * rimSlack)) return 0;
    if (!(hit > tMin && hit < tMax)) return 0;
    t[0] = hit;
    return 1;
  }

  if (patch.kind == Kind::torus) return intersectTorus(patch.ratio, origin, direction, tMin, tMax, t);
  if (patch.kind == Kind::quadric) return intersectClippedQuadric(patch.form, origin, direction, tMin, tMax, t);

  // Re-centre: from the point of the ray nearest to the patch's middle, coefficients are of order 1 however far away
  // the ray began, and a ray that stays outside the bounding sphere is done. — Haines et al., "Precision Improvements
  // for Ray/Sphere Intersection", Ray Tracing Gems (2019), ch. 7
  const double lengthSquared = glm::dot(direction, direction);
  if (!(lengthSquared > 0)) return 0;
  const bool isSphere = patch.kind == Kind::sphere;
  const Vec3 middle(0, 0, isSphere ? 0 : 0.5);
  const double widest = std::max(1.0, radiusAt(patch, 1));
  const double boundingRadiusSquared = isSphere ? 1.0 : widest * widest + 0.25;
  const double shift = glm::dot(middle - origin, direction) / lengthSquared;
  const Vec3 o = origin + shift * direction;
  const Vec3& d = direction;
  if (glm::dot(o - middle, o - middle) > boundingRadiusSquared * (1 + 4 * rimSlack)) return 0;

  double a, b, c;
  if (isSphere) {
    a = lengthSquared;
    b = glm::dot(o, d);
    c = glm::dot(o, o) - 1;
  } else {
    // x^2 + y^2 = (1 + s z)^2 with s = ratio - 1 (0 for the cylinder)
    const double s = patch.kind == Kind::cone ? patch.ratio - 1 : 0.0;
    const double radius = 1 + s * o.z, slope = s * d.z;
    a = d.x * d.x + differenceOfProducts(d.y, d.y, slope, slope);
    b = o.x * d.x + differenceOfProducts(o.y, d.y, radius, slope);
    c = o.x * o.x + differenceOfProducts(o.y, o.y, radius, radius);
  }
  double roots[2];
  if (!solveQuadratic(a, b, c, lengthSquared, roots[0], roots[1])) return 0;
  int count = 0;
  for (const double root : roots) {
    const double hit = shift + root;
    if (!(hit > tMin && hit < tMax)) continue;
    if (!isSphere) {
      const double z = o.z + root * d.z;
      // The height also keeps the second nappe of a cone out: it begins beyond z = 1.
      if (!(z >= -rimSlack && z <= 1 + rimSlack)) continue;
    }
    t[count++] = hit;
  }
  return count;
}

bool intersect(const QuadricPatch& patch, const Vec3& origin, const Vec3& direction, double tMin, double tMax,
               double& t) {
  double hits[mostCrossings];
  if (intersectAll(patch, origin, direction, tMin, tMax, hits) == 0) return false;
  t = hits[0];
  return true;
}

namespace {

Vec3 gradient(const QuadricPatch& patch, const Vec3& point) {
  switch (patch.kind) {
    case QuadricPatch::Kind::disc:
      return {0, 0, 1};
    case QuadricPatch::Kind::sphere:
      return point;
    case QuadricPatch::Kind::cylinder:
      return {point.x, point.y, 0};
    case QuadricPatch::Kind::torus: {
      const double rho = std::hypot(point.x, point.y);
      const double across = rho > 0 ? 1 - 1 / rho : 0.0;
      return {across * point.x, across * point.y, point.z};
    }
    case QuadricPatch::Kind::quadric: {
      const Vec3 half = quadricHalfGradient(patch.form, point);
      return glm::dot(half, half) > 0 ? half : Vec3(0, 0, 1);
    }
    case QuadricPatch::Kind::cone:
      break;
  }
  const Vec3 slanted(point.x, point.y, (1 - patch.ratio) * radiusAt(patch, point.z));
  // At the apex of a full cone the gradient vanishes; the axis is as good as any direction there.
  return glm::dot(slanted, slanted) > 0 ? slanted : Vec3(0, 0, 1);
}

}  // namespace

Vec3 canonicalNormal(const QuadricPatch& patch, const Vec3& point) {
  const Vec3 normal = gradient(patch, point);
  return patch.turned ? -normal : normal;
}

Bounds boundsOf(const QuadricPatch& patch, const Mat4& transform) {
  const Mat4 map = transform * patch.placement;
  const Vec3 x(map[0]), y(map[1]), z(map[2]), center(map[3]);
  Bounds bounds;
  const auto addCircle = [&](double height, double radius) {
    // The support of an ellipse spanned by x and y along each world axis. — Quilez, "Disk - bounding box"
    const Vec3 half = radius * glm::sqrt(x * x + y * y);
    bounds.add(center + height * z - half);
    bounds.add(center + height * z + half);
  };
  switch (patch.kind) {
    case QuadricPatch::Kind::disc:
      addCircle(0, 1);
      break;
    case QuadricPatch::Kind::sphere: {
      const Vec3 half = glm::sqrt(x * x + y * y + z * z);
      bounds.add(center - half);
      bounds.add(center + half);
      break;
    }
    case QuadricPatch::Kind::cylinder:
    case QuadricPatch::Kind::cone:
      addCircle(0, 1);
      addCircle(1, radiusAt(patch, 1));
      break;
    case QuadricPatch::Kind::torus: {
      // The hull is that of a disc thickened by a ball: their supports add up.
      const Vec3 half = glm::sqrt(x * x + y * y) + patch.ratio * glm::sqrt(x * x + y * y + z * z);
      bounds.add(center - half);
      bounds.add(center + half);
      break;
    }
    case QuadricPatch::Kind::quadric: {  // the box, which the surface may not fill
      const Vec3 half = glm::abs(x) + glm::abs(y) + glm::abs(z);
      bounds.add(center - half);
      bounds.add(center + half);
      break;
    }
  }
  return bounds;
}

}  // namespace goniolux::geometry
