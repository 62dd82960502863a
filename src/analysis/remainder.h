// Remainder: what a solver that ends paths in a light solution misses on average over a grid, measured by paths that go
// on to their own end.
//
// The solution's error is much smoother over a grid than the light itself, so one factor of the interreflected light,
// the same for all points, describes it; its 16 replicates carry its noise into every interval. Whether one factor is
// enough is tested: the grid is cut into bands, and where they differ by more than their noise (F test at 5 %), that
// spread is stated as the part "interreflection" of the half-widths (docs/methods/light-solution.md).
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "analysis/quantity.h"
#include "core/kept_work.h"
#include "core/progress.h"
#include "solver/solver.h"

namespace goniolux::analysis {

struct Remainder {
  std::vector<double> factors;  ///< per replicate: missed light over interreflected light
  double spread = 0;            ///< bound of what differs from point to point, in the same measure
  std::uint64_t paths = 0;
};

/// `plans` of the same receivers. Goes on until the noise of the factor times the mean interreflected light is below
/// `allowed` lx (half-width at `confidence`), or until some half a million paths or `secondsLeft` are used up; what
/// noise is left is in the intervals. All zero for an unbiased solver.
Remainder estimateRemainder(const solver::Solver& solver, const Quantity& quantity,
                            const std::vector<solver::Receiver>& receivers,
                            const std::vector<std::unique_ptr<solver::ReceiverPlan>>& plans, std::uint64_t key,
                            double allowed, double confidence, double secondsLeft, const core::ProgressSink& progress,
                            const core::Keeping& keeping = {});

}  // namespace goniolux::analysis
