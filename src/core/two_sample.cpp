#include "core/two_sample.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/vector.h"

namespace goniolux::core {
namespace {

/// P(|T| > t): Student's density (Abramowitz & Stegun 26.7.1) in the angle u = pi/2 - atan(t / sqrt(dof)) becomes
/// sin^(dof-1)(u), smooth on [0, u1], and no digits cancel in the far tail. Simpson's rule.
double tailProbability(double dof, double t) {
  if (std::isinf(dof)) return std::erfc(t / std::sqrt(2.0));
  const double scale = 2 * std::exp(std::lgamma((dof + 1) / 2) - std::lgamma(dof / 2)) / std::sqrt(pi);
  const double u1 = std::atan(std::sqrt(dof) / t);
  constexpr int steps = 400;
  const double h = u1 / steps;
  const auto density = [&](double u) { return std::pow(std::sin(u), dof - 1); };
  double sum = density(u1) + (dof > 1 ? 0.0 : 1.0);
  for (int i = 1; i < steps; ++i) sum += (i % 2 == 1 ? 4 : 2) * density(i * h);
  return scale * sum * h / 3;
}

}  // namespace

double studentTail(double dof, double probability) {
  double low = 0, high = 1;
  while (tailProbability(dof, high) > probability && high < 1e9) high *= 2;
  while (high - low > 1e-9 * high) {
    const double middle = 0.5 * (low + high);
    (tailProbability(dof, middle) > probability ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

double standardErrorOf(double halfWidth, double confidence, double dof) {
  return halfWidth / studentTail(dof, 1 - confidence);
}

double TwoSampleTest::quantile(double dof) {
  // Whole degrees of freedom, rounded down: on the safe side, and few enough to remember. Beyond some thousands
  // Student's distribution is the normal one to four digits.
  constexpr double many = 5000;
  const double whole = dof < many ? std::max(1.0, std::floor(dof)) : std::numeric_limits<double>::infinity();
  const auto [known, isNew] = quantiles_.try_emplace(whole, 0.0);
  if (isNew) known->second = studentTail(whole, falseAlarms_);
  return known->second;
}

double TwoSampleTest::largestDifference(const Sample& a, const Sample& b) {
  const double va = a.standardError * a.standardError, vb = b.standardError * b.standardError;
  const double bounds = a.bound + b.bound;
  if (va + vb <= 0) return bounds;
  // Welch-Satterthwaite; a part that is known exactly adds nothing to the sum.
  const double spread = va * va / a.dof + vb * vb / b.dof;
  const double dof = spread > 0 ? (va + vb) * (va + vb) / spread : std::numeric_limits<double>::infinity();
  return bounds + quantile(dof) * std::sqrt(va + vb);
}

}  // namespace goniolux::core
