// Study of grid spacing: mean, minimum and uniformity of a grid with fewer and with more points.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "pipeline/engine.h"
#include "pipeline/illuminate.h"
#include "pipeline/study_choices.h"

namespace goniolux::pipeline {
namespace {

constexpr double factors[] = {4, 2, 1.5, 1, 0.7, 0.5, 0.35, 0.25};  // of the points along an edge; the finest first
constexpr double mostPoints = 20000;
constexpr double drawnAtLeast = 1e-3;  // %, the axis is logarithmic
constexpr double finestAsked = 0.01;   // of points; no use of more where spacing counts

analysis::Grid withCounts(const analysis::Grid& grid, int along, int across) {
  analysis::Grid other = grid;
  other.counts = {along, across};
  other.points.clear();
  for (int j = 0; j < across; ++j)
    for (int i = 0; i < along; ++i)
      other.points.push_back(grid.origin + grid.u * ((i + 0.5) / along) + grid.v * ((j + 0.5) / across));
  other.normals.assign(other.points.size(), grid.normals.front());
  return other;
}

ChoiceResult run(const project::Project& project, core::ProgressSink& progress) {
  const auto regular = std::find_if(project.grids.begin(), project.grids.end(),
                                    [](const analysis::Grid& grid) { return grid.counts.has_value(); });
  if (regular == project.grids.end())
    nothingToStudy(project,
                   "the project has no regular grid (with \"counts\" or \"spacing\"): single points have none");
  ChoiceResult result;
  result.columns = {
      "points_along_u", "points_along_v", "spacing_m", "mean", "mean_half_width", "min", "min_half_width", "u0",
      "u0_half_width"};
  plot::LineChart& chart = result.chart;
  chart.title = project.name;
  chart.subtitle = fmt::format("Grid \"{}\": what fewer points change", regular->name);
  chart.x = {"spacing / m", true};
  chart.y = {"change against the finest grid / %", true};
  chart.guides = {1};
  project::Project own = project;
  own.observers.clear();
  own.requirements.clear();
  own.settings.accuracy.grid = std::max(own.settings.accuracy.grid, finestAsked);
  const Engine engine(own, false);
  core::Estimate mean, minimum, u0;  // of the finest
  double finest = 0;
  const auto& counts = *regular->counts;
  for (std::size_t step = 0; step < std::size(factors); ++step) {
    const double factor = factors[step];
    const int along = std::max(1, static_cast<int>(std::lround(counts[0] * factor))),
              across = std::max(1, static_cast<int>(std::lround(counts[1] * factor)));
    if (static_cast<double>(along) * across > mostPoints) continue;
    progress.progress(project.name, static_cast<double>(step) / std::size(factors),
                      fmt::format("{} x {} points", along, across));
    if (progress.cancelled()) return result;
    own.grids = {withCounts(*regular, along, across)};
    const project::Results found = calculateGrids(own, engine, progress);
    if (progress.cancelled()) return result;
    const project::GridResult& grid = found.grids.front();
    const double spacing = std::max(glm::length(regular->u) / along, glm::length(regular->v) / across);
    result.rows.push_back({fmt::format("{}", along), fmt::format("{}", across), fmt::format("{:.4g}", spacing),
                           fmt::format("{:.5g}", grid.mean.value), fmt::format("{:.3g}", grid.mean.halfWidth()),
                           fmt::format("{:.5g}", grid.min.value), fmt::format("{:.3g}", grid.min.halfWidth()),
                           fmt::format("{:.4g}", grid.u0.value), fmt::format("{:.3g}", grid.u0.halfWidth())});
    if (finest == 0) {
      finest = spacing;
      mean = grid.mean, minimum = grid.min, u0 = grid.u0;
      if (!(mean.value > 0)) nothingToStudy(project, fmt::format("no light falls on the grid \"{}\"", regular->name));
      continue;
    }
    const auto add = [&](const char* name, const core::Estimate& one, const core::Estimate& best) {
      if (best.value > 0)
        addPoint(chart, name, spacing, std::max(100 * std::abs(one.value / best.value - 1), drawnAtLeast));
    };
    add("mean", grid.mean, mean);
    add("minimum", grid.min, minimum);
    add("uniformity U₀", grid.u0, u0);
    if (factor == 1)
      chart.facts.push_back(fmt::format("as the project has it, {:.2f} m: mean {:+.1f} %, minimum {:+.1f} %", spacing,
                                        100 * (grid.mean.value / mean.value - 1),
                                        minimum.value > 0 ? 100 * (grid.min.value / minimum.value - 1) : 0.0));
  }
  if (chart.curves.empty()) nothingToStudy(project, "the grid has too many points to be refined");
  const double longer = std::max(glm::length(regular->u), glm::length(regular->v));
  chart.facts.push_back(
      fmt::format("EN 12464-1 allows {:.2f} m here", 0.2 * std::pow(5, std::log10(std::max(longer, 0.1)))));
  chart.footer =
      fmt::format("goniolux {} · finest spacing {:.3f} m · intervals of the runs: mean ± {:.2g} %, minimum ± {:.2g} %",
                  programVersion(), finest, 100 * mean.halfWidth() / mean.value,
                  minimum.value > 0 ? 100 * minimum.halfWidth() / minimum.value : 0);
  return result;
}

}  // namespace

ChoiceStudy gridSpacingStudy() {
  return {
      "grid-spacing", "spacing of the grid's points",
      "change of mean, minimum and uniformity of the first regular grid with a quarter to four times the points along "
      "each edge",
      run};
}

}  // namespace goniolux::pipeline
