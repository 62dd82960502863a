// The two-sample test of `verify`: its quantiles, and how often it alarms on equal and on unequal quantities.
#include "core/two_sample.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "core/statistics.h"

namespace goniolux::core {
namespace {

TEST(StudentTail, AgreesWithTablesAndReachesFarIntoTheTail) {
  // NIST/SEMATECH e-Handbook, 1.3.6.7.2, two-sided.
  EXPECT_NEAR(studentTail(15, 0.05), 2.131, 5e-4);
  EXPECT_NEAR(studentTail(30, 0.002), 3.385, 5e-4);
  EXPECT_NEAR(studentTail(std::numeric_limits<double>::infinity(), 0.05), 1.959964, 1e-6);
  // One degree of freedom is Cauchy's distribution: P(|T| > t) = 2/pi atan(1/t), so t = 1/tan(pi p/2).
  EXPECT_NEAR(studentTail(1, 1e-8) / (1 / std::tan(std::acos(-1.0) * 0.5e-8)), 1, 1e-6);
  // Two degrees: P(|T| > t) = 1 - t/sqrt(2 + t2); for small p, t = (1 - p) sqrt(2 / (p (2 - p))).
  EXPECT_NEAR(studentTail(2, 1e-10) / ((1 - 1e-10) * std::sqrt(2 / (1e-10 * (2 - 1e-10)))), 1, 1e-6);
  for (const double dof : {3.0, 15.0, 40.0})
    EXPECT_NEAR(studentTail(dof, 0.01), studentQuantile(dof, 0.99), 1e-5) << dof;
}

struct Rates {
  double equal, apart;
};

/// How often the test tells 16 replicates of N(0, 1) from 16 of N(shift, 3).
Rates alarmRates(double rate, double shift, double standardErrorFactor) {
  std::mt19937 random(20261123);
  std::normal_distribution<double> normal;
  const auto sample = [&](double mean, double spread) {
    std::vector<double> replicates(16);
    for (double& r : replicates) r = mean + spread * normal(random);
    const ReplicateMean m = replicateMean(replicates);
    return Sample{m.mean, standardErrorFactor * m.standardError, 15, 0};
  };
  constexpr int runs = 20000;
  int equal = 0, apart = 0;
  TwoSampleTest test(rate);
  for (int i = 0; i < runs; ++i) {
    const Sample a = sample(0, 1), b = sample(0, 3), c = sample(shift, 3);
    equal += std::abs(a.value - b.value) > test.largestDifference(a, b) ? 1 : 0;
    apart += std::abs(a.value - c.value) > test.largestDifference(a, c) ? 1 : 0;
  }
  return {static_cast<double>(equal) / runs, static_cast<double>(apart) / runs};
}

TEST(TwoSampleTest, AlarmsAsOftenAsStatedAndSeesWhatIsThere) {
  // Binomial scatter of 20000 runs at 1 %: 0.07 %; four of them. Welch's approximation itself is good to a tenth.
  const Rates rates = alarmRates(0.01, 5, 1);  // 5 is 6.3 standard errors of the difference
  EXPECT_LT(rates.equal, 0.0115 + 4 * 0.0007);
  EXPECT_GT(rates.equal, 0.0075 - 4 * 0.0007);
  EXPECT_GT(rates.apart, 0.99);
}

TEST(TwoSampleTest, StandardErrorsThatAreTooSmallAreFoundOut) {
  EXPECT_GT(alarmRates(0.01, 5, 0.7).equal, 0.03);  // negative control
}

TEST(TwoSampleTest, BoundsAreAddedAndConstantsNeedNothing) {
  TwoSampleTest test(0.01);
  EXPECT_EQ(test.largestDifference({1, 0, 15, 0.25}, {1, 0, 15, 0.5}), 0.75);
  const double noise = test.largestDifference({1, 0.1, 15, 0}, {1, 0.1, 15, 0});
  EXPECT_NEAR(test.largestDifference({1, 0.1, 15, 0.25}, {1, 0.1, 15, 0.5}), noise + 0.75, 1e-12);
}

}  // namespace
}  // namespace goniolux::core
