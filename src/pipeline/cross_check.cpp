#include "pipeline/cross_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

#include "analysis/grid_estimate.h"
#include "core/two_sample.h"
#include "pipeline/engine.h"
#include "pipeline/geometry_findings.h"
#include "pipeline/illuminate.h"
#include "pipeline/outline.h"
#include "pipeline/plan_map.h"
#include "pipeline/plot.h"
#include "plot/number_text.h"

namespace goniolux::pipeline {
namespace {

namespace fs = std::filesystem;
using core::Estimate;
using core::Sample;
using project::GridResult;
using project::Results;

constexpr double falseAlarmsOfARun = 0.01;
constexpr double dof = analysis::replicateCount - 1;
constexpr std::uint64_t otherSeed = 0x9e3779b9;
constexpr std::size_t mostTold = 10;  // places in the text
// Independent of the first: the light solution against paths to their own end, and the other way round.
constexpr const char* solution = "gather";
constexpr const char* paths = "path";

double differenceOf(const Estimate& one, const Estimate& other) {
  return other.value - one.value;
}

/// The half-width of the difference: statistical parts are independent, bounds add up.
double joined(const Estimate& a, const Estimate& b) {
  return std::hypot(a.statistical, b.statistical) + (a.halfWidth() - a.statistical) + (b.halfWidth() - b.statistical);
}

class Comparison {
 public:
  Comparison(const Results& one, const Results& other) : one_(one), other_(other) {}

  /// How far two estimates may lie apart; rounding of sums is no disagreement.
  double allowed(const Estimate& a, const Estimate& b, core::TwoSampleTest& test) const {
    constexpr double rounding = 1e-5;  // single-precision coordinates of rays
    const double t = core::studentTail(dof, 1 - one_.confidence), u = core::studentTail(dof, 1 - other_.confidence);
    const Sample first{a.value, a.statistical / t, dof, a.halfWidth() - a.statistical};
    const Sample second{b.value, b.statistical / u, dof, b.halfWidth() - b.statistical};
    return test.largestDifference(first, second) + rounding * std::max(std::abs(a.value), std::abs(b.value));
  }

 private:
  const Results &one_, &other_;
};

std::string estimateText(const Estimate& e, const std::string& unit) {
  return plot::uncertaintyText(e.value, e.halfWidth()) + (unit.empty() ? "" : " " + unit);
}

Results calculate(project::Project project, const std::string& solver, std::uint64_t seed,
                  core::ProgressSink& progress) {
  project.settings.solver = solver;
  project.settings.seed = seed;
  const Engine engine(project, false);
  return calculateGrids(project, engine, progress);
}

core::Value valueOf(const Estimate& e) {
  core::Value value;
  value.set("value", e.value);
  value.set("half_width", e.halfWidth());
  return value;
}

}  // namespace

bool CrossCheck::agrees() const {
  return places.empty() && std::none_of(means.begin(), means.end(), [](const CrossMean& m) { return m.disagrees; });
}

CrossCheck compareSolvers(const Results& one, const Results& other, double falseAlarms) {
  CrossCheck check;
  check.falseAlarms = falseAlarms;
  for (const GridResult& grid : one.grids)
    check.points += static_cast<std::size_t>(
        std::count_if(grid.values.begin(), grid.values.end(), [](double v) { return std::isfinite(v); }));
  const auto share = [&](std::size_t count) {
    return falseAlarms / 2 / static_cast<double>(std::max<std::size_t>(1, count));
  };
  core::TwoSampleTest atPoint(share(check.points)), ofMean(share(one.grids.size()));
  const Comparison comparison(one, other);
  for (std::size_t g = 0; g < one.grids.size(); ++g) {
    const GridResult &a = one.grids[g], &b = other.grids.at(g);
    GridResult difference = a;
    difference.unit = "";
    difference.initialValues.clear();
    difference.initialMean.reset();
    for (std::size_t i = 0; i < a.values.size(); ++i) {
      difference.values[i] = std::numeric_limits<double>::quiet_NaN();
      if (!std::isfinite(a.values[i]) || !std::isfinite(b.values[i])) continue;
      const Estimate p = a.pointEstimate(i), q = b.pointEstimate(i);
      const double room = comparison.allowed(p, q, atPoint), half = joined(p, q), apart = differenceOf(p, q);
      difference.values[i] = apart == 0 ? 0 : apart / std::max(half, 1e-5 * std::abs(p.value) + 1e-300);
      difference.halfWidths[i] = 1;
      if (std::abs(apart) > room) check.places.push_back({a.name, i, a.points[i], a.unit, p, q, room});
    }
    check.differences.push_back(std::move(difference));
    CrossMean mean{a.name, a.unit, a.mean, b.mean, comparison.allowed(a.mean, b.mean, ofMean), false};
    mean.disagrees = !(std::abs(differenceOf(a.mean, b.mean)) <= mean.allowed);
    check.means.push_back(std::move(mean));
  }
  std::stable_sort(check.places.begin(), check.places.end(), [](const CrossPlace& a, const CrossPlace& b) {
    return std::abs(differenceOf(a.one, a.other)) * b.allowed > std::abs(differenceOf(b.one, b.other)) * a.allowed;
  });
  return check;
}

CrossCheck crossCheck(const project::Project& project, core::ProgressSink& progress) {
  if (project.grids.empty())
    throw core::InputError({project.file, 0, 0}, "no-grid", "there is nothing to compare: the project has no grids");
  std::string first;
  {
    const Engine engine(project, false);
    first = engine.plan.solver;
  }
  if (first == "tree")
    throw core::InputError({project.file, 0, 0}, "one-solver",
                           "phong, whitted and hall are shaded by the solver tree alone: there is no second opinion");
  const std::string second = first == solution ? paths : solution;
  const Results one = calculate(project, first, project.settings.seed, progress);
  const Results other = calculate(project, second, project.settings.seed ^ otherSeed, progress);
  CrossCheck check = compareSolvers(one, other, falseAlarmsOfARun);
  check.one = first;
  check.other = second;
  const bool few = std::all_of(project.grids.begin(), project.grids.end(),
                               [](const analysis::Grid& grid) { return grid.points.size() < analysis::fewPoints; });
  if (few)
    check.remark = fmt::format(
        "no grid has {} points, so that both solvers followed whole paths and differ in their random numbers only; a "
        "finer grid is compared with the light solution, too",
        analysis::fewPoints);
  return check;
}

std::string textOf(const CrossCheck& check) {
  std::string text = fmt::format("{} against {}, {} points, false alarms in at most {:g} % of runs\n", check.one,
                                 check.other, check.points, 100 * check.falseAlarms);
  for (const CrossMean& mean : check.means)
    text += fmt::format("  {}, mean: {} and {}{}\n", mean.grid, estimateText(mean.one, mean.unit),
                        estimateText(mean.other, mean.unit),
                        mean.disagrees ? fmt::format(": DISAGREE, chance explains {:.2g}", mean.allowed) : "");
  for (std::size_t i = 0; i < std::min(mostTold, check.places.size()); ++i) {
    const CrossPlace& p = check.places[i];
    text += fmt::format("  {}, point {} at {}: {} and {}: DISAGREE, chance explains {:.2g}\n", p.grid, p.point,
                        placeText(p.position), estimateText(p.one, p.unit), estimateText(p.other, p.unit), p.allowed);
  }
  if (check.places.size() > mostTold) text += fmt::format("  and {} points more\n", check.places.size() - mostTold);
  text += check.agrees() ? "  the two solvers agree\n"
                         : "  one of them is wrong: keep the project and its results, and report them as a defect\n";
  if (!check.remark.empty()) text += "  " + check.remark + "\n";
  return text;
}

core::Value toJson(const CrossCheck& check) {
  core::Value json;
  json.set("solvers", core::Value::Array{check.one, check.other});
  json.set("agree", check.agrees());
  json.set("false_alarms", check.falseAlarms);
  json.set("points", static_cast<std::uint64_t>(check.points));
  core::Value::Array means, places;
  for (const CrossMean& mean : check.means) {
    core::Value entry;
    entry.set("grid", mean.grid);
    entry.set(check.one, valueOf(mean.one));
    entry.set(check.other, valueOf(mean.other));
    entry.set("allowed", mean.allowed);
    entry.set("agree", !mean.disagrees);
    means.push_back(std::move(entry));
  }
  for (const CrossPlace& p : check.places) {
    core::Value entry;
    entry.set("grid", p.grid);
    entry.set("point", static_cast<std::uint64_t>(p.point));
    entry.set("position_m", core::Value::Array{p.position.x, p.position.y, p.position.z});
    entry.set(check.one, valueOf(p.one));
    entry.set(check.other, valueOf(p.other));
    entry.set("allowed", p.allowed);
    places.push_back(std::move(entry));
  }
  json.set("means", std::move(means));
  json.set("disagreements", std::move(places));
  if (!check.remark.empty()) json.set("remark", check.remark);
  return json;
}

std::vector<std::string> drawDifferences(const CrossCheck& check, const project::Project& project,
                                         const std::string& folder, core::Diagnostics& warnings) {
  const Outline outline = outlineOf(project);
  std::error_code failure;
  fs::create_directories(folder, failure);
  if (failure) throw core::RunError(fmt::format("{}: the folder cannot be made: {}", folder, failure.message()));
  Results head;
  head.project = project.name;
  head.projectHash = project.hash;
  head.programVersion = programVersion();
  head.seed = project.settings.seed;
  head.confidence = project.settings.accuracy.confidence;
  std::vector<std::string> pictures;
  for (std::size_t g = 0; g < check.differences.size(); ++g) {
    const GridResult& grid = check.differences[g];
    if (std::none_of(grid.values.begin(), grid.values.end(), [](double v) { return std::isfinite(v); })) continue;
    MapOptions options;
    options.levels = {-4, -3, -2, 2, 3, 4};  // noise is one colour
    GridResult shown = grid;                 // a tenth of a half-width is read, no more
    for (double& v : shown.values) v = std::round(10 * v) / 10 + 0.0;
    plot::PlanMap map = planMapOf(head, shown, &outline, options);
    double most = 3;
    for (const double v : grid.values)
      if (std::isfinite(v)) most = std::max(most, std::abs(v));
    map.lowest = -most;
    map.highest = most;
    map.subtitle = fmt::format("Two solvers on the grid “{}”: within ± 1 is noise, beyond ± 2 hardly", grid.name);
    map.legendTitle = fmt::format("{} less {}", check.other, check.one);
    map.unit = "joined half-widths";
    map.facts = {
        fmt::format("mean {} by {}", estimateText(check.means[g].one, check.means[g].unit), check.one),
        fmt::format("{} by {}", estimateText(check.means[g].other, check.means[g].unit), check.other),
        fmt::format("{} points disagree", std::count_if(check.places.begin(), check.places.end(),
                                                        [&](const CrossPlace& p) { return p.grid == grid.name; }))};
    const std::string base = (fs::path(folder) / ("cross-" + project::fileNameFor(grid.name))).string();
    core::writeFile(base + ".figure.json", core::toJson(plot::toJson(map)));
    if (const std::string trouble = drawFigure(base + ".figure.json", {base + ".png"}); !trouble.empty())
      warnings.warning({}, "cannot-draw", fmt::format("drawing is not possible here: {}", trouble));
    else
      pictures.push_back(base + ".png");
  }
  return pictures;
}

}  // namespace goniolux::pipeline
