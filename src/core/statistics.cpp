#include "core/statistics.h"

#include <algorithm>
#include <cmath>

namespace goniolux::core {
namespace {

// Regularised incomplete beta function I_x(a, b) by its continued fraction (modified Lentz; DLMF 8.17.22).
double incompleteBeta(double a, double b, double x) {
  if (x <= 0) return 0;
  if (x >= 1) return 1;
  if (x > (a + 1) / (a + b + 2)) return 1 - incompleteBeta(b, a, 1 - x);
  const double front =
      std::exp(std::lgamma(a + b) - std::lgamma(a) - std::lgamma(b) + a * std::log(x) + b * std::log1p(-x)) / a;
  constexpr double tiny = 1e-300;
  double c = 1, d = 1 - (a + b) * x / (a + 1);
  d = 1 / (std::abs(d) < tiny ? tiny : d);
  double fraction = d;
  for (int m = 1; m < 500; ++m) {
    const auto step = [&](double numerator) {
      d = 1 + numerator * d;
      c = 1 + numerator / c;
      d = 1 / (std::abs(d) < tiny ? tiny : d);
      if (std::abs(c) < tiny) c = tiny;
      fraction *= c * d;
      return c * d;
    };
    step(m * (b - m) * x / ((a + 2 * m - 1) * (a + 2 * m)));
    if (std::abs(step(-(a + m) * (a + b + m) * x / ((a + 2 * m) * (a + 2 * m + 1))) - 1) < 1e-15) break;
  }
  return front * fraction;
}

}  // namespace

double studentProbability(double dof, double t) {
  return 1 - incompleteBeta(dof / 2, 0.5, dof / (dof + t * t));
}

double studentQuantile(double dof, double confidence) {
  double low = 0, high = 1;
  while (studentProbability(dof, high) < confidence && high < 1e12) high *= 2;
  for (int i = 0; i < 200 && high - low > 1e-12 * high; ++i) {
    const double middle = 0.5 * (low + high);
    (studentProbability(dof, middle) < confidence ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

ReplicateMean replicateMean(std::span<const double> replicates) {
  const auto n = static_cast<double>(replicates.size());
  double sum = 0, squares = 0;
  for (const double r : replicates) sum += r;
  const double mean = sum / n;
  for (const double r : replicates) squares += (r - mean) * (r - mean);
  return {mean, replicates.size() > 1 ? std::sqrt(squares / (n * (n - 1))) : 0.0};
}

double sidak(double confidence, std::size_t count) {
  return count < 2 ? confidence : std::pow(confidence, 1.0 / static_cast<double>(count));
}

}  // namespace goniolux::core
