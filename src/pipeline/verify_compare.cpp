#include "pipeline/verify_compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/grid_estimate.h"
#include "plot/number_text.h"

namespace goniolux::pipeline {
namespace {

using core::Sample;
using project::Baseline;
using project::ExpectedValue;
using project::GridResult;

constexpr double ourDof = analysis::replicateCount - 1;

class Comparison {
 public:
  Comparison(const Baseline& baseline, const project::Results& results, const CompareOptions& options)
      : baseline_(baseline), results_(results), options_(options), single_(options.falseAlarmsPerValue) {
    // Half-widths are Student's t (or the normal quantile) times the standard error.
    ours_ = core::studentTail(ourDof, 1 - results.confidence);
    theirs_ = core::studentTail(ourDof, 1 - baseline.confidence);
    foreign_ = core::studentTail(std::numeric_limits<double>::infinity(), 1 - baseline.confidence);
  }

  Difference compare(const ExpectedValue& expected) {
    Difference d;
    d.of = expected.grid.empty() ? expected.observer : expected.grid;
    d.quantity = expected.quantity;
    d.index = expected.index;
    d.unit = expected.unit;
    d.expected = expected.estimate;
    if (!expected.grid.empty()) {
      const auto grid = std::find_if(results_.grids.begin(), results_.grids.end(),
                                     [&](const GridResult& g) { return g.name == expected.grid; });
      if (grid == results_.grids.end()) return gone(d, "the project has no such grid any more");
      return expected.quantity == "points" ? points(d, expected, *grid) : ofGrid(d, expected, *grid);
    }
    for (const project::ObserverResult& observer : results_.observers) {
      if (observer.name != expected.observer || observer.quantity != expected.quantity) continue;
      d.found = observer.value;
      return decide(d, expected);
    }
    return gone(d, "the project has no such observer any more");
  }

 private:
  static Difference gone(Difference d, const std::string& why) {
    d.missing = why;
    d.changed = true;
    return d;
  }

  Difference ofGrid(Difference d, const ExpectedValue& expected, const GridResult& grid) {
    const std::string& q = expected.quantity;
    if (q == "point") {
      if (*expected.index >= grid.values.size())
        return gone(d, fmt::format("the grid has {} points now", grid.values.size()));
      d.found = grid.pointEstimate(*expected.index);
    } else {
      d.found = q == "mean" ? grid.mean : q == "min" ? grid.min : q == "max" ? grid.max : q == "u0" ? grid.u0 : grid.ud;
    }
    return decide(d, expected);
  }

  Difference decide(Difference d, const ExpectedValue& expected) {
    if (!std::isfinite(d.found.value)) return gone(d, "there is no value: the calculation was not finished");
    const Sample was = expected.own ? theirs(expected.estimate) : foreign(expected.estimate);
    d.allowed = single_.largestDifference(ours(d.found), was) + toleranceOf(expected, expected.estimate.value);
    d.changed = std::abs(d.difference()) > d.allowed;
    return d;
  }

  /// All points share the false alarms of one value. The one that stands out most is told.
  Difference points(Difference d, const ExpectedValue& expected, const GridResult& grid) {
    if (expected.values.size() != grid.values.size())
      return gone(
          d, fmt::format("the grid has {} points now, {} are expected", grid.values.size(), expected.values.size()));
    d.points = expected.values.size();
    core::TwoSampleTest test(options_.falseAlarmsPerValue / static_cast<double>(std::max<std::size_t>(1, d.points)));
    double most = -1;
    for (std::size_t i = 0; i < expected.values.size(); ++i) {
      const bool wasFree = std::isfinite(expected.values[i]), isFree = std::isfinite(grid.values[i]);
      if (!wasFree && !isFree) continue;
      core::Estimate was;
      was.value = expected.values[i];
      was.statistical = wasFree ? expected.statistical[i] : 0;
      was.systematic["all"] = wasFree ? expected.systematic[i] : 0;
      const core::Estimate is = grid.pointEstimate(i);
      const bool both = wasFree && isFree;
      const double allowed =
          both ? test.largestDifference(ours(is), theirs(was)) + toleranceOf(expected, was.value) : 0;
      const double apart = both ? std::abs(is.value - was.value) : std::numeric_limits<double>::infinity();
      const bool changed = apart > allowed;
      d.pointsChanged += changed ? 1 : 0;
      const double weight = allowed > 0 ? apart / allowed : (changed ? std::numeric_limits<double>::max() : 0);
      if (weight <= most) continue;
      most = weight;
      d.index = i;
      d.expected = was;
      d.found = is;
      d.allowed = allowed;
    }
    d.quantity = "point";
    d.changed = d.pointsChanged > 0;
    if (d.changed && !(std::isfinite(d.expected.value) && std::isfinite(d.found.value)))
      d.missing = std::isfinite(d.found.value) ? "this point was inside a solid and is free now"
                                               : "this point is inside a solid now, or was not finished";
    return d;
  }

  [[nodiscard]] Sample ours(const core::Estimate& e) const {
    return {e.value, e.statistical / ours_, ourDof, e.halfWidth() - e.statistical};
  }
  [[nodiscard]] Sample theirs(const core::Estimate& e) const {
    return {e.value, e.statistical / theirs_, ourDof, e.halfWidth() - e.statistical};
  }
  /// A value of another source: its interval is taken as that of a normal distribution.
  [[nodiscard]] Sample foreign(const core::Estimate& e) const {
    constexpr double known = std::numeric_limits<double>::infinity();
    return {e.value, e.statistical / foreign_, known, e.halfWidth() - e.statistical};
  }

  [[nodiscard]] double toleranceOf(const ExpectedValue& expected, double value) const {
    if (expected.tolerance) return *expected.tolerance;
    const auto found = baseline_.tolerances.find(expected.quantity);
    if (found != baseline_.tolerances.end()) return found->second.relative * std::abs(value) + found->second.absolute;
    return options_.tolerance * std::abs(value);
  }

  const Baseline& baseline_;
  const project::Results& results_;
  CompareOptions options_;
  core::TwoSampleTest single_;
  double ours_ = 1, theirs_ = 1, foreign_ = 1;
};

}  // namespace

std::vector<Difference> compareWith(const Baseline& baseline, const project::Results& results,
                                    const CompareOptions& options) {
  std::vector<Difference> differences;
  Comparison comparison(baseline, results, options);
  for (const ExpectedValue& expected : baseline.values) differences.push_back(comparison.compare(expected));
  return differences;
}

std::string sentenceOf(const Difference& d) {
  std::string text = d.of + ", " + d.quantity;
  if (d.index) text += fmt::format(" {}", *d.index);
  if (!d.missing.empty()) return text + ": " + d.missing;
  const std::string unit = d.unit.empty() || d.unit == "1" ? "" : " " + d.unit;
  text += fmt::format(": {}{}, expected {}{}", plot::uncertaintyText(d.found.value, d.found.halfWidth()), unit,
                      plot::uncertaintyText(d.expected.value, d.expected.halfWidth()), unit);
  if (d.expected.value != 0) text += fmt::format(" ({:+.2g} %", 100 * d.difference() / d.expected.value);
  text += fmt::format("{}chance and tolerance explain {:.2g}{})", d.expected.value != 0 ? "; " : " (", d.allowed, unit);
  if (d.pointsChanged > 1) text += fmt::format("; {} of {} points differ", d.pointsChanged, d.points);
  return text;
}

std::vector<std::string> changedInputs(const Baseline& baseline, const project::Project& now,
                                       const std::string& projectText) {
  std::vector<std::string> changed;
  if (baseline.inputs.empty()) return changed;
  const auto hashIn = [](const std::vector<project::InputFile>& files, const std::string& path) {
    for (const project::InputFile& file : files)
      if (file.path == path) return file.sha256;
    return std::string();
  };
  for (const project::InputFile& was : baseline.inputs) {
    const std::string is = hashIn(now.inputs, was.path);
    if (is.empty()) changed.push_back(was.path + " (no longer used)");
    if (is.empty() || is == was.sha256) continue;
    std::string which;
    if (was.path == "project.json" && !baseline.entries.empty()) {
      const auto entries = project::entryHashes(projectText);
      const auto add = [&](const std::string& name, const char* how) {
        which += (which.empty() ? "" : ", ") + name + how;
      };
      for (const auto& [name, hash] : baseline.entries) {
        const auto found = entries.find(name);
        if (found == entries.end())
          add(name, " (gone)");
        else if (found->second != hash)
          add(name, "");
      }
      for (const auto& [name, hash] : entries)
        if (!baseline.entries.contains(name)) add(name, " (new)");
      if (which.empty()) which = "comments or layout only";
    }
    changed.push_back(which.empty() ? was.path : was.path + ": " + which);
  }
  for (const project::InputFile& is : now.inputs)
    if (hashIn(baseline.inputs, is.path).empty()) changed.push_back(is.path + " (new)");
  return changed;
}

double accuracyFor(const Baseline& baseline) {
  if (baseline.accuracy) return *baseline.accuracy;
  // At a given accuracy of its points a grid's mean is known some five times better.
  constexpr double finest = 0.005, coarsest = 0.10, meansAreBetterBy = 5;
  double accuracy = coarsest;
  for (const ExpectedValue& value : baseline.values) {
    if (value.grid.empty() || value.quantity == "points" || !(value.estimate.value > 0)) continue;
    const double relative = value.estimate.halfWidth() / value.estimate.value;
    accuracy = std::min(accuracy, value.quantity == "mean" ? meansAreBetterBy * relative : relative);
  }
  return std::clamp(accuracy, finest, coarsest);
}

}  // namespace goniolux::pipeline
