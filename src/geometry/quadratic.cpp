#include "geometry/quadratic.h"

#include <cmath>
#include <limits>
#include <utility>

namespace goniolux::geometry {

double differenceOfProducts(double a, double b, double c, double d) {
  const double cd = c * d;
  const double error = std::fma(-c, d, cd);
  return std::fma(a, b, -cd) + error;
}

// Stable form: Press et al., Numerical Recipes, 3rd ed., (5.6.4)
bool solveQuadratic(double a, double b, double c, double scale, double& t0, double& t1) {
  double discriminant = differenceOfProducts(b, b, a, c);
  const double rounding = 8 * std::numeric_limits<double>::epsilon() * scale;
  if (discriminant < 0 && discriminant >= -rounding && std::abs(a) > 1e-3 * scale) discriminant = 0;
  if (!(discriminant >= 0)) return false;
  const double q = -(b + std::copysign(std::sqrt(discriminant), b));
  if (q == 0 && a == 0) return false;
  t0 = q == 0 ? 0 : c / q;
  t1 = a == 0 ? std::copysign(HUGE_VAL, q) : q / a;
  if (t0 > t1) std::swap(t0, t1);
  return true;
}

}  // namespace goniolux::geometry
