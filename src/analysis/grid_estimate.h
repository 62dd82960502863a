// Grid estimates: illuminance at every point of a grid with a half-width that holds, by work that grows until the asked
// accuracy is met.
//
// Method (docs/methods/intervals.md): 16 independent replicates per point and Student's t. A pilot round measures the
// spread and sets the number of samples per point; a round of fresh replicates estimates; its spread may ask for a
// further round of fresh replicates with more samples, never for a lucky stop in the middle of one. Decisions fall at
// round ends only, from all points together, so results do not depend on threads or on the clock.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "analysis/quantity.h"
#include "core/estimate.h"
#include "core/kept_work.h"
#include "core/progress.h"
#include "solver/solver.h"

namespace goniolux::analysis {

inline constexpr int replicateCount = 16;
/// Grids with fewer points give no measure of what a light solution misses: they are calculated without it.
inline constexpr std::size_t fewPoints = 48;

/// The accuracy asked for, relative (0.01 = 1 %).
struct GridAccuracy {
  double relative = 0.02;    ///< of the mean, the minimum and 95 % of the points
  double uniformity = 0.03;  ///< of U0
  double confidence = 0.95;
  double absoluteFloor = 0.01;  ///< lx
};

struct EffortLimit {
  double secondsLeft = 1e30;  ///< wall clock; rounds are cut to fit, by the pace of the round before
};

/// One quantity per receiver; order as given.
struct GridEstimate {
  std::vector<double> values, statistical;  ///< lx
  std::vector<double> quadrature;           ///< lx, bound of the source-subdivision error
  std::vector<double> interreflection;      ///< lx, bound of what a light solution misses unevenly over the grid
  core::Estimate mean, minimum, maximum, u0, ud;
  std::map<int, core::Estimate> percentiles;  ///< by percent
  double shareWithin = 0;                     ///< share of the points whose half-width is within the accuracy asked for
  bool reached = false;
  std::uint64_t samples = 0;  ///< light paths used by the estimate
};

/// Sees each round's estimate while the work goes on; called from the calling thread.
using GridObserver = std::function<void(const GridEstimate&)>;

/// Estimates a quantity at all receivers (world frame; their bodies are the quantity's). `key` makes the run's random
/// numbers; receivers must not be empty. Finished work goes to `keeping`, and what is there is not done anew.
GridEstimate estimateGrid(const solver::Solver& solver, const Quantity& quantity,
                          const std::vector<solver::Receiver>& receivers, std::uint64_t key,
                          const GridAccuracy& accuracy, const EffortLimit& limit, core::ProgressSink& progress,
                          const std::string& task, const GridObserver& partial = {}, const core::Keeping& keeping = {});

/// The percentiles that are stated.
inline constexpr std::array<int, 5> statedPercentiles{5, 10, 50, 90, 95};

/// The value that a share `fraction` of the values does not exceed, between neighbours in proportion (0: the smallest,
/// 1: the largest, NIST handbook 7.2.6.2 with n - 1 intervals). `values` must not be empty.
double quantileOf(std::vector<double> values, double fraction);

/// A bound of the deterministic error of each point, by cause.
using Systematic = std::map<std::string, std::vector<double>>;

/// Mean, minimum, maximum and uniformities of noisy values; `replicates[r][i]` is replicate r of point i. The extremes
/// are order statistics of noisy values: their intervals hold for all candidates together.
void summarise(const std::vector<std::vector<double>>& replicates, const Systematic& bias, double confidence,
               GridEstimate& estimate);

}  // namespace goniolux::analysis
