#include "analysis/grid_estimate.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>

#include "core/parallel.h"
#include "core/random.h"
#include "core/statistics.h"

namespace goniolux::analysis {
namespace {

constexpr std::uint32_t pilotSamples = 8;
constexpr std::uint32_t mostSamples = 1u << 20;  // per replicate and point
constexpr double largestFirstGrowth = 1024;      // of a point's samples, from the pilot to the first estimate
constexpr double largestGrowth = 8;              // from then on
constexpr int mostRounds = 12;
constexpr double shareAsked = 0.95;

using Replicates = std::vector<std::vector<double>>;  // [replicate][point]

/// Samples rounded up to a number that a net in base 2 fills well: at most two significant bits beyond the first.
std::uint32_t netSize(double samples) {
  const double wanted = std::clamp(std::ceil(samples), 1.0, static_cast<double>(mostSamples));
  const double step = std::exp2(std::max(0.0, std::floor(std::log2(wanted)) - 2));
  return static_cast<std::uint32_t>(std::ceil(wanted / step) * step);
}

class GridRun {
 public:
  GridRun(const solver::Solver& solver, const std::vector<solver::Receiver>& receivers, std::uint64_t key,
          const GridAccuracy& accuracy)
      : solver_(solver),
        receivers_(receivers),
        key_(key),
        accuracy_(accuracy),
        quantile_(core::studentQuantile(replicateCount - 1, accuracy.confidence)),
        plans_(receivers.size()),
        samples_(receivers.size(), pilotSamples),
        replicates_(replicateCount, std::vector<double>(receivers.size())) {
    // A point's own half-width scatters (chi with 15 degrees of freedom); so that 95 % of them end within what was
    // asked, the expected one must stay below it by this factor.
    margin_ = std::sqrt(chiSquared95 / (replicateCount - 1));
  }

  void plan() {
    core::parallelFor(receivers_.size(), 8, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) plans_[i] = solver_.plan(receivers_[i], pointKey(i, 0));
    });
  }

  /// Fresh replicates of the points named. False when it was interrupted: then nothing has changed.
  bool round(const std::vector<std::size_t>& points, core::ProgressSink& progress) {
    ++round_;
    Replicates fresh(replicateCount, std::vector<double>(points.size()));
    core::parallelFor(points.size(), 4, [&](std::size_t begin, std::size_t end) {
      for (std::size_t j = begin; j < end && !progress.cancelled(); ++j) {
        const std::size_t i = points[j];
        for (std::uint64_t r = 0; r < replicateCount; ++r)
          fresh[r][j] =
              solver_.illuminance(receivers_[i], *plans_[i], core::combine(pointKey(i, round_), r), samples_[i])[1];
      }
    });
    if (progress.cancelled()) return false;
    for (std::size_t j = 0; j < points.size(); ++j)
      for (std::size_t r = 0; r < replicateCount; ++r) replicates_[r][points[j]] = fresh[r][j];
    return true;
  }

  GridEstimate estimate() const {
    GridEstimate e;
    const std::size_t n = receivers_.size();
    e.values.resize(n), e.statistical.resize(n), e.quadrature.resize(n);
    std::vector<double> one(replicateCount);
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t r = 0; r < replicateCount; ++r) one[r] = replicates_[r][i];
      const core::ReplicateMean m = core::replicateMean(one);
      e.values[i] = m.mean;
      e.statistical[i] = quantile_ * m.standardError;
      e.quadrature[i] = plans_[i]->quadratureBound;
      e.samples += static_cast<std::uint64_t>(samples_[i]) * replicateCount;
    }
    summarise(replicates_, e.quadrature, accuracy_.confidence, e);
    std::size_t within = 0;
    for (std::size_t i = 0; i < n; ++i) within += halfWidth(e, i) <= allowed(e, e.values[i]);
    e.shareWithin = static_cast<double>(within) / static_cast<double>(n);
    e.reached = pointsReached(e) && extremesReached(e);
    return e;
  }

  bool pointsReached(const GridEstimate& e) const {
    return e.shareWithin >= shareAsked && e.mean.halfWidth() <= allowed(e, e.mean.value);
  }
  bool extremesReached(const GridEstimate& e) const {
    return e.minimum.halfWidth() <= allowed(e, e.minimum.value) &&
           (e.u0.value <= 0.1 || e.u0.halfWidth() <= accuracy_.uniformity * e.u0.value);
  }

  /// Sets the samples that points need for the accuracy asked for; returns the points to estimate anew.
  std::vector<std::size_t> refine(const GridEstimate& e) {
    const std::size_t n = receivers_.size();
    // Spread per sample, each point's own steadied by that of all (relative): 15 degrees of freedom scatter.
    std::vector<double> need(n);
    double pooled = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const double ratio = e.statistical[i] / roomFor(e, i);
      need[i] = ratio * ratio * samples_[i];
      pooled += need[i] / static_cast<double>(n);
    }
    // After the pilot every point is estimated; after that only those that are not yet good enough are estimated anew,
    // or all of them when it is the mean that is not.
    const bool all = round_ == 1 || e.mean.halfWidth() > allowed(e, e.mean.value);
    std::vector<std::size_t> points;
    for (std::size_t i = 0; i < n; ++i) {
      if (!all && halfWidth(e, i) <= allowed(e, e.values[i])) continue;
      const double steadied = 0.75 * need[i] + 0.25 * std::min(pooled, 4 * need[i]);
      const double growth = round_ == 1 ? largestFirstGrowth : largestGrowth;
      const double wanted = std::min(steadied * margin_ * margin_, growth * samples_[i]);
      samples_[i] = netSize(std::max(wanted, round_ == 1 ? 1.0 : 1.25 * samples_[i]));
      points.push_back(i);
    }
    return points;
  }

  /// More samples for the points that may be the minimum; returns them.
  std::vector<std::size_t> refineMinimum(const GridEstimate& e) {
    const double room = std::min(allowed(e, e.minimum.value), 0.7 * accuracy_.uniformity * e.minimum.value);
    double growth = std::pow(1.15 * e.minimum.halfWidth() / std::max(room, 1e-300), 2);
    growth = std::clamp(growth, 1.5, largestGrowth);
    double upper = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < receivers_.size(); ++i) upper = std::min(upper, e.values[i] + halfWidth(e, i));
    std::vector<std::size_t> points;
    for (std::size_t i = 0; i < receivers_.size(); ++i)
      if (e.values[i] - 2 * halfWidth(e, i) <= upper) {
        points.push_back(i);
        samples_[i] = netSize(samples_[i] * growth);
      }
    return points;
  }

 private:
  static constexpr double chiSquared95 = 24.996;  // 95 % point with 15 degrees of freedom (NIST handbook, 1.3.6.7.4)

  [[nodiscard]] std::uint64_t pointKey(std::size_t point, std::uint64_t round) const {
    return core::combine(core::combine(key_, point), round);
  }
  [[nodiscard]] static double halfWidth(const GridEstimate& e, std::size_t i) {
    return e.statistical[i] + e.quadrature[i];
  }
  /// The half-width allowed for a value: the asked share of it, or of a tenth of the grid's mean where it is below
  /// that.
  [[nodiscard]] double allowed(const GridEstimate& e, double value) const {
    return std::max(accuracy_.relative * std::max(std::abs(value), 0.1 * std::abs(e.mean.value)),
                    accuracy_.absoluteFloor);
  }
  /// What of it is left for noise at a point.
  [[nodiscard]] double roomFor(const GridEstimate& e, std::size_t i) const {
    const double all = allowed(e, e.values[i]);
    return std::max(all - e.quadrature[i], 0.1 * all);
  }

  const solver::Solver& solver_;
  const std::vector<solver::Receiver>& receivers_;
  std::uint64_t key_;
  GridAccuracy accuracy_;
  double quantile_, margin_;
  std::vector<std::unique_ptr<solver::ReceiverPlan>> plans_;
  std::vector<std::uint32_t> samples_;
  Replicates replicates_;
  std::uint64_t round_ = 0;
};

}  // namespace

GridEstimate estimateGrid(const solver::Solver& solver, const std::vector<solver::Receiver>& receivers,
                          std::uint64_t key, const GridAccuracy& accuracy, const EffortLimit& limit,
                          core::ProgressSink& progress, const std::string& task) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  const auto seconds = [&] { return std::chrono::duration<double>(Clock::now() - start).count(); };

  GridRun run(solver, receivers, key, accuracy);
  progress.progress(task, 0, "looking at the light that each point sees");
  run.plan();
  std::vector<std::size_t> points(receivers.size());
  std::iota(points.begin(), points.end(), std::size_t{0});
  run.round(points, progress);
  GridEstimate estimate = run.estimate();
  for (int round = 1; round < mostRounds && !progress.cancelled() && seconds() < limit.secondsLeft; ++round) {
    // The pilot is never the answer: it decides, fresh samples estimate.
    if (round > 1 && estimate.reached) break;
    points = round == 1 || !run.pointsReached(estimate) ? run.refine(estimate) : run.refineMinimum(estimate);
    progress.progress(
        task, std::min(0.95, estimate.shareWithin * 0.9),
        fmt::format("points within {:g} %: {:.0f} %", 100 * accuracy.relative, 100 * estimate.shareWithin));
    if (!run.round(points, progress)) break;
    estimate = run.estimate();
  }
  progress.progress(task, 1,
                    fmt::format("points within {:g} %: {:.0f} %", 100 * accuracy.relative, 100 * estimate.shareWithin));
  return estimate;
}

void summarise(const Replicates& replicates, const std::vector<double>& bias, double confidence, GridEstimate& e) {
  const std::size_t points = e.values.size();
  const double dof = static_cast<double>(replicates.size()) - 1;
  const double quantile = core::studentQuantile(dof, confidence);
  const auto count = static_cast<double>(points);

  std::vector<double> means(replicates.size());
  for (std::size_t r = 0; r < replicates.size(); ++r)
    means[r] = std::accumulate(replicates[r].begin(), replicates[r].end(), 0.0) / count;
  const core::ReplicateMean mean = core::replicateMean(means);
  const double meanBias = std::accumulate(bias.begin(), bias.end(), 0.0) / count;
  e.mean = {mean.mean, quantile * mean.standardError, {{"source_subdivision", meanBias}}};

  // The minimum of noisy values is low by itself. Its interval: from the lowest lower end to the lowest upper end of
  // intervals that hold together for all points that may be the minimum (Sidak). The maximum is the minimum of the
  // negative.
  const auto extreme = [&](double sign) {
    double upper = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < points; ++i) upper = std::min(upper, sign * e.values[i] + e.statistical[i]);
    std::size_t candidates = 0;
    for (std::size_t i = 0; i < points; ++i) candidates += sign * e.values[i] - 2 * e.statistical[i] <= upper;
    const double together = core::studentQuantile(dof, core::sidak(confidence, candidates)) / quantile;
    double low = std::numeric_limits<double>::infinity(), high = low, value = low, itsBias = 0;
    for (std::size_t i = 0; i < points; ++i) {
      low = std::min(low, sign * e.values[i] - together * e.statistical[i]);
      high = std::min(high, sign * e.values[i] + together * e.statistical[i]);
      if (sign * e.values[i] < value) value = sign * e.values[i], itsBias = bias[i];
    }
    return core::Estimate{sign * value, std::max(value - low, high - value), {{"source_subdivision", itsBias}}};
  };
  e.minimum = extreme(1);
  e.maximum = extreme(-1);

  const auto ratio = [](const core::Estimate& a, const core::Estimate& b) {
    if (b.value == 0) return core::Estimate{};
    const double value = a.value / b.value;
    const auto relative = [](double part, double of) { return of != 0 ? part / std::abs(of) : 0.0; };
    core::Estimate r{
        value, std::abs(value) * (relative(a.statistical, a.value) + relative(b.statistical, b.value)), {}};
    r.systematic["source_subdivision"] = std::abs(value) * (relative(a.halfWidth() - a.statistical, a.value) +
                                                            relative(b.halfWidth() - b.statistical, b.value));
    return r;
  };
  e.u0 = ratio(e.minimum, e.mean);
  e.ud = ratio(e.minimum, e.maximum);
}

}  // namespace goniolux::analysis
