#include "pipeline/illuminate.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "analysis/grid_estimate.h"
#include "core/parallel.h"
#include "core/random.h"
#include "pipeline/kept_run.h"
#include "pipeline/lighting_power.h"
#include "pipeline/observe.h"
#include "pipeline/outline.h"
#include "pipeline/requirements.h"
#include "pipeline/result_files.h"
#include "pipeline/solids.h"
#include "pipeline/stages.h"

namespace goniolux::pipeline {
namespace {

using core::Vec3;

// With one maintenance factor throughout, initial values are the maintained ones over it.
std::optional<double> commonMaintenance(const project::Project& project) {
  std::optional<double> factor;
  for (const scene::Luminaire& luminaire : project.environment.luminaires) {
    if (factor && *factor != luminaire.maintenance) return std::nullopt;
    factor = luminaire.maintenance;
  }
  return factor;
}

core::Estimate scaled(core::Estimate e, double factor) {
  e.value *= factor;
  e.statistical *= factor;
  for (auto& [cause, bound] : e.systematic) bound *= factor;
  return e;
}

class GridStage {
 public:
  GridStage(const project::Project& project, const Engine& engine, core::ProgressSink& progress,
            const GridResultObserver& partial, const core::Keeping& keeping)
      : project_(project),
        engine_(engine),
        progress_(progress),
        partial_(partial),
        keeping_(keeping),
        solids_(solidsOf(project)) {}

  project::GridResult calculate(const analysis::Grid& grid, double secondsLeft, bool& reached,
                                std::string& reachedText) {
    project::GridResult result;
    result.name = grid.name;
    result.quantity = grid.quantity;
    const analysis::Quantity& quantity = *analysis::findQuantity(grid.quantity);
    result.unit = quantity.unit;
    result.counts = grid.counts;
    if (grid.counts) result.plane = project::GridPlane{grid.origin, grid.u, grid.v};
    result.points = grid.points;

    std::vector<solver::Receiver> receivers;
    std::vector<std::size_t> index;
    for (std::size_t i = 0; i < grid.points.size(); ++i) {
      if (insideSolid(grid.points[i])) {
        result.excluded.push_back(i);
        continue;
      }
      const Vec3 free = outOfFaces(grid.points[i], grid.normals[i]);
      const Vec3 point = engine_.tracer.clearOfCorners(free - engine_.world.origin, grid.normals[i]);
      receivers.push_back({point, grid.normals[i], quantity.body, grid.axis});
      index.push_back(i);
    }
    if (receivers.empty())
      throw core::InputError(
          grid.position, "grid-without-points",
          fmt::format("grid \"{}\" has no free point: all {} lie inside solid objects; move the grid", grid.name,
                      grid.points.size()));

    analysis::GridObserver observer;
    if (partial_)
      observer = [&](const analysis::GridEstimate& soFar) {
        project::GridResult known = result;
        fill(known, soFar, index);
        partial_(known);
      };
    const auto& asked = project_.settings.accuracy;
    const analysis::GridEstimate e =
        analysis::estimateGrid(*engine_.solver, quantity, receivers, core::keyOf(project_.settings.seed, grid.name),
                               {asked.grid, asked.u0, asked.confidence, 0.01}, {secondsLeft}, progress_, grid.name,
                               observer, keeping_.part("grid " + grid.name));
    fill(result, e, index);
    if (!e.reached) {
      reached = false;
      reachedText += reachedText.empty() ? "" : "; ";
      if (std::isfinite(e.mean.value))
        reachedText += fmt::format("{}: {:.0f} % of the points within {:g} %, mean within {:.2g} %", grid.name,
                                   100 * e.shareWithin, 100 * asked.grid,
                                   e.mean.value > 0 ? 100 * e.mean.halfWidth() / e.mean.value : 0.0);
      else
        reachedText += fmt::format("{}: interrupted before its first numbers", grid.name);
    }
    return result;
  }

 private:
  [[nodiscard]] bool insideSolid(const Vec3& point) const {
    for (const auto& solid : solids_)
      if (solid.contains(point)) return true;
    return false;
  }

  // A point in the side of a solid, where rounding would decide whether it is inside, belongs to the free side.
  [[nodiscard]] Vec3 outOfFaces(Vec3 point, const Vec3& normal) const {
    constexpr int directions = 8;
    const double step = std::max(2 * engine_.tracer.slack(), 4e-6);  // m; beyond the margin of contains()
    Vec3 x, y;
    core::perpendiculars(normal, x, y);
    for (const auto& solid : solids_) {
      Vec3 inward(0);
      for (int k = 0; k < directions; ++k) {
        const double angle = 2 * core::pi * k / directions;
        const Vec3 d = x * std::cos(angle) + y * std::sin(angle);
        if (solid.contains(point + step * d)) inward += d;
      }
      if (const double length = glm::length(inward); length > 1e-6) point -= inward * (step / length);
    }
    return point;
  }

  void fill(project::GridResult& result, const analysis::GridEstimate& e, const std::vector<std::size_t>& index) const {
    const std::size_t n = result.points.size();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const bool melanopic = analysis::findQuantity(result.quantity)->channel != 1;
    const double spectral = melanopic ? engine_.plan.melanopicBound : engine_.plan.spectralBound;
    result.values.assign(n, nan);
    result.halfWidths.assign(n, nan);
    const bool solved = !engine_.solver->isUnbiased();
    for (const char* part : {"statistical", "source_subdivision", "spectral"}) result.parts[part].assign(n, nan);
    if (solved) result.parts["interreflection"].assign(n, nan);
    for (std::size_t j = 0; j < index.size(); ++j) {
      const std::size_t i = index[j];
      result.values[i] = e.values[j];
      result.parts["statistical"][i] = e.statistical[j];
      result.parts["source_subdivision"][i] = e.quadrature[j];
      result.parts["spectral"][i] = spectral * e.values[j];
      if (solved) result.parts["interreflection"][i] = e.interreflection[j];
      result.halfWidths[i] = e.statistical[j] + e.quadrature[j] + e.interreflection[j] + spectral * e.values[j];
    }
    const auto withSpectral = [&](core::Estimate estimate) {
      estimate.systematic["spectral"] = spectral * std::abs(estimate.value);
      return estimate;
    };
    result.mean = withSpectral(e.mean);
    result.min = withSpectral(e.minimum);
    result.max = withSpectral(e.maximum);
    result.u0 = e.u0;
    result.ud = e.ud;
    for (const auto& [percent, estimate] : e.percentiles) result.percentiles[percent] = withSpectral(estimate);
    if (const auto maintenance = commonMaintenance(project_); maintenance && *maintenance > 0 && *maintenance != 1) {
      for (const double value : result.values) result.initialValues.push_back(value / *maintenance);
      result.initialMean = scaled(result.mean, 1 / *maintenance);
    }
  }

  const project::Project& project_;
  const Engine& engine_;
  core::ProgressSink& progress_;
  const GridResultObserver& partial_;
  const core::Keeping& keeping_;
  std::vector<geometry::InsideTest> solids_;
};

StageReport illuminate(const StageRequest& request, core::ProgressSink& progress) {
  const project::Project project = readProjectFor(request, AccuracyOf::grids);
  const std::string folder = resultsFolder(request, project);
  KeptRun kept("illuminate", request, project, folder, progress);
  const Engine engine(project, false);
  const project::Results results = calculateGrids(project, engine, kept.progress(), {}, kept.keeping());
  StageReport report;
  report.files = writeResults(project, results, folder);
  report.json = project::toJson(results);
  report.text = resultsText(results);
  report.warnings = project.warnings;
  report.verdictFailed = anyFailed(results);
  report.unfinished = progress.cancelled();
  kept.close(report, !report.unfinished && (results.reached || !project.settings.timeLimit_s));
  return report;
}

}  // namespace

project::Results calculateGrids(const project::Project& project, const Engine& engine, core::ProgressSink& progress,
                                const GridResultObserver& partial, const core::Keeping& keeping) {
  const double start = core::wallSeconds();
  const Meter meter(*engine.solver, keeping);
  const auto elapsed = [&] { return core::wallSeconds() - start; };

  project::Results results;
  results.project = project.name;
  results.projectHash = project.hash;
  results.inputs = project.inputs;
  results.programVersion = programVersion();
  results.confidence = project.settings.accuracy.confidence;
  results.seed = project.settings.seed;
  results.settingsUsed = planner::toJson(engine.plan, project);
  results.leftOut = leftOutSentences(engine);

  GridStage stage(project, engine, progress, partial, keeping);
  std::size_t left = project.grids.size() + (project.observers.empty() ? 0 : 1);
  for (const analysis::Grid& grid : project.grids) {
    // What is left of the time limit is shared by the grids that are left.
    const double limit = project.settings.timeLimit_s
                             ? std::max(0.0, *project.settings.timeLimit_s - elapsed()) / static_cast<double>(left)
                             : std::numeric_limits<double>::infinity();
    project::GridResult result = stage.calculate(grid, limit, results.reached, results.reachedText);
    // Interrupted before its first numbers, a grid is left out: half a result is one, none is not.
    if (std::isfinite(result.mean.value)) results.grids.push_back(std::move(result));
    --left;
  }
  const double rest = project.settings.timeLimit_s ? std::max(0.0, *project.settings.timeLimit_s - elapsed())
                                                   : std::numeric_limits<double>::infinity();
  rateObservers(project, engine, rest, progress, results, keeping);
  addLightingPower(project, engine, results);
  results.requirements = judge(project, results);
  const core::Spent spent = meter.spent();
  results.wallTime_s = spent.wall_s;
  results.cpuTime_s = spent.cpu_s;
  results.rays = spent.rays;
  return results;
}

std::vector<std::string> writeResults(const project::Project& project, const project::Results& results,
                                      const std::string& folder) {
  return writeResultFiles(folder, results, outlineOf(project));
}

std::string resultsText(const project::Results& results) {
  std::string text = results.project + "\n";
  for (const project::GridResult& grid : results.grids) {
    const auto line = [&](const char* label, const core::Estimate& e, const std::string& unit) {
      text += fmt::format("    {:<8}{:>10.4g} ± {:.2g}{}{}\n", label, e.value, e.halfWidth(), unit.empty() ? "" : " ",
                          unit);
    };
    text += fmt::format("  {} ({}, {} points{})\n", grid.name, grid.quantity, grid.points.size() - grid.excluded.size(),
                        grid.excluded.empty() ? "" : fmt::format(", {} inside objects left out", grid.excluded.size()));
    line("mean", grid.mean, grid.unit);
    line("minimum", grid.min, grid.unit);
    line("maximum", grid.max, grid.unit);
    line("U0", grid.u0, "");
    line("Ud", grid.ud, "");
  }
  for (const project::ObserverResult& observer : results.observers) {
    if (observer.sources.empty() && std::isfinite(observer.value.value)) {
      text += fmt::format("  {} (UGR): no luminaire in the field of view\n", observer.name);
      continue;
    }
    text += fmt::format("  {} (UGR) {:>10.1f} ± {:.2g}, background {:.3g} cd/m2\n", observer.name, observer.value.value,
                        observer.value.halfWidth(), observer.background.value);
    constexpr std::size_t shown = 3;
    for (std::size_t i = 0; i < std::min(shown, observer.sources.size()); ++i) {
      const project::GlareSourceResult& source = observer.sources[i];
      text +=
          fmt::format("    {:<12}{:>5.0f} % of the glare: {:.4g} cd/m2, {:.2g} sr, position index {:.3g}\n",
                      source.luminaire, 100 * source.share, source.luminance, source.solidAngle, source.positionIndex);
    }
  }
  for (const project::RequirementResult& requirement : results.requirements) {
    const bool failed = requirement.verdict == project::RequirementResult::Verdict::fail;
    text += fmt::format("  requirement {}: {}\n", requirement.text, failed ? "FAIL" : wordFor(requirement.verdict));
  }
  if (!results.reached) text += fmt::format("  the asked accuracy was not reached: {}\n", results.reachedText);
  for (const std::string& sentence : results.leftOut) text += fmt::format("  left out: {}\n", sentence);
  text += fmt::format("  intervals at {:g} % confidence; {:.2f} s ({:.2f} s CPU), {:.2f} million rays\n",
                      100 * results.confidence, results.wallTime_s, results.cpuTime_s,
                      1e-6 * static_cast<double>(results.rays));
  return text;
}

Stage illuminateStage() {
  Stage stage;
  stage.name = "illuminate";
  stage.title = "Calculate the grids and observers of a project";
  stage.help =
      "The quantity of every grid at its points and the UGR of every observer, with half-widths, to the accuracy asked "
      "for. Writes grids.json, and a CSV and a .vtp file per grid.";
  stage.inputName = "PROJECT";
  stage.options = {resumeOption()};
  stage.run = illuminate;
  return stage;
}

}  // namespace goniolux::pipeline
