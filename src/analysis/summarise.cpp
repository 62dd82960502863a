// Mean, extremes and uniformities of a grid of noisy values.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "analysis/grid_estimate.h"
#include "core/statistics.h"

namespace goniolux::analysis {

double quantileOf(std::vector<double> values, double fraction) {
  const double place = fraction * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::ptrdiff_t>(place);
  std::nth_element(values.begin(), values.begin() + below, values.end());
  const double low = values[static_cast<std::size_t>(below)];
  if (below + 1 == std::ssize(values)) return low;
  const double high = *std::min_element(values.begin() + below + 1, values.end());
  return low + (place - static_cast<double>(below)) * (high - low);
}

void summarise(const std::vector<std::vector<double>>& replicates, const Systematic& bias, double confidence,
               GridEstimate& e) {
  const std::size_t points = e.values.size();
  const double dof = static_cast<double>(replicates.size()) - 1;
  const double quantile = core::studentQuantile(dof, confidence);
  const auto count = static_cast<double>(points);

  std::vector<double> means(replicates.size());
  for (std::size_t r = 0; r < replicates.size(); ++r)
    means[r] = std::accumulate(replicates[r].begin(), replicates[r].end(), 0.0) / count;
  const core::ReplicateMean mean = core::replicateMean(means);
  e.mean = {mean.mean, quantile * mean.standardError, {}};
  for (const auto& [cause, bounds] : bias)
    e.mean.systematic[cause] = std::accumulate(bounds.begin(), bounds.end(), 0.0) / count;

  // The minimum of noisy values is low by itself. Its interval: from the lowest lower end to the lowest upper end of
  // intervals that hold together for all points that may be the minimum (Sidak). The maximum is the minimum of the
  // negative.
  const auto extreme = [&](double sign) {
    double upper = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < points; ++i) upper = std::min(upper, sign * e.values[i] + e.statistical[i]);
    std::size_t candidates = 0;
    for (std::size_t i = 0; i < points; ++i) candidates += sign * e.values[i] - 2 * e.statistical[i] <= upper;
    const double together = core::studentQuantile(dof, core::sidak(confidence, candidates)) / quantile;
    double low = std::numeric_limits<double>::infinity(), high = low, value = low;
    std::size_t where = 0;
    for (std::size_t i = 0; i < points; ++i) {
      low = std::min(low, sign * e.values[i] - together * e.statistical[i]);
      high = std::min(high, sign * e.values[i] + together * e.statistical[i]);
      if (sign * e.values[i] < value) value = sign * e.values[i], where = i;
    }
    if (sign > 0) low = std::max(low, std::min(value, 0.0));  // light is not negative
    core::Estimate result{sign * value, std::max(value - low, high - value), {}};
    for (const auto& [cause, bounds] : bias) result.systematic[cause] = bounds[where];
    return result;
  };
  e.minimum = extreme(1);
  e.maximum = extreme(-1);

  // A percentile grows with every value, so where no value is off by more than its half-width, it lies between the
  // percentiles of all values less and plus theirs. The half-widths are those that hold together for all points that
  // may be at the percentile (Sidak).
  const auto percentile = [&](double fraction) {
    core::Estimate result{quantileOf(e.values, fraction), 0, {}};
    const auto reach = [&](const std::vector<double>& halfWidths) {
      std::vector<double> low = e.values, high = e.values;
      for (std::size_t i = 0; i < points; ++i) low[i] -= halfWidths[i], high[i] += halfWidths[i];
      return std::max({quantileOf(std::move(high), fraction) - result.value,
                       result.value - quantileOf(std::move(low), fraction), 0.0});
    };
    const double alone = reach(e.statistical);
    std::size_t candidates = 0;
    for (std::size_t i = 0; i < points; ++i)
      candidates += std::abs(e.values[i] - result.value) <= 2 * e.statistical[i] + alone;
    const double together = core::studentQuantile(dof, core::sidak(confidence, std::max<std::size_t>(candidates, 1)));
    std::vector<double> widths = e.statistical;
    for (double& width : widths) width *= together / quantile;
    result.statistical = reach(widths);
    for (const auto& [cause, bounds] : bias) result.systematic[cause] = reach(bounds);
    return result;
  };
  for (const int percent : statedPercentiles) e.percentiles[percent] = percentile(0.01 * percent);

  const auto ratio = [](const core::Estimate& a, const core::Estimate& b) {
    if (b.value == 0) return core::Estimate{};
    const double value = a.value / b.value;
    const auto relative = [](double part, double of) { return of != 0 ? part / std::abs(of) : 0.0; };
    core::Estimate r{
        value, std::abs(value) * (relative(a.statistical, a.value) + relative(b.statistical, b.value)), {}};
    for (const auto* part : {&a, &b})
      for (const auto& [cause, bound] : part->systematic)
        r.systematic[cause] += std::abs(value) * relative(bound, part->value);
    return r;
  };
  e.u0 = ratio(e.minimum, e.mean);
  e.ud = ratio(e.minimum, e.maximum);
}

}  // namespace goniolux::analysis
