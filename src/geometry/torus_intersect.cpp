#include "geometry/torus_intersect.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace goniolux::geometry {

using core::Vec3;

namespace {

// Between low and high, where `at` (value and slope by t) has opposite signs: Newton's method kept inside the bracket
// by bisection. — Press et al., Numerical Recipes, 3rd ed., 9.4 (rtsafe)
template <typename Function>
double rootBetween(double low, double high, bool risesFromLow, const Function& at) {
  double t = 0.5 * (low + high);
  for (int step = 0; step < 200; ++step) {
    double slope = 0;
    const double value = at(t, slope);
    if (value == 0) return t;
    ((value < 0) == risesFromLow ? low : high) = t;
    double next = t - value / slope;
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    if (std::abs(next - t) <= std::numeric_limits<double>::epsilon() * std::max(std::abs(t), 0.01)) return next;
    t = next;
  }
  return t;
}

// Roots of t^3 + a t + b within (low, high) in ascending order, where the quartic below turns: returns how many.
int turningPoints(double a, double b, double low, double high, double (&roots)[3]) {
  const auto at = [&](double t, double& slope) {
    slope = 3 * t * t + a;
    return (t * t + a) * t + b;
  };
  double ignored = 0;
  double ends[4] = {low, high, high, high};
  int pieces = 1;
  if (a < 0) {
    const double turn = std::sqrt(-a / 3);
    pieces = 0;
    for (const double t : {-turn, turn})
      if (t > low && t < high) ends[++pieces] = t;
    ends[++pieces] = high;
  }
  int count = 0;
  for (int i = 0; i < pieces; ++i) {
    const double from = at(ends[i], ignored), to = at(ends[i + 1], ignored);
    if ((from < 0) != (to < 0)) roots[count++] = rootBetween(ends[i], ends[i + 1], from < 0, at);
  }
  return count;
}

}  // namespace

int intersectTorus(double tube, const Vec3& origin, const Vec3& direction, double tMin, double tMax, double (&t)[4]) {
  const double length = glm::length(direction);
  if (!(length > 0)) return 0;
  const Vec3 u = direction / length;
  // From the point nearest to the middle all numbers are of order 1, and the quartic has no cubic term.
  const double shift = -glm::dot(origin, u);
  const Vec3 p = origin + shift * u;
  constexpr double slack = 1e-9;
  const double reach = 1 + tube + slack, square = reach * reach - glm::dot(p, p);
  if (!(square > 0)) return 0;
  double low = -std::sqrt(square), high = -low;
  if (u.z != 0) {  // between the planes z = +-tube
    const double a = (-tube - slack - p.z) / u.z, b = (tube + slack - p.z) / u.z;
    low = std::max(low, std::min(a, b));
    high = std::min(high, std::max(a, b));
  } else if (std::abs(p.z) > tube) {
    return 0;
  }
  if (!(low < high)) return 0;

  // Below 0 inside the tube. The product of this with (rho + 1)^2 + z^2 - tube^2 > 0 is the textbook's quartic, so both
  // have the same roots, but this one keeps its digits for a thin tube.
  const auto value = [&](double s, double& slope) {
    const Vec3 q = p + s * u;
    const double rho = std::sqrt(q.x * q.x + q.y * q.y);
    const double across = rho - 1;
    slope = 2 * (rho > 0 ? across * (q.x * u.x + q.y * u.y) / rho : 0.0) + 2 * q.z * u.z;
    return across * across + (q.z - tube) * (q.z + tube);
  };
  // (s^2 + m)^2 - 4 (A s^2 + 2 B s + C) turns where s^3 + (m - 2 A) s - 2 B = 0.
  const double m = glm::dot(p, p) + 1 - tube * tube;
  const double flat = u.x * u.x + u.y * u.y;
  double nodes[5] = {low, high, high, high, high};
  double turns[3];
  const int count = turningPoints(m - 2 * flat, -2 * (p.x * u.x + p.y * u.y), low, high, turns);
  std::copy(turns, turns + count, nodes + 1);
  nodes[count + 1] = high;

  int found = 0;
  double ignored = 0;
  double from = value(nodes[0], ignored);
  for (int i = 0; i <= count; ++i) {
    const double to = value(nodes[i + 1], ignored);
    if ((from < 0) != (to < 0)) {
      const double hit = (shift + rootBetween(nodes[i], nodes[i + 1], from < 0, value)) / length;
      if (hit > tMin && hit < tMax) t[found++] = hit;
    }
    from = to;
  }
  return found;
}

}  // namespace goniolux::geometry
