#include "analysis/remainder.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numeric>

#include "analysis/grid_estimate.h"
#include "core/parallel.h"
#include "core/random.h"
#include "core/statistics.h"
#include "core/work_items.h"

namespace goniolux::analysis {
namespace {

constexpr std::size_t bands = 8;
constexpr std::uint32_t pilotPaths = 32;       // per replicate
constexpr std::uint32_t mostPaths = 1u << 15;  // per replicate
constexpr std::uint32_t pathsAtOnce = 2048;
constexpr std::uint64_t mostAttempts = 3;
constexpr double worthlessShare = 0.5;  // of the interreflected light: a solution that is so wrong is of no use
constexpr double timeShare = 0.3;       // of the time left
constexpr double f95 = 2.09;            // F distribution, 7 and 120 degrees of freedom, 95 % point
constexpr std::uint64_t pilotKey = 1, estimateKey = 2, shiftKey = 3;

struct Piece {
  std::uint64_t ofPaths = 0;  // of the round
  double missed = 0;          // mean of a path, lx
  std::array<double, bands> byBand{};
};

struct Round {
  double wall_s = 0;
  std::array<double, replicateCount> missed{};  // mean of a path, lx
  std::array<std::array<double, bands>, replicateCount> byBand{};
};

/// The points of a grid in eight groups that lie together, of about equal number: halved three times along the longer
/// side. By point: its group.
std::vector<std::size_t> bandsOf(const std::vector<solver::Receiver>& receivers) {
  std::vector<std::size_t> order(receivers.size()), band(receivers.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto halve = [&](auto&& self, std::size_t first, std::size_t last, std::size_t name,
                         std::size_t parts) -> void {
    if (parts == 1) {
      for (std::size_t i = first; i < last; ++i) band[order[i]] = name;
      return;
    }
    core::Vec3 low(1e300), high(-1e300);
    for (std::size_t i = first; i < last; ++i) {
      low = glm::min(low, receivers[order[i]].point);
      high = glm::max(high, receivers[order[i]].point);
    }
    const core::Vec3 d = high - low;
    const int axis = d.x >= d.y && d.x >= d.z ? 0 : d.y >= d.z ? 1 : 2;
    const std::size_t middle = (first + last) / 2;
    std::stable_sort(order.begin() + static_cast<std::ptrdiff_t>(first),
                     order.begin() + static_cast<std::ptrdiff_t>(last),
                     [&](std::size_t a, std::size_t b) { return receivers[a].point[axis] < receivers[b].point[axis]; });
    self(self, first, middle, name, parts / 2);
    self(self, middle, last, name + parts / 2, parts / 2);
  };
  halve(halve, 0, receivers.size(), 0, std::min(bands, std::bit_floor(std::max<std::size_t>(receivers.size(), 1))));
  return band;
}

/// What the bands differ by beyond their own noise, lx: twice that standard deviation; 0 when it is no more than noise.
double spreadOf(const Round& estimate, std::size_t usedBands) {
  if (usedBands < 2) return 0;
  std::vector<double> bandMeans(usedBands);
  double within = 0;
  for (std::size_t b = 0; b < usedBands; ++b) {
    std::array<double, replicateCount> one{};
    for (std::size_t r = 0; r < replicateCount; ++r) one[r] = estimate.byBand[r][b];
    const core::ReplicateMean m = core::replicateMean(one);
    bandMeans[b] = m.mean;
    within += m.standardError * m.standardError / static_cast<double>(usedBands);
  }
  const double mean = std::accumulate(bandMeans.begin(), bandMeans.end(), 0.0) / static_cast<double>(usedBands);
  double between = 0;
  for (const double m : bandMeans) between += (m - mean) * (m - mean) / static_cast<double>(usedBands - 1);
  return between > f95 * within ? 2 * std::sqrt(between - within) : 0;
}

}  // namespace

Remainder estimateRemainder(const solver::Solver& solver, const Quantity& quantity,
                            const std::vector<solver::Receiver>& receivers,
                            const std::vector<std::unique_ptr<solver::ReceiverPlan>>& plans, std::uint64_t key,
                            double allowed, double confidence, double secondsLeft, const core::ProgressSink& progress,
                            const core::Keeping& keeping) {
  const auto of = [&](const solver::Response& response) { return quantity.factor * response[quantity.channel]; };
  Remainder remainder;
  remainder.factors.assign(replicateCount, 0.0);
  if (solver.isUnbiased()) return remainder;
  double interreflected = 0;
  for (const auto& plan : plans) interreflected += of(plan->interreflected) / static_cast<double>(plans.size());
  if (!(interreflected > 0)) return remainder;

  const std::size_t points = receivers.size();
  const std::size_t usedBands = std::min(bands, std::bit_floor(points));
  const std::vector<std::size_t> bandOf = bandsOf(receivers);
  // An item: some paths of one replicate. A kept one is of use for as many paths only.
  const auto round = [&](std::uint64_t roundKey, std::uint32_t paths) {
    const std::uint32_t pieces = (paths + pathsAtOnce - 1) / pathsAtOnce;
    std::vector<Piece> results(static_cast<std::size_t>(pieces) * replicateCount);
    core::WorkItems items;
    items.count = results.size();
    items.work = [&](std::size_t item) {
      Piece& piece = results[item];
      piece.ofPaths = paths;
      const std::uint64_t replicateKey = core::combine(core::combine(key, roundKey), item / pieces);
      const double shift = core::Sampler(core::combine(replicateKey, shiftKey), 0).next();
      const auto first = static_cast<std::uint32_t>(item % pieces) * pathsAtOnce;
      // The points are visited evenly, in an order that has nothing to do with the directions' (golden section).
      for (std::uint32_t j = first; j < std::min(paths, first + pathsAtOnce); ++j) {
        const double place = j * 0.6180339887498949 + shift;
        const auto i =
            std::min(points - 1, static_cast<std::size_t>((place - std::floor(place)) * static_cast<double>(points)));
        const double missed = of(solver.missed(receivers[i], replicateKey, j));
        piece.missed += missed / paths;
        piece.byBand[bandOf[i]] += missed / paths * static_cast<double>(usedBands);
      }
    };
    items.pack = [&](std::size_t item, std::string& bytes) { core::put(bytes, results[item]); };
    items.unpack = [&](std::size_t item, std::string_view bytes) {
      return core::take(bytes, results[item]) && results[item].ofPaths == paths;
    };
    Round sums;
    sums.wall_s = core::doItems(items, keeping.part(fmt::format("{:x}", roundKey)), progress).wall_s;
    for (std::size_t item = 0; item < results.size(); ++item) {
      const std::size_t r = item / pieces;
      sums.missed[r] += results[item].missed;
      for (std::size_t b = 0; b < bands; ++b) sums.byBand[r][b] += results[item].byBand[b];
    }
    return sums;
  };

  const double quantile = core::studentQuantile(replicateCount - 1, confidence);
  const Round pilot = round(pilotKey, pilotPaths);
  const double perPath = pilot.wall_s / pilotPaths + 1e-9;
  const core::ReplicateMean first = core::replicateMean(pilot.missed);
  // Where the solution says mostly what is not so (a dark room behind a wall without thickness), measuring how wrong it
  // is costs more than doing without it.
  if (std::abs(first.mean) - quantile * first.standardError > worthlessShare * interreflected) {
    remainder.spread = std::abs(first.mean) / interreflected;
    return remainder;
  }
  const double ratio = quantile * first.standardError / std::max(allowed, 1e-300);
  const double most = std::min(1.0 * mostPaths, timeShare * secondsLeft / perPath);
  const double wanted =
      std::clamp(1.2 * ratio * ratio * pilotPaths, 1.0 * pilotPaths, std::max(most, 1.0 * pilotPaths));
  auto paths = static_cast<std::uint32_t>(wanted);
  for (std::uint64_t attempt = 0;; ++attempt) {
    const Round estimate = round(core::combine(estimateKey, attempt), paths);
    remainder.paths += static_cast<std::uint64_t>(paths) * replicateCount;
    for (std::size_t r = 0; r < replicateCount; ++r) remainder.factors[r] = estimate.missed[r] / interreflected;
    remainder.spread = spreadOf(estimate, usedBands) / interreflected;
    // A spread that matters may be chance (one time in twenty): looked at again, with fresh and more paths.
    const bool matters = remainder.spread * interreflected > allowed;
    if (!matters || attempt + 1 == mostAttempts || 4.0 * paths > most || progress.cancelled()) return remainder;
    paths *= 4;
  }
}

}  // namespace goniolux::analysis
