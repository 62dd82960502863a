#include "geometry/clipped_quadric.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "geometry/quadratic.h"

namespace goniolux::geometry {

using core::Mat3;
using core::Mat4;
using core::Vec3;

namespace {

constexpr double slack = 1e-9;

// The part of the line within the cube.
bool clip(const Vec3& origin, const Vec3& direction, double& low, double& high) {
  low = -std::numeric_limits<double>::infinity();
  high = -low;
  for (int axis = 0; axis < 3; ++axis) {
    if (direction[axis] == 0) {
      if (std::abs(origin[axis]) > 1 + slack) return false;
      continue;
    }
    double a = (-1 - slack - origin[axis]) / direction[axis], b = (1 + slack - origin[axis]) / direction[axis];
    if (a > b) std::swap(a, b);
    low = std::max(low, a);
    high = std::min(high, b);
  }
  return low < high;
}

}  // namespace

double quadricValue(const Mat4& form, const Vec3& point) {
  const glm::dvec4 p(point, 1);
  return glm::dot(p, form * p);
}

Vec3 quadricHalfGradient(const Mat4& form, const Vec3& point) {
  return Vec3(form * glm::dvec4(point, 1));
}

int intersectClippedQuadric(const Mat4& form, const Vec3& origin, const Vec3& direction, double tMin, double tMax,
                            double (&t)[4]) {
  double low, high;
  if (!(glm::dot(direction, direction) > 0) || !clip(origin, direction, low, high)) return 0;
  // From the middle of the chord within the cube the coefficients are of order 1, however far away the line began.
  const double shift = 0.5 * (low + high);
  const Vec3 o = origin + shift * direction;
  const double a = glm::dot(direction, Mat3(form) * direction);
  const double b = glm::dot(direction, quadricHalfGradient(form, o));
  double roots[2];
  if (!solveQuadratic(a, b, quadricValue(form, o), glm::dot(direction, direction), roots[0], roots[1])) return 0;
  int count = 0;
  for (const double root : roots) {
    const double hit = shift + root;
    if (hit >= low && hit <= high && hit > tMin && hit < tMax) t[count++] = hit;
  }
  return count;
}

bool isWholeEllipsoid(const Mat4& form) {
  Mat3 a(form);
  const Vec3 g(form[3]);
  const double determinant = glm::determinant(a);
  const bool positive = a[0][0] > 0 && a[0][0] * a[1][1] - a[0][1] * a[1][0] > 0 && determinant > 0;  // Sylvester
  if (!positive) return false;
  const Mat3 inverse = glm::inverse(a);
  const Vec3 middle = -(inverse * g);
  const double level = -quadricValue(form, middle);
  if (!(level > 0)) return false;
  for (int axis = 0; axis < 3; ++axis) {
    if (std::abs(middle[axis]) + std::sqrt(level * inverse[axis][axis]) > 1) return false;
  }
  return true;
}

}  // namespace goniolux::geometry
