#include "analysis/grid_estimate.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>

#include "analysis/remainder.h"
#include "core/parallel.h"
#include "core/random.h"
#include "core/statistics.h"

namespace goniolux::analysis {
namespace {

constexpr std::uint32_t pilotSamples = 8;
constexpr std::size_t pilotPoints = 64;    // at least, when there are so many; the others go by their neighbours
constexpr double remainderShare = 0.0625;  // of the accuracy asked for, that the common error of all points may take
constexpr std::uint32_t mostSamples = 1u << 20;  // per replicate and point
constexpr double largestFirstGrowth = 1024;      // of a point's samples, from the pilot to the first estimate
constexpr double largestGrowth = 8;              // from then on
constexpr double spreadShare = 0.5;              // of the accuracy asked for, that an uneven remainder may take
constexpr double commonShare = 0.7;
constexpr double wholeGrowth = 4;   // samples of paths that go to their own end, for the same spread
constexpr double paceMargin = 0.8;  // of the time left that a round may plan for
constexpr int mostRounds = 12;
constexpr std::uint64_t remainderKey = 0x4e3a;
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
  GridRun(const solver::Solver& solver, const Quantity& quantity, const std::vector<solver::Receiver>& receivers,
          std::uint64_t key, const GridAccuracy& accuracy)
      : solver_(solver),
        quantity_(quantity),
        receivers_(receivers),
        key_(key),
        accuracy_(accuracy),
        quantile_(core::studentQuantile(replicateCount - 1, accuracy.confidence)),
        plans_(receivers.size()),
        samples_(receivers.size(), pilotSamples),
        used_(receivers.size(), 0),
        whole_(receivers.size(), receivers.size() < fewPoints && !solver.isUnbiased() ? 1 : 0),
        gathered_(replicateCount, std::vector<double>(receivers.size())),
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
    const double start = core::wallSeconds();
    Replicates fresh(replicateCount, std::vector<double>(points.size()));
    core::parallelFor(points.size(), 4, [&](std::size_t begin, std::size_t end) {
      for (std::size_t j = begin; j < end && !progress.cancelled(); ++j) {
        const std::size_t i = points[j];
        for (std::uint64_t r = 0; r < replicateCount; ++r) {
          const std::uint64_t key = core::combine(pointKey(i, round_), r);
          fresh[r][j] = of(whole_[i] ? solver_.wholeIlluminance(receivers_[i], *plans_[i], key, samples_[i])
                                     : solver_.illuminance(receivers_[i], *plans_[i], key, samples_[i]));
        }
      }
    });
    if (progress.cancelled()) return false;
    double taken = 0;
    for (const std::size_t i : points) taken += samples_[i];
    perSecond_ = taken / std::max(core::wallSeconds() - start, 1e-4);
    for (const std::size_t i : points) used_[i] = samples_[i];
    for (std::size_t j = 0; j < points.size(); ++j)
      for (std::size_t r = 0; r < replicateCount; ++r) {
        const std::size_t i = points[j];
        gathered_[r][i] = fresh[r][j];
        replicates_[r][i] = fresh[r][j] + (whole_[i] ? 0 : remainder_.factors[r] * of(plans_[i]->interreflected));
      }
    return true;
  }

  /// Of the points and samples that are wanted, what the time allows, by the pace of the last round: fewer samples, as
  /// long as a point gets more than it has. So a time limit is kept, and what is asked last is what is left undone.
  std::vector<std::size_t> within(const std::vector<std::size_t>& points, double secondsLeft) {
    double wanted = 0;
    for (const std::size_t i : points) wanted += samples_[i];
    const double possible = paceMargin * perSecond_ * secondsLeft;
    if (wanted <= possible) return points;
    std::vector<std::size_t> kept;
    for (const std::size_t i : points) {
      samples_[i] = std::max(1u, static_cast<std::uint32_t>(samples_[i] * possible / wanted));
      if (samples_[i] > used_[i] || !everyPointIsKnown_)
        kept.push_back(i);
      else
        samples_[i] = used_[i];
    }
    return kept;
  }

  /// A first round at some of the points; sets the samples that each point needs, between them by the needier
  /// neighbour. False when it was interrupted.
  bool pilot(core::ProgressSink& progress) {
    const std::size_t n = receivers_.size(), step = std::max<std::size_t>(1, n / pilotPoints);
    remainder_.factors.assign(replicateCount, 0.0);
    std::vector<std::size_t> chosen;
    for (std::size_t i = 0; i < n; i += step) chosen.push_back(i);
    if (!round(chosen, progress)) return false;

    std::vector<double> value(chosen.size()), half(chosen.size());
    double mean = 0;
    for (std::size_t j = 0; j < chosen.size(); ++j) {
      std::array<double, replicateCount> one{};
      for (std::size_t r = 0; r < replicateCount; ++r) one[r] = replicates_[r][chosen[j]];
      const core::ReplicateMean m = core::replicateMean(one);
      value[j] = m.mean;
      half[j] = quantile_ * m.standardError;
      mean += m.mean / static_cast<double>(chosen.size());
    }
    roughMean_ = mean;
    std::vector<double> need(chosen.size());
    double pooled = 0;
    for (std::size_t j = 0; j < chosen.size(); ++j) {
      const double ratio = half[j] / roomFor(value[j], mean, of(plans_[chosen[j]]->quadratureBound));
      need[j] = ratio * ratio * pilotSamples;
      pooled += need[j] / static_cast<double>(chosen.size());
    }
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t j = i / step, next = std::min(j + 1, chosen.size() - 1);
      const double own = i % step == 0 ? need[j] : std::max(need[j], need[next]);
      samples_[i] =
          netSize(std::clamp(steadied(own, pooled) * margin_ * margin_, 1.0, largestFirstGrowth * pilotSamples));
    }
    return true;
  }

  /// Measures what the solver misses; rounds after this add it.
  void findRemainder(double secondsLeft, core::ProgressSink& progress) {
    if (std::all_of(whole_.begin(), whole_.end(), [](char whole) { return whole != 0; })) return;
    remainder_ = estimateRemainder(solver_, quantity_, receivers_, plans_, core::combine(key_, remainderKey),
                                   remainderShare * allowed(roughMean_, roughMean_), accuracy_.confidence, secondsLeft,
                                   progress);
    // A solution that is wrong by so different amounts over the grid is no help: paths to their own end instead.
    double interreflected = 0;
    for (const auto& plan : plans_) interreflected += of(plan->interreflected) / static_cast<double>(plans_.size());
    if (remainder_.spread * interreflected <= spreadShare * allowed(roughMean_, roughMean_)) return;
    whole_.assign(whole_.size(), 1);
    samples_.assign(samples_.size(), pilotSamples);
    pilot(progress);  // what the points need is another matter now
  }

  void everyPointIsKnown() { everyPointIsKnown_ = true; }

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
      e.quadrature[i] = of(plans_[i]->quadratureBound);
      e.samples += static_cast<std::uint64_t>(samples_[i]) * replicateCount;
    }
    e.interreflection.resize(n);
    for (std::size_t i = 0; i < n; ++i)
      e.interreflection[i] = whole_[i] ? 0 : remainder_.spread * of(plans_[i]->interreflected);
    Systematic bias{{"source_subdivision", e.quadrature}};
    if (!solver_.isUnbiased()) bias["interreflection"] = e.interreflection;
    summarise(replicates_, bias, accuracy_.confidence, e);
    e.samples += remainder_.paths;
    std::size_t within = 0;
    for (std::size_t i = 0; i < n; ++i) within += halfWidth(e, i) <= allowed(e.values[i], e.mean.value);
    e.shareWithin = static_cast<double>(within) / static_cast<double>(n);
    e.reached = pointsReached(e) && extremesReached(e);
    return e;
  }

  bool pointsReached(const GridEstimate& e) const {
    return e.shareWithin >= shareAsked && e.mean.halfWidth() <= allowed(e.mean.value, e.mean.value);
  }
  bool extremesReached(const GridEstimate& e) const {
    return minimumIsWhole(e) && e.minimum.halfWidth() <= allowed(e.minimum.value, e.mean.value) &&
           (e.u0.value <= 0.1 || e.u0.halfWidth() <= accuracy_.uniformity * e.u0.value);
  }

  /// Sets the samples that points need for the accuracy asked for; returns the points to estimate anew.
  std::vector<std::size_t> refine(const GridEstimate& e) {
    const std::size_t n = receivers_.size();
    // Spread per sample, each point's own steadied by that of all (relative): 15 degrees of freedom scatter.
    std::vector<double> need(n);
    double pooled = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const double ratio = e.statistical[i] / roomFor(e.values[i], e.mean.value, systematic(e, i));
      need[i] = ratio * ratio * samples_[i];
      pooled += need[i] / static_cast<double>(n);
    }
    // Only the points that are not yet good enough are estimated anew, or all of them when it is the mean that is not.
    // More samples do not help against the noise of what all points have in common.
    const double room = allowed(e.mean.value, e.mean.value);
    const bool all = e.mean.halfWidth() > room && commonNoise() < commonShare * room;
    std::vector<std::size_t> points;
    for (std::size_t i = 0; i < n; ++i) {
      if (!all && halfWidth(e, i) <= allowed(e.values[i], e.mean.value)) continue;
      const double wanted = std::min(steadied(need[i], pooled) * margin_ * margin_, largestGrowth * samples_[i]);
      samples_[i] = netSize(std::max(wanted, 1.25 * samples_[i]));
      points.push_back(i);
    }
    return points;
  }

  /// The points that may be the minimum.
  std::vector<std::size_t> minimumCandidates(const GridEstimate& e) const {
    double upper = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < receivers_.size(); ++i) upper = std::min(upper, e.values[i] + halfWidth(e, i));
    std::vector<std::size_t> points;
    for (std::size_t i = 0; i < receivers_.size(); ++i)
      if (e.values[i] - 2 * halfWidth(e, i) <= upper) points.push_back(i);
    return points;
  }
  /// What a light solution misses on average may be far from what it misses in the darkest corner, so that point is
  /// calculated without it.
  bool minimumIsWhole(const GridEstimate& e) const {
    if (solver_.isUnbiased()) return true;
    const auto lowest = std::min_element(e.values.begin(), e.values.end()) - e.values.begin();
    return whole_[static_cast<std::size_t>(lowest)] != 0;
  }

  /// True when it is the mean's noise that keeps the uniformity from what was asked.
  bool meanSpoilsUniformity(const GridEstimate& e) const {
    const double room = 0.5 * accuracy_.uniformity * e.mean.value;
    return e.u0.value > 0.1 && e.mean.statistical > room && commonNoise() < commonShare * room;
  }

  /// More samples for the points that may be the minimum, or for all where the mean spoils the uniformity; returns
  /// them.
  std::vector<std::size_t> refineMinimum(const GridEstimate& e) {
    if (meanSpoilsUniformity(e)) {
      const double ratio = 1.15 * e.mean.statistical / (0.5 * accuracy_.uniformity * e.mean.value);
      std::vector<std::size_t> points(receivers_.size());
      std::iota(points.begin(), points.end(), std::size_t{0});
      for (std::uint32_t& samples : samples_)
        samples = netSize(samples * std::clamp(ratio * ratio, 1.25, largestGrowth));
      return points;
    }
    const double room = std::min(allowed(e.minimum.value, e.mean.value), 0.7 * accuracy_.uniformity * e.minimum.value);
    double growth = std::pow(1.15 * e.minimum.halfWidth() / std::max(room, 1e-300), 2);
    growth = std::clamp(growth, 1.5, largestGrowth);
    const std::vector<std::size_t> points = minimumCandidates(e);
    for (const std::size_t i : points) {
      const bool fresh = !solver_.isUnbiased() && !whole_[i];
      whole_[i] = fresh ? 1 : whole_[i];
      samples_[i] = netSize(samples_[i] * (fresh ? wholeGrowth : growth));
    }
    return points;
  }

 private:
  static constexpr double chiSquared95 = 24.996;  // 95 % point with 15 degrees of freedom (NIST handbook, 1.3.6.7.4)

  /// Half-width of what the measure of the remainder adds to all points alike.
  [[nodiscard]] double commonNoise() const {
    double interreflected = 0;
    for (const auto& plan : plans_) interreflected += of(plan->interreflected) / static_cast<double>(plans_.size());
    return quantile_ * core::replicateMean(remainder_.factors).standardError * interreflected;
  }
  /// The quantity's part of a response.
  [[nodiscard]] double of(const solver::Response& response) const {
    return quantity_.factor * response[quantity_.channel];
  }
  [[nodiscard]] std::uint64_t pointKey(std::size_t point, std::uint64_t round) const {
    return core::combine(core::combine(key_, point), round);
  }
  [[nodiscard]] static double systematic(const GridEstimate& e, std::size_t i) {
    return e.quadrature[i] + e.interreflection[i];
  }
  [[nodiscard]] static double halfWidth(const GridEstimate& e, std::size_t i) {
    return e.statistical[i] + systematic(e, i);
  }
  /// The half-width allowed for a value: the asked share of it, or of a tenth of the grid's mean where it is below
  /// that.
  [[nodiscard]] double allowed(double value, double mean) const {
    return std::max(accuracy_.relative * std::max(std::abs(value), 0.1 * std::abs(mean)), accuracy_.absoluteFloor);
  }
  /// What of it is left for noise.
  [[nodiscard]] double roomFor(double value, double mean, double systematic) const {
    const double all = allowed(value, mean);
    return std::max(all - systematic, 0.1 * all);
  }
  [[nodiscard]] static double steadied(double own, double pooled) {
    return 0.75 * own + 0.25 * std::min(pooled, 4 * own);
  }

  const solver::Solver& solver_;
  const Quantity& quantity_;
  const std::vector<solver::Receiver>& receivers_;
  std::uint64_t key_;
  GridAccuracy accuracy_;
  double quantile_, margin_, roughMean_ = 0;
  std::vector<std::unique_ptr<solver::ReceiverPlan>> plans_;
  std::vector<std::uint32_t> samples_;
  std::vector<std::uint32_t> used_;  // those of the replicates that are kept
  bool everyPointIsKnown_ = false;   // the first full round is done
  double perSecond_ = 1;             // samples of all replicates, in the last round
  std::vector<char> whole_;          // points that are calculated without the light solution
  Replicates gathered_;              // as the solver estimates them
  Replicates replicates_;            // the same with what it misses added
  Remainder remainder_;
  std::uint64_t round_ = 0;
};

/// What an interrupted run has before its first estimate: no numbers at all.
GridEstimate nothingYet(std::size_t points) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  GridEstimate e;
  e.values.assign(points, nan);
  e.statistical = e.quadrature = e.interreflection = e.values;
  for (core::Estimate* summary : {&e.mean, &e.minimum, &e.maximum, &e.u0, &e.ud}) *summary = {nan, nan, {}};
  return e;
}

}  // namespace

GridEstimate estimateGrid(const solver::Solver& solver, const Quantity& quantity,
                          const std::vector<solver::Receiver>& receivers, std::uint64_t key,
                          const GridAccuracy& accuracy, const EffortLimit& limit, core::ProgressSink& progress,
                          const std::string& task, const GridObserver& partial) {
  const double start = core::wallSeconds();
  const auto seconds = [&] { return core::wallSeconds() - start; };

  GridRun run(solver, quantity, receivers, key, accuracy);
  progress.progress(task, 0, "looking at the light that each point sees");
  run.plan();
  std::vector<std::size_t> points(receivers.size());
  std::iota(points.begin(), points.end(), std::size_t{0});
  // The pilot is never the answer: it decides, fresh samples estimate.
  if (run.pilot(progress)) {
    progress.progress(task, 0.1, "what the light solution misses");
    run.findRemainder(limit.secondsLeft - seconds(), progress);
  }
  GridEstimate estimate = nothingYet(receivers.size());
  for (int round = 1; round < mostRounds; ++round) {
    points = run.within(points, limit.secondsLeft - seconds());
    if (points.empty() || !run.round(points, progress)) break;
    run.everyPointIsKnown();
    estimate = run.estimate();
    progress.progress(
        task, std::min(0.95, estimate.shareWithin * 0.9),
        fmt::format("points within {:g} %: {:.0f} %", 100 * accuracy.relative, 100 * estimate.shareWithin));
    if (estimate.reached || seconds() >= limit.secondsLeft) break;
    if (partial) partial(estimate);
    points = run.pointsReached(estimate) ? run.refineMinimum(estimate) : run.refine(estimate);
  }
  progress.progress(task, 1,
                    fmt::format("points within {:g} %: {:.0f} %", 100 * accuracy.relative, 100 * estimate.shareWithin));
  return estimate;
}

}  // namespace goniolux::analysis
