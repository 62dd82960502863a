// Plan: what would be calculated for the accuracy asked for, what is left out, how long it will take, and why.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "analysis/grid_estimate.h"
#include "core/parallel.h"
#include "core/random.h"
#include "pipeline/engine.h"
#include "pipeline/render.h"
#include "pipeline/stages.h"
#include "viewing/pixel_loop.h"

namespace goniolux::pipeline {
namespace {

struct Forecast {
  double grids_s = 0, images_s = 0;
};

// From a coarse run at ten times the asked half-width: effort grows with the inverse square of it.
constexpr double coarser = 10;

double secondsFor(const auto& work) {
  const double before = core::processCpuSeconds();
  work();
  return (core::processCpuSeconds() - before) / core::threadCount();
}

Forecast forecast(const project::Project& project, const Engine& engine) {
  Forecast f;
  core::SilentProgress silent;
  const auto& accuracy = project.settings.accuracy;
  for (const analysis::Grid& grid : project.grids) {
    const analysis::Quantity& quantity = *analysis::findQuantity(grid.quantity);
    std::vector<solver::Receiver> some;
    const std::size_t step = std::max<std::size_t>(1, grid.points.size() / 64);
    for (std::size_t i = step / 2; i < grid.points.size(); i += step)
      some.push_back({grid.points[i] - engine.world.origin, grid.normals[i], quantity.body, grid.axis});
    if (some.empty()) continue;
    double reached = coarser;
    const double seconds = secondsFor([&] {
      const auto e = analysis::estimateGrid(*engine.solver, quantity, some, core::mix(1),
                                            {coarser * accuracy.grid, coarser * accuracy.u0, accuracy.confidence, 0.01},
                                            {5.0}, silent, grid.name);
      // The share of the allowed half-width that the coarse run used, typically.
      std::vector<double> relative;
      for (std::size_t i = 0; i < e.values.size(); ++i)
        if (e.values[i] > 0) relative.push_back(e.statistical[i] / (accuracy.grid * e.values[i]));
      if (relative.empty()) return;
      std::nth_element(relative.begin(), relative.begin() + static_cast<std::ptrdiff_t>(relative.size() * 9 / 10),
                       relative.end());
      reached = std::max(1.0, relative[relative.size() * 9 / 10]);
    });
    f.grids_s += seconds * static_cast<double>(step) * std::max(1.0, reached * reached);
  }
  for (scene::View view : project.views) {
    const double pixels = static_cast<double>(view.width) * view.height;
    const double shrink = std::max(1.0, std::sqrt(pixels / 1024));
    view.width = std::max(1, static_cast<int>(view.width / shrink));
    view.height = std::max(1, static_cast<int>(view.height / shrink));
    viewing::ImageEstimate e;
    const double seconds = secondsFor([&] {
      e = viewing::renderView(*engine.solver, view, engine.world.origin, core::mix(2),
                              pixelAccuracyOf(project.settings), 5.0, silent);
    });
    f.images_s += seconds * pixels / (static_cast<double>(view.width) * view.height);
  }
  return f;
}

StageReport plan(const StageRequest& request, core::ProgressSink&) {
  const project::Project project = readProjectFor(request, AccuracyOf::both);
  const Engine engine(project, !project.views.empty());
  const Forecast f = forecast(project, engine);

  StageReport report;
  report.warnings = project.warnings;
  report.json = planDocument(project, engine);
  report.text = fmt::format("{}\n  solver {}, {} spectral samples ({})\n", project.name, engine.plan.solver,
                            engine.plan.quadrature.wavelengths.size(), engine.plan.quadrature.scheme);
  for (const std::string& reason : engine.plan.reasons) report.text += "  because: " + reason + "\n";
  for (const std::string& sentence : leftOutSentences(engine)) report.text += "  left out: " + sentence + "\n";
  report.json.set("predicted_time_s", f.grids_s + f.images_s);
  report.text += fmt::format(
      "  about {:.1f} s for the grids to {:g} %, {:.1f} s for the views to {:g} %, on {} threads\n", f.grids_s,
      100 * project.settings.accuracy.grid, f.images_s, 100 * project.settings.accuracy.image, core::threadCount());
  if (request.common.output) {
    const std::filesystem::path file = std::filesystem::path(*request.common.output) / "plan.json";
    std::error_code error;
    std::filesystem::create_directories(file.parent_path(), error);
    if (error)
      throw core::RunError(fmt::format("{}: the folder cannot be made: {}", *request.common.output, error.message()));
    core::writeFile(file.string(), core::toJson(report.json));
    report.files.push_back(file.string());
  }
  return report;
}

}  // namespace

core::Value planDocument(const project::Project& project, const Engine& engine) {
  core::Value json = planner::toJson(engine.plan, project);
  core::Value::Array leftOut;
  const auto leaveOut = [&](const std::string& what, core::Value bound, const std::string& unit) {
    core::Value entry;
    entry.set("what", what);
    entry.set("bound", std::move(bound));
    entry.set("unit", unit);
    leftOut.push_back(std::move(entry));
  };
  for (const planner::Omission& omission : engine.plan.leftOut)
    leaveOut(omission.what, omission.bound > 0 ? core::Value(omission.bound) : core::Value(), omission.unit);
  for (const std::string& sentence : engine.solver->leftOut()) leaveOut(sentence, core::Value(), "not bounded");
  json.set("left_out", std::move(leftOut));
  json.set("reasons", core::Value::arrayOf(engine.plan.reasons));
  return json;
}

Stage planStage() {
  Stage stage;
  stage.name = "plan";
  stage.title = "Say what would be calculated, what is left out, and how long it takes";
  stage.help =
      "The settings that the accuracy asked for needs, what is left out with its bound, and a forecast of the time "
      "from a coarse trial. Writes nothing, or plan.json into the folder given with -o.";
  stage.inputName = "PROJECT";
  stage.run = plan;
  return stage;
}

}  // namespace goniolux::pipeline
