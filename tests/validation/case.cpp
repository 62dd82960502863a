#include "validation/case.h"

#include <algorithm>
#include <cmath>

namespace goniolux::validation {
namespace {

double scaleOf(const Number& number, const Case& of) {
  const double scale = std::max(std::abs(number.reference), of.scale);
  return scale > 0 ? scale : 1;
}

// The number of misses that `count` intervals of 95 % exceed once in a hundred times (binomial).
std::size_t mostOutside(std::size_t count) {
  double term = std::pow(0.95, static_cast<double>(count)), sum = term;
  std::size_t k = 0;
  while (sum < 0.99 && k < count) {
    term *= 0.05 / 0.95 * static_cast<double>(count - k) / static_cast<double>(k + 1);
    sum += term;
    ++k;
  }
  return k;
}

}  // namespace

double deviationOf(const Number& number, const Case& of) {
  return (number.ours - number.reference) / scaleOf(number, of);
}

NumberVerdict verdictOf(const Number& number, const Case& of) {
  if (!std::isfinite(number.ours) || !std::isfinite(number.halfWidth)) return NumberVerdict::wrong;
  const double off = std::abs(number.ours - number.reference), allowed = of.tolerance * scaleOf(number, of);
  if (number.halfWidth == 0) return off <= allowed + number.uncertainty ? NumberVerdict::right : NumberVerdict::wrong;
  if (number.halfWidth > allowed) return NumberVerdict::wrong;
  const double within = number.halfWidth + number.uncertainty;
  return off <= within ? NumberVerdict::right : off <= 2 * within ? NumberVerdict::outside : NumberVerdict::wrong;
}

Verdict verdictOf(const std::vector<Number>& numbers, const Case& of) {
  Verdict verdict;
  std::size_t intervals = 0;
  for (const Number& number : numbers) {
    switch (verdictOf(number, of)) {
      case NumberVerdict::right:
        ++verdict.right;
        break;
      case NumberVerdict::outside:
        ++verdict.outside;
        break;
      case NumberVerdict::wrong:
        ++verdict.wrong;
        break;
    }
    intervals += number.halfWidth > 0;
    verdict.largest = std::max(verdict.largest, std::abs(deviationOf(number, of)));
    verdict.widest = std::max(verdict.widest, number.halfWidth / scaleOf(number, of));
  }
  verdict.byChance = intervals > 0;
  verdict.withinChance = verdict.outside <= mostOutside(intervals);
  return verdict;
}

}  // namespace goniolux::validation
