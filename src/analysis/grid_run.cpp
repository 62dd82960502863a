#include "analysis/grid_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/random.h"
#include "core/statistics.h"
#include "core/work_items.h"

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
constexpr std::uint64_t remainderKey = 0x4e3a;
constexpr double shareAsked = 0.95;
constexpr double chiSquared95 = 24.996;  // 95 % point with 15 degrees of freedom (NIST handbook, 1.3.6.7.4)

/// Samples rounded up to a number that a net in base 2 fills well: at most two significant bits beyond the first.
std::uint32_t netSize(double samples) {
  const double wanted = std::clamp(std::ceil(samples), 1.0, static_cast<double>(mostSamples));
  const double step = std::exp2(std::max(0.0, std::floor(std::log2(wanted)) - 2));
  return static_cast<std::uint32_t>(std::ceil(wanted / step) * step);
}

double systematic(const GridEstimate& e, std::size_t i) {
  return e.quadrature[i] + e.interreflection[i];
}
double halfWidth(const GridEstimate& e, std::size_t i) {
  return e.statistical[i] + systematic(e, i);
}
double steadied(double own, double pooled) {
  return 0.75 * own + 0.25 * std::min(pooled, 4 * own);
}

}  // namespace

GridRun::GridRun(const solver::Solver& solver, const Quantity& quantity, const std::vector<solver::Receiver>& receivers,
                 std::uint64_t key, const GridAccuracy& accuracy, core::Keeping keeping)
    : solver_(solver),
      quantity_(quantity),
      receivers_(receivers),
      key_(key),
      accuracy_(accuracy),
      keeping_(std::move(keeping)),
      quantile_(core::studentQuantile(replicateCount - 1, accuracy.confidence)),
      plans_(receivers.size()),
      samples_(receivers.size(), pilotSamples),
      used_(receivers.size(), 0),
      whole_(receivers.size(), receivers.size() < fewPoints && !solver.isUnbiased() ? 1 : 0),
      replicates_(replicateCount, std::vector<double>(receivers.size())) {
  // A point's own half-width scatters (chi with 15 degrees of freedom); so that 95 % of them end within what was
  // asked, the expected one must stay below it by this factor.
  margin_ = std::sqrt(chiSquared95 / (replicateCount - 1));
}

bool GridRun::plan(const core::ProgressSink& progress) {
  const auto look = [&](std::size_t i) { plans_[i] = solver_.plan(receivers_[i], pointKey(i, 0)); };
  return core::doItems({receivers_.size(), 8, look}, {}, progress).complete;
}

bool GridRun::pilot(const core::ProgressSink& progress) {
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

void GridRun::findRemainder(double secondsLeft, const core::ProgressSink& progress) {
  if (std::all_of(whole_.begin(), whole_.end(), [](char whole) { return whole != 0; })) return;
  remainder_ = estimateRemainder(solver_, quantity_, receivers_, plans_, core::combine(key_, remainderKey),
                                 remainderShare * allowed(roughMean_, roughMean_), accuracy_.confidence, secondsLeft,
                                 progress, keeping_.part("remainder"));
  // A solution that is wrong by so different amounts over the grid is no help: paths to their own end instead.
  double interreflected = 0;
  for (const auto& plan : plans_) interreflected += of(plan->interreflected) / static_cast<double>(plans_.size());
  if (remainder_.spread * interreflected <= spreadShare * allowed(roughMean_, roughMean_)) return;
  whole_.assign(whole_.size(), 1);
  samples_.assign(samples_.size(), pilotSamples);
  pilot(progress);  // what the points need is another matter now
}

std::vector<std::size_t> GridRun::within(const std::vector<std::size_t>& points, double secondsLeft) {
  const std::string part = keeping_.part(fmt::format("points of round {}", round_ + 1)).name;
  if (std::vector<std::size_t> before = chosenBefore(part, points); !before.empty()) return before;
  std::vector<std::size_t> chosen = cut(points, secondsLeft);
  if (keeping_.log != nullptr && !chosen.empty()) {
    std::string bytes;
    for (const std::size_t i : chosen) {
      core::put(bytes, static_cast<std::uint64_t>(i));
      core::put(bytes, samples_[i]);
    }
    keeping_.log->add(part, bytes);
  }
  return chosen;
}

std::vector<std::size_t> GridRun::cut(const std::vector<std::size_t>& points, double secondsLeft) {
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

// The points of a round as an interrupted run chose them, with their samples: the clock had a say in it.
std::vector<std::size_t> GridRun::chosenBefore(const std::string& part, const std::vector<std::size_t>& points) {
  std::vector<std::size_t> chosen;
  if (keeping_.log == nullptr) return chosen;
  keeping_.log->recover(part, [&](std::string_view bytes) {
    std::uint64_t i = 0;
    std::uint32_t samples = 0;
    chosen.clear();
    for (const std::size_t point : points)
      if (everyPointIsKnown_) samples_[point] = used_[point];
    while (core::take(bytes, i) && core::take(bytes, samples) && i < samples_.size()) {
      chosen.push_back(i);
      samples_[i] = samples;
    }
  });
  return chosen;
}

bool GridRun::round(const std::vector<std::size_t>& points, const core::ProgressSink& progress) {
  ++round_;
  double taken = 0;
  for (const std::size_t i : points) taken += samples_[i];
  std::vector<std::vector<double>> fresh(replicateCount, std::vector<double>(points.size()));
  core::WorkItems items;
  items.count = points.size() * replicateCount;
  items.grain = 4 * replicateCount;
  items.work = [&](std::size_t item) {
    const std::size_t j = item / replicateCount, r = item % replicateCount, i = points[j];
    const std::uint64_t key = core::combine(pointKey(i, round_), r);
    fresh[r][j] = of(whole_[i] ? solver_.wholeIlluminance(receivers_[i], *plans_[i], key, samples_[i])
                               : solver_.illuminance(receivers_[i], *plans_[i], key, samples_[i]));
  };
  items.pack = [&](std::size_t item, std::string& bytes) {
    core::put(bytes, kindOf(points[item / replicateCount]));
    core::put(bytes, fresh[item % replicateCount][item / replicateCount]);
  };
  items.unpack = [&](std::size_t item, std::string_view bytes) {
    SampleKind kind;
    return core::take(bytes, kind) && kind == kindOf(points[item / replicateCount]) &&
           core::take(bytes, fresh[item % replicateCount][item / replicateCount]);
  };
  items.told = [&](double share) {
    if (told_) told_((taken_ + share * taken) / (taken_ + taken));
  };
  const core::WorkDone done = core::doItems(items, keeping_.part(fmt::format("round {}", round_)), progress);
  if (!done.complete) return false;
  taken_ += taken;
  perSecond_ = taken / std::max(done.wall_s, 1e-4);
  for (const std::size_t i : points) used_[i] = samples_[i];
  for (std::size_t j = 0; j < points.size(); ++j)
    for (std::size_t r = 0; r < replicateCount; ++r) {
      const std::size_t i = points[j];
      replicates_[r][i] = fresh[r][j] + (whole_[i] ? 0 : remainder_.factors[r] * of(plans_[i]->interreflected));
    }
  return true;
}

GridEstimate GridRun::estimate() const {
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

bool GridRun::pointsReached(const GridEstimate& e) const {
  return e.shareWithin >= shareAsked && e.mean.halfWidth() <= allowed(e.mean.value, e.mean.value);
}

bool GridRun::extremesReached(const GridEstimate& e) const {
  return minimumIsWhole(e) && e.minimum.halfWidth() <= allowed(e.minimum.value, e.mean.value) &&
         (e.u0.value <= 0.1 || e.u0.halfWidth() <= accuracy_.uniformity * e.u0.value);
}

std::vector<std::size_t> GridRun::refine(const GridEstimate& e) {
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

// The points that may be the minimum.
std::vector<std::size_t> GridRun::minimumCandidates(const GridEstimate& e) const {
  double upper = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < receivers_.size(); ++i) upper = std::min(upper, e.values[i] + halfWidth(e, i));
  std::vector<std::size_t> points;
  for (std::size_t i = 0; i < receivers_.size(); ++i)
    if (e.values[i] - 2 * halfWidth(e, i) <= upper) points.push_back(i);
  return points;
}

// What a light solution misses on average may be far from what it misses in the darkest corner, so that point is
// calculated without it.
bool GridRun::minimumIsWhole(const GridEstimate& e) const {
  if (solver_.isUnbiased()) return true;
  const auto lowest = std::min_element(e.values.begin(), e.values.end()) - e.values.begin();
  return whole_[static_cast<std::size_t>(lowest)] != 0;
}

// True when it is the mean's noise that keeps the uniformity from what was asked.
bool GridRun::meanSpoilsUniformity(const GridEstimate& e) const {
  const double room = 0.5 * accuracy_.uniformity * e.mean.value;
  return e.u0.value > 0.1 && e.mean.statistical > room && commonNoise() < commonShare * room;
}

std::vector<std::size_t> GridRun::refineMinimum(const GridEstimate& e) {
  if (meanSpoilsUniformity(e)) {
    const double ratio = 1.15 * e.mean.statistical / (0.5 * accuracy_.uniformity * e.mean.value);
    std::vector<std::size_t> points(receivers_.size());
    std::iota(points.begin(), points.end(), std::size_t{0});
    for (std::uint32_t& samples : samples_) samples = netSize(samples * std::clamp(ratio * ratio, 1.25, largestGrowth));
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

// Half-width of what the measure of the remainder adds to all points alike.
double GridRun::commonNoise() const {
  double interreflected = 0;
  for (const auto& plan : plans_) interreflected += of(plan->interreflected) / static_cast<double>(plans_.size());
  return quantile_ * core::replicateMean(remainder_.factors).standardError * interreflected;
}

std::uint64_t GridRun::pointKey(std::size_t point, std::uint64_t round) const {
  return core::combine(core::combine(key_, point), round);
}

// The half-width allowed for a value: the asked share of it, or of a tenth of the grid's mean where it is below that.
double GridRun::allowed(double value, double mean) const {
  return std::max(accuracy_.relative * std::max(std::abs(value), 0.1 * std::abs(mean)), accuracy_.absoluteFloor);
}

// What of it is left for noise.
double GridRun::roomFor(double value, double mean, double systematic) const {
  const double all = allowed(value, mean);
  return std::max(all - systematic, 0.1 * all);
}

}  // namespace goniolux::analysis
