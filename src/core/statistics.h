// Statistics of independent replicates: means, Student intervals, and the quantiles that they need.
#pragma once

#include <cstddef>
#include <span>

namespace goniolux::core {

/// Quantile t of Student's distribution with `dof` degrees of freedom: P(|T| <= t) = confidence.
/// Solved from the incomplete beta function; |error| < 1e-8. dof >= 1, 0 < confidence < 1.
double studentQuantile(double dof, double confidence);

/// P(|T| <= t) for Student's distribution.
double studentProbability(double dof, double t);

/// Mean of independent replicates and its standard error.
struct ReplicateMean {
  double mean = 0, standardError = 0;
};
ReplicateMean replicateMean(std::span<const double> replicates);

/// The confidence that each of `count` intervals must have so that all hold together with `confidence` (Sidak).
double sidak(double confidence, std::size_t count);

}  // namespace goniolux::core
