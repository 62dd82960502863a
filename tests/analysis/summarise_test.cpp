// Means, extremes and uniformities of noisy values: their intervals must hold as often as they say.
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "analysis/grid_estimate.h"
#include "core/random.h"
#include "core/statistics.h"

namespace goniolux::analysis {
namespace {

double gauss(core::Sampler& random) {
  const core::Vec2 u = random.next2();
  return std::sqrt(-2 * std::log(1 - u.x)) * std::cos(2 * core::pi * u.y);
}

// A grid of 40 points, truth between 90 and 110 with several near the minimum, replicates with 3 % noise.
GridEstimate noisyGrid(std::uint64_t trial, double noise) {
  constexpr std::size_t points = 40;
  std::vector<std::vector<double>> replicates(replicateCount, std::vector<double>(points));
  GridEstimate e;
  e.values.resize(points), e.statistical.resize(points);
  const double t = core::studentQuantile(replicateCount - 1, 0.95);
  for (std::size_t i = 0; i < points; ++i) {
    const double truth = i < 5 ? 90.0 : 90.0 + 0.5 * static_cast<double>(i);
    std::vector<double> one;
    for (std::size_t r = 0; r < replicateCount; ++r) {
      core::Sampler random(core::combine(core::combine(trial, i), r), 0);
      one.push_back(replicates[r][i] = truth * (1 + noise * gauss(random)));
    }
    const core::ReplicateMean m = core::replicateMean(one);
    e.values[i] = m.mean;
    e.statistical[i] = t * m.standardError;
  }
  summarise(replicates, {{"source_subdivision", std::vector<double>(points, 0)}}, 0.95, e);
  return e;
}

// 2000 trials: three standard deviations of the binomial are 1.5 %.
TEST(Summarise, IntervalsOfMeanMinimumAndUniformityHold) {
  double trueMean = 0;
  for (int i = 0; i < 40; ++i) trueMean += (i < 5 ? 90.0 : 90.0 + 0.5 * i) / 40;
  int mean = 0, minimum = 0, maximum = 0, u0 = 0;
  constexpr int trials = 2000;
  for (std::uint64_t trial = 0; trial < trials; ++trial) {
    const GridEstimate e = noisyGrid(trial, 0.03);
    mean += std::abs(e.mean.value - trueMean) <= e.mean.halfWidth();
    minimum += std::abs(e.minimum.value - 90) <= e.minimum.halfWidth();
    maximum += std::abs(e.maximum.value - 109.5) <= e.maximum.halfWidth();
    u0 += std::abs(e.u0.value - 90 / trueMean) <= e.u0.halfWidth();
  }
  EXPECT_NEAR(mean / 2000.0, 0.95, 0.015);
  EXPECT_GE(minimum / 2000.0, 0.935);
  EXPECT_GE(maximum / 2000.0, 0.935);
  EXPECT_GE(u0 / 2000.0, 0.935);
}

TEST(Summarise, AQuantileLiesBetweenItsNeighboursInProportion) {
  EXPECT_DOUBLE_EQ(quantileOf({4, 1, 3, 2, 5}, 0), 1);
  EXPECT_DOUBLE_EQ(quantileOf({4, 1, 3, 2, 5}, 0.5), 3);
  EXPECT_DOUBLE_EQ(quantileOf({4, 1, 3, 2, 5}, 0.9), 4.6);
  EXPECT_DOUBLE_EQ(quantileOf({4, 1, 3, 2, 5}, 1), 5);
  EXPECT_DOUBLE_EQ(quantileOf({7}, 0.3), 7);
}

TEST(Summarise, IntervalsOfPercentilesHold) {
  std::vector<double> truth;
  for (int i = 0; i < 40; ++i) truth.push_back(i < 5 ? 90.0 : 90.0 + 0.5 * i);
  std::map<int, int> inside;
  constexpr int trials = 1000;
  for (std::uint64_t trial = 0; trial < trials; ++trial) {
    const GridEstimate e = noisyGrid(trial, 0.03);
    for (const auto& [percent, estimate] : e.percentiles)
      inside[percent] += std::abs(estimate.value - quantileOf(truth, 0.01 * percent)) <= estimate.halfWidth();
  }
  ASSERT_EQ(inside.size(), statedPercentiles.size());
  for (const auto& [percent, count] : inside) EXPECT_GE(count / 1000.0, 0.93) << percent << " %";
}

TEST(Summarise, ExactValuesHaveNoWidth) {
  const GridEstimate e = noisyGrid(1, 0);
  EXPECT_DOUBLE_EQ(e.minimum.value, 90);
  EXPECT_NEAR(e.maximum.value, 109.5, 1e-12);
  EXPECT_NEAR(e.minimum.halfWidth(), 0, 1e-9);
  EXPECT_NEAR(e.ud.value, 90 / 109.5, 1e-12);
}

}  // namespace
}  // namespace goniolux::analysis
