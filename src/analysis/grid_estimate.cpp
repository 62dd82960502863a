#include "analysis/grid_estimate.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numeric>

#include "analysis/grid_run.h"
#include "core/parallel.h"

namespace goniolux::analysis {
namespace {

constexpr int mostRounds = 12;
constexpr double shareOfPilot = 0.05, mostForeseen = 0.95;  // of the progress that is told

/// What an interrupted run has before its first estimate: no numbers at all.
GridEstimate nothingYet(std::size_t points) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  GridEstimate e;
  e.values.assign(points, nan);
  e.statistical = e.quadrature = e.interreflection = e.values;
  for (core::Estimate* summary : {&e.mean, &e.minimum, &e.maximum, &e.u0, &e.ud}) *summary = {nan, nan, {}};
  return e;
}

}  // namespace

GridEstimate estimateGrid(const solver::Solver& solver, const Quantity& quantity,
                          const std::vector<solver::Receiver>& receivers, std::uint64_t key,
                          const GridAccuracy& accuracy, const EffortLimit& limit, core::ProgressSink& progress,
                          const std::string& task, const GridObserver& partial, const core::Keeping& keeping) {
  const double start = core::wallSeconds();
  const auto seconds = [&] { return core::wallSeconds() - start; };

  GridRun run(solver, quantity, receivers, key, accuracy, keeping);
  double done = 0;
  std::string reached = "first samples";
  const auto tell = [&](double least) {
    done = std::max(done, least);
    progress.progress(task, done, reached);
  };
  progress.progress(task, 0, "looking at the light that each point sees");
  const bool planned = run.plan(progress);
  std::vector<std::size_t> points(receivers.size());
  std::iota(points.begin(), points.end(), std::size_t{0});
  // The pilot is never the answer: it decides, fresh samples estimate.
  run.tellTo([&](double share) { tell(shareOfPilot * share); });
  const bool piloted = planned && run.pilot(progress);
  if (piloted) {
    progress.progress(task, shareOfPilot, "what the light solution misses");
    run.findRemainder(limit.secondsLeft - seconds(), progress);
    progress.progress(task, shareOfPilot, reached);
  }
  // Of what is foreseen: a round may ask for a further one.
  run.tellTo([&](double share) { tell(mostForeseen * share); });
  GridEstimate estimate = nothingYet(receivers.size());
  for (int round = 1; round < mostRounds && piloted; ++round) {
    points = run.within(points, limit.secondsLeft - seconds());
    if (points.empty() || !run.round(points, progress)) break;
    run.everyPointIsKnown();
    estimate = run.estimate();
    reached = fmt::format("points within {:g} %: {:.0f} %", 100 * accuracy.relative, 100 * estimate.shareWithin);
    tell(0);
    if (estimate.reached || seconds() >= limit.secondsLeft) break;
    if (partial) partial(estimate);
    points = run.pointsReached(estimate) ? run.refineMinimum(estimate) : run.refine(estimate);
  }
  progress.progress(task, 1,
                    fmt::format("points within {:g} %: {:.0f} %", 100 * accuracy.relative, 100 * estimate.shareWithin));
  return estimate;
}

}  // namespace goniolux::analysis
