// Comparing a run with its baseline: a value has changed when its interval and the expected one part by more than
// chance explains, beyond the tolerance (docs/methods/verification.md).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/two_sample.h"
#include "project/baseline.h"
#include "project/results.h"

namespace goniolux::pipeline {

/// One expected value beside what was found. For quantity "points" the point that stands out most.
struct Difference {
  std::string of;        ///< the grid's or observer's name
  std::string quantity;  ///< "mean", …, "point"
  std::optional<std::size_t> index;
  std::string unit;
  core::Estimate expected, found;
  double allowed = 0;  ///< how far the two may lie apart
  bool changed = false;
  std::string missing;            ///< why there is nothing to compare; then it counts as changed
  std::size_t pointsChanged = 0;  ///< of quantity "points"
  std::size_t points = 0;         ///< of quantity "points"

  [[nodiscard]] double difference() const { return found.value - expected.value; }
};

struct CompareOptions {
  double falseAlarmsPerValue = 1e-4;  ///< this project's share of the batch's, for one expected value
  double tolerance = 0;               ///< relative, for every quantity without one of its own
};

std::vector<Difference> compareWith(const project::Baseline& baseline, const project::Results& results,
                                    const CompareOptions& options);

/// "work plane, mean: 520.1 ± 0.8 lx, expected 512.4 ± 0.6 lx (+1.5 %; chance and tolerance explain 1.9 lx)".
std::string sentenceOf(const Difference& difference);

/// Which inputs are not what the baseline was made from: files with another content, files that are new or gone, and
/// for project.json which of its entries.
std::vector<std::string> changedInputs(const project::Baseline& baseline, const project::Project& now,
                                       const std::string& projectText);

/// The accuracy of the grids that makes a run as sharp as what it is compared with (0.01 = 1 %).
double accuracyFor(const project::Baseline& baseline);

}  // namespace goniolux::pipeline
