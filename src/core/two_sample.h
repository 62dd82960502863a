// TwoSample: may two measured values of one quantity be the same? The test of `verify` (docs/methods/verification.md).
#pragma once

#include <map>

namespace goniolux::core {

/// A value as it was measured: its standard error with the degrees of freedom that this is known to, and a bound of its
/// deterministic error. Unit: that of the quantity.
struct Sample {
  double value = 0, standardError = 0;
  double dof = 15;  ///< infinity: the standard error is known
  double bound = 0;
};

/// Welch's two-sided t test at one rate of false alarms, with bounds of deterministic errors added. Not shared between
/// threads: it remembers quantiles.
class TwoSampleTest {
 public:
  /// `falseAlarms`: how often, at most, equal quantities are told apart; above 0, below 1.
  explicit TwoSampleTest(double falseAlarms) : falseAlarms_(falseAlarms) {}

  /// How far the two samples may lie apart.
  double largestDifference(const Sample& a, const Sample& b);

 private:
  double quantile(double dof);

  double falseAlarms_;
  std::map<double, double> quantiles_;  // by degrees of freedom
};

/// Quantile t with P(|T| > t) = `probability`, also for probabilities so small that 1 - probability would round; `dof`
/// may be infinite (the normal distribution). Relative error below 1e-6.
double studentTail(double dof, double probability);

/// Standard error from a half-width at `confidence` by Student's t.
double standardErrorOf(double halfWidth, double confidence, double dof);

}  // namespace goniolux::core
