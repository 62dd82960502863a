// Cross-check: one project by two solvers, each with random numbers of its own. Where they differ by more than both
// intervals explain, one of them is wrong: a defect of the run, with its place (docs/methods/cross-check.md).
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/document.h"
#include "core/estimate.h"
#include "core/progress.h"
#include "project/project.h"
#include "project/results.h"

namespace goniolux::pipeline {

/// A place where the two solvers disagree.
struct CrossPlace {
  std::string grid;
  std::size_t point = 0;
  core::Vec3 position{0};  ///< project frame, m
  std::string unit;
  core::Estimate one, other;
  double allowed = 0;  ///< how far the two may lie apart
};

/// The mean of a grid, which shows what points are too noisy for.
struct CrossMean {
  std::string grid, unit;
  core::Estimate one, other;
  double allowed = 0;
  bool disagrees = false;
};

struct CrossCheck {
  std::string one, other;                        ///< the solvers
  double falseAlarms = 0;                        ///< how often a run is flagged, at most, whose solvers agree
  std::size_t points = 0;                        ///< compared
  std::vector<CrossPlace> places;                ///< that disagree; the largest difference for what is allowed first
  std::vector<CrossMean> means;                  ///< of every grid
  std::vector<project::GridResult> differences;  ///< other less one, in units of the joined half-width
  std::string remark;                            ///< what the comparison cannot see; "" = nothing to add

  [[nodiscard]] bool agrees() const;
};

/// Welch's test at every point and at the mean of each grid. Half of the false alarms is for the means, half for all
/// points together (Bonferroni).
CrossCheck compareSolvers(const project::Results& one, const project::Results& other, double falseAlarms);

/// Calculates the project's grids by the planner's solver and by another of the registry that is not biased, to the
/// project's accuracy. Throws core::InputError where the project has no grids or no two solvers for it.
CrossCheck crossCheck(const project::Project& project, core::ProgressSink& progress);

std::string textOf(const CrossCheck& check);
core::Value toJson(const CrossCheck& check);

/// Draws the differences of every grid into the folder; the pictures' paths, and in `warnings` why there are none.
std::vector<std::string> drawDifferences(const CrossCheck& check, const project::Project& project,
                                         const std::string& folder, core::Diagnostics& warnings);

}  // namespace goniolux::pipeline
