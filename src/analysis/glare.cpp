#include "analysis/glare.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <map>

#include "analysis/grid_estimate.h"
#include "analysis/position_index.h"
#include "analysis/ugr_table.h"
#include "core/parallel.h"
#include "core/random.h"
#include "core/statistics.h"
#include "core/work_items.h"

namespace goniolux::analysis {
namespace {

using core::Vec3;

constexpr std::uint32_t raysPerLight = 16, firstPaths = 32, mostPaths = 1u << 18;  // per replicate
constexpr double smallSourceArea = 0.005;                                          // m2, CIE 147
constexpr double smallestSolidAngle = 0.0003, largestSolidAngle = 0.1;             // sr, CIE 117
constexpr std::uint64_t planKey = 0, lightKey = 1, backgroundKey = 2;
constexpr double leastGrowth = 1.5, largestGrowth = 8;

Vec3 upOf(const Vec3& forward) {
  const Vec3 vertical(0, 0, 1);
  const Vec3 up = vertical - forward * glm::dot(forward, vertical);
  if (glm::length(up) > 1e-9) return glm::normalize(up);
  Vec3 x, y;
  core::perpendiculars(forward, x, y);
  return x;
}

// L^2 omega / p^2 of every light in the field, by source.
std::map<std::uint32_t, SeenGlare> glareOf(const std::vector<solver::SeenLight>& lights, const Vec3& forward,
                                           const Vec3& up) {
  std::map<std::uint32_t, SeenGlare> result;
  for (const solver::SeenLight& light : lights) {
    const auto p = positionIndexInField(forward, up, light.direction);
    if (!p) continue;
    const double angle = std::max(light.solidAngle, smallSourceArea / (light.distance * light.distance));
    const double luminance = light.normalIlluminance / angle;
    result[light.source] = {light.source, luminance, angle, *p, luminance * luminance * angle / (*p * *p)};
  }
  return result;
}

}  // namespace

GlareEstimate estimateGlare(const solver::Solver& solver, const solver::SeenLights& lights, const Vec3& eye,
                            const Vec3& direction, std::uint64_t key, double accuracy, double confidence,
                            double secondsLeft, const core::ProgressSink& progress, const core::Keeping& keeping) {
  const double start = core::wallSeconds();
  const double quantile = core::studentQuantile(replicateCount - 1, confidence);
  const Vec3 up = upOf(direction);
  solver::Receiver background{eye, direction};
  background.directLight = false;
  const auto plan = solver.plan(background, core::combine(key, planKey));

  GlareEstimate estimate;
  std::uint32_t rays = raysPerLight, paths = firstPaths;
  for (std::uint64_t round = 1;; ++round) {
    std::array<double, replicateCount> indirect{}, sums{};
    std::array<std::map<std::uint32_t, SeenGlare>, replicateCount> seen;
    const std::uint64_t roundKey = core::combine(key, round);
    core::WorkItems items;
    items.count = replicateCount;
    items.work = [&](std::size_t r) {
      const std::uint64_t replicateKey = core::combine(roundKey, r);
      seen[r] = glareOf(lights.from(eye, core::combine(replicateKey, lightKey), rays), direction, up);
      indirect[r] =
          solver.wholeIlluminance(background, *plan, core::combine(replicateKey, backgroundKey), paths)[1] / core::pi;
    };
    items.pack = [&](std::size_t r, std::string& bytes) {
      core::put(bytes, indirect[r]);
      for (const auto& [source, glare] : seen[r]) core::put(bytes, glare);
    };
    items.unpack = [&](std::size_t r, std::string_view bytes) {
      if (!core::take(bytes, indirect[r])) return false;
      for (SeenGlare glare; core::take(bytes, glare);) seen[r][glare.source] = glare;
      return bytes.empty();
    };
    const bool complete = core::doItems(items, keeping.part(fmt::format("round {}", round)), progress).complete;
    for (std::size_t r = 0; r < replicateCount; ++r)
      for (const auto& [source, glare] : seen[r]) sums[r] += glare.share;
    if (!complete && round > 1) return estimate;  // what the round before found
    if (!complete) {
      estimate.ugr.value = estimate.ugr.statistical = std::numeric_limits<double>::quiet_NaN();
      estimate.background = estimate.ugr;
      return estimate;
    }
    const core::ReplicateMean sum = core::replicateMean(sums), luminance = core::replicateMean(indirect);
    estimate.background = {luminance.mean, quantile * luminance.standardError, {}};
    estimate.sources.clear();
    estimate.tooSmall = estimate.tooLarge = 0;
    std::map<std::uint32_t, SeenGlare> means;
    for (const auto& replicate : seen)
      for (const auto& [source, glare] : replicate) {
        SeenGlare& mean = means[source];
        mean.source = source;
        mean.luminance += glare.luminance * glare.solidAngle / replicateCount;  // by solid angle
        mean.solidAngle += glare.solidAngle / replicateCount;
        mean.positionIndex = glare.positionIndex;
        mean.share += glare.share / replicateCount;
      }
    for (auto& [source, mean] : means) {
      mean.luminance /= mean.solidAngle;
      if (sum.mean > 0) mean.share /= sum.mean;
      estimate.tooSmall += mean.solidAngle < smallestSolidAngle;
      estimate.tooLarge += mean.solidAngle > largestSolidAngle;
      estimate.sources.push_back(mean);
    }
    std::sort(estimate.sources.begin(), estimate.sources.end(),
              [](const SeenGlare& a, const SeenGlare& b) { return a.share > b.share; });
    if (!(sum.mean > 0)) {
      estimate.ugr = {};
      estimate.reached = true;
      return estimate;
    }
    if (!(luminance.mean > 0)) {
      estimate.ugr.value = estimate.ugr.statistical = std::numeric_limits<double>::quiet_NaN();
      return estimate;
    }
    // The logarithm of each replicate would be low on average; that of the means is not, and its spread is that of the
    // parts, which are independent of each other.
    const double relative = std::hypot(sum.standardError / sum.mean, luminance.standardError / luminance.mean);
    estimate.ugr = {ugr(sum.mean, luminance.mean), quantile * 8 / std::log(10.0) * relative, {}};
    estimate.reached = estimate.ugr.statistical <= accuracy;
    const double taken = core::wallSeconds() - start;
    if (estimate.reached || paths >= mostPaths) return estimate;
    const double ratio = 1.15 * estimate.ugr.statistical / accuracy;
    double growth = std::clamp(ratio * ratio, leastGrowth, largestGrowth);
    growth = std::min(growth, (secondsLeft - taken) / std::max(taken, 1e-4));
    if (growth < 1.1) return estimate;
    // The clock had a say in it: a resumed run goes on with what was decided.
    const auto decision = std::bit_cast<std::uint64_t>(growth);
    growth = std::bit_cast<double>(keeping.decided(fmt::format("growth {}", round), decision));
    paths = static_cast<std::uint32_t>(paths * growth);
    // Visible parts are known far better than the background, unless something stands before them.
    if (sum.standardError / sum.mean > 0.3 * luminance.standardError / luminance.mean)
      rays = static_cast<std::uint32_t>(rays * growth);
  }
}

}  // namespace goniolux::analysis
