#include "core/statistics.h"

#include <gtest/gtest.h>

#include <vector>

#include "core/random.h"

namespace goniolux::core {
namespace {

// Two-sided 95 % points of Student's t (any published table, e.g. NIST/SEMATECH handbook 1.3.6.7.2), 1.0 % at 1 dof.
TEST(StudentQuantile, AgreesWithPublishedTable) {
  EXPECT_NEAR(studentQuantile(1, 0.95), 12.706, 5e-4);
  EXPECT_NEAR(studentQuantile(15, 0.95), 2.131, 5e-4);
  EXPECT_NEAR(studentQuantile(31, 0.95), 2.040, 5e-4);
  EXPECT_NEAR(studentQuantile(15, 0.99), 2.947, 5e-4);
  EXPECT_NEAR(studentQuantile(1e6, 0.95), 1.95996, 1e-4);
}

// Coverage of the interval over 16 replicates of a skewed mean: binomial sd of 4000 trials is 0.35 %.
TEST(ReplicateMean, IntervalCoversTheTruthAsOftenAsStated) {
  const double t = studentQuantile(15, 0.95);
  int inside = 0, insideWithTooSmallInterval = 0;
  for (std::uint64_t trial = 0; trial < 4000; ++trial) {
    std::vector<double> replicates;
    for (std::uint64_t r = 0; r < 16; ++r) {
      double sum = 0;
      for (std::uint32_t i = 0; i < 8; ++i) sum += Sampler(combine(trial, r * 8 + i), 0).next();
      replicates.push_back(sum / 8);
    }
    const ReplicateMean m = replicateMean(replicates);
    inside += std::abs(m.mean - 0.5) <= t * m.standardError;
    insideWithTooSmallInterval += std::abs(m.mean - 0.5) <= 0.8 * t * m.standardError;
  }
  EXPECT_NEAR(inside / 4000.0, 0.95, 0.0125);
  EXPECT_LT(insideWithTooSmallInterval / 4000.0, 0.9375);  // negative control: the test sees an interval 20 % too small
}

TEST(Sidak, MakesAllIntervalsHoldTogether) {
  EXPECT_DOUBLE_EQ(sidak(0.95, 1), 0.95);
  EXPECT_NEAR(std::pow(sidak(0.95, 7), 7), 0.95, 1e-12);
}

}  // namespace
}  // namespace goniolux::core
