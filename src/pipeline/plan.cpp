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

constexpr double trialSeconds = 3;  // for each grid and each picture
constexpr const char* missedTask = "what the light solution misses";

double cpuPerThread() {
  return core::processCpuSeconds() / core::threadCount();
}

/// Notes when a trial was looking for what the light solution misses: that costs the same however many points or pixels
/// there are.
class TrialClock final : public core::ProgressSink {
 public:
  void progress(const std::string&, double, const std::string& reached) override {
    const double now = cpuPerThread();
    if (isFixed_) fixed_s += now - last_;
    isFixed_ = reached == missedTask;
    last_ = now;
  }
  void note(const std::string&) override {}
  double fixed_s = 0;

 private:
  double last_ = 0;
  bool isFixed_ = false;
};

/// A trial with some of the grid's points at the accuracy asked for: what each costs, times their number.
double gridSeconds(const project::Project& project, const Engine& engine, const analysis::Grid& grid) {
  const auto& accuracy = project.settings.accuracy;
  std::vector<solver::Receiver> some;
  const std::size_t step = std::max<std::size_t>(1, grid.points.size() / 64);
  for (std::size_t i = step / 2; i < grid.points.size(); i += step)
    some.push_back({grid.points[i] - engine.world.origin, grid.normals[i], analysis::findQuantity(grid.quantity)->body,
                    grid.axis});
  if (some.empty()) return 0;
  TrialClock clock;
  const double start = cpuPerThread();
  const analysis::GridEstimate e =
      analysis::estimateGrid(*engine.solver, *analysis::findQuantity(grid.quantity), some, core::mix(1),
                             {accuracy.grid, accuracy.u0, accuracy.confidence, 0.01}, {trialSeconds}, clock, grid.name);
  const double seconds = cpuPerThread() - start;
  // Out of time, the half-widths say what is left: effort grows with their square.
  double more = 1;
  if (!e.reached && seconds > 0.5 * trialSeconds) {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < e.values.size(); ++i) {
      const double allowed = accuracy.grid * std::max(e.values[i], 0.1 * e.mean.value);
      if (allowed > 0) ratios.push_back(e.statistical[i] / allowed);
    }
    if (!ratios.empty()) more = std::max(1.0, std::pow(analysis::quantileOf(ratios, 0.9), 2));
  }
  const double perPoint = static_cast<double>(grid.points.size()) / static_cast<double>(some.size());
  return clock.fixed_s + (seconds - clock.fixed_s) * perPoint * more;
}

/// Two small pictures of the view. Pixels across an edge need far more samples than others, and grow in number with the
/// picture's length, not its area: seconds = a pixels + b length.
double viewSeconds(const project::Project& project, const Engine& engine, const scene::View& view) {
  const double pixels = static_cast<double>(view.width) * view.height;
  double samples[2] = {}, size[2] = {}, perSample = 0, fixed = 0;
  for (int k = 0; k < 2; ++k) {
    scene::View small = view;
    const double shrink = std::max(1.0, std::sqrt(pixels / (k == 0 ? 1024 : 4096)));
    small.width = std::max(1, static_cast<int>(view.width / shrink));
    small.height = std::max(1, static_cast<int>(view.height / shrink));
    size[k] = static_cast<double>(small.width) * small.height;
    TrialClock clock;
    const double start = cpuPerThread();
    const viewing::ImageEstimate e = viewing::renderView(*engine.solver, small, engine.world.origin, core::mix(2),
                                                         pixelAccuracyOf(project.settings), trialSeconds, clock);
    samples[k] = static_cast<double>(e.samples);
    perSample = (cpuPerThread() - start - clock.fixed_s) / std::max(1.0, samples[k]);
    fixed = clock.fixed_s;
    if (size[k] >= pixels) return fixed + perSample * samples[k];
  }
  const double l0 = std::sqrt(size[0]), l1 = std::sqrt(size[1]);
  const double b = std::max(0.0, (samples[0] / size[0] - samples[1] / size[1]) / (1 / l0 - 1 / l1));
  const double a = samples[1] / size[1] - b / l1;
  return fixed + perSample * (std::max(a, 0.25 * samples[1] / size[1]) * pixels + b * std::sqrt(pixels));
}

Forecast forecast(const project::Project& project, const Engine& engine) {
  Forecast f;
  for (const analysis::Grid& grid : project.grids) f.grids_s += gridSeconds(project, engine, grid);
  for (const scene::View& view : project.views) f.images_s += viewSeconds(project, engine, view);
  return f;
}

StageReport plan(const StageRequest& request, core::ProgressSink&) {
  const project::Project project = readProjectFor(request, AccuracyOf::both);
  const double start = cpuPerThread();
  const Engine engine(project, !project.views.empty());
  const double preparation_s = cpuPerThread() - start;
  const Forecast f = forecast(project, engine);

  StageReport report;
  report.warnings = project.warnings;
  report.json = planDocument(project, engine);
  report.text = fmt::format("{}\n  solver {}, {} spectral samples ({})\n", project.name, engine.plan.solver,
                            engine.plan.quadrature.wavelengths.size(), engine.plan.quadrature.scheme);
  for (const std::string& reason : engine.plan.reasons) report.text += "  because: " + reason + "\n";
  for (const std::string& sentence : leftOutSentences(engine)) report.text += "  left out: " + sentence + "\n";
  report.json.set("predicted_time_s", preparation_s + f.grids_s + f.images_s);
  report.text += fmt::format(
      "  about {:.1f} s to begin, {:.1f} s for the grids to {:g} %, {:.1f} s for the views to {:g} %, on {} threads\n",
      preparation_s, f.grids_s, 100 * project.settings.accuracy.grid, f.images_s, 100 * project.settings.accuracy.image,
      core::threadCount());
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
