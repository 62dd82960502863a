#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include "core/parallel.h"
#include "pipeline/engine.h"
#include "pipeline/illuminate.h"
#include "pipeline/study.h"

namespace goniolux::pipeline {
namespace {

constexpr double normalQuantile95 = 1.959964;
// A point below this share of its grid's mean is judged by it, as accuracy is asked for.
constexpr double leastShare = 0.1;

// Exact runs have no place on a logarithmic axis.
double drawnPercent(double rms) {
  return std::max(100 * rms, 1e-4);
}

// Linux keeps the peak of a process and starts anew when told to; elsewhere it stays unknown.
void forgetPeakMemory() {
  std::ofstream("/proc/self/clear_refs") << "5";
}
double peakMemory() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("VmHWM:")) {
      std::istringstream words(line.substr(6));
      double kibibytes = 0;
      words >> kibibytes;
      return kibibytes / 1024;
    }
  return 0;
}

}  // namespace

void compareWithReference(const project::Results& found, const StudyReference& reference, StudyRun& run) {
  double squares = 0, sum = 0, inside = 0, count = 0;
  run.largest = 0;
  for (std::size_t g = 0; g < std::min(found.grids.size(), reference.results.grids.size()); ++g) {
    const project::GridResult &grid = found.grids[g], &truth = reference.results.grids[g];
    for (std::size_t i = 0; i < std::min(grid.values.size(), truth.values.size()); ++i) {
      if (!std::isfinite(grid.values[i]) || !std::isfinite(truth.values[i])) continue;
      const double scale = std::max(truth.values[i], leastShare * truth.mean.value);
      const double error = scale > 0 ? (grid.values[i] - truth.values[i]) / scale : 0;
      squares += error * error;
      sum += error;
      run.largest = std::max(run.largest, std::abs(error));
      inside += std::abs(grid.values[i] - truth.values[i]) <= std::hypot(grid.halfWidths[i], truth.halfWidths[i]);
      ++count;
    }
  }
  if (count == 0) return;
  run.rms = std::sqrt(squares / count);
  run.mean = sum / count;
  run.inside = inside / count;
}

StudyRun runSetting(const project::Project& project, const StudySetting& setting, const StudyReference& reference,
                    std::uint64_t seed, core::ProgressSink& progress) {
  project::Project own = project;
  own.settings.solver = setting.solver;
  own.settings.accuracy.grid = setting.accuracy;
  own.settings.seed = seed;
  own.observers.clear();
  if (setting.spectral != "auto") {
    const auto colon = setting.spectral.find(':');
    own.settings.spectralScheme = setting.spectral.substr(0, colon);
    own.settings.spectralSamples = colon == std::string::npos ? 0 : std::stoi(setting.spectral.substr(colon + 1));
  }
  StudyRun run;
  run.setting = setting;
  forgetPeakMemory();
  const double cpu = core::processCpuSeconds(), wall = core::wallSeconds();
  const Engine engine(own, false);
  const project::Results found = calculateGrids(own, engine, progress);
  run.cpu_s = core::processCpuSeconds() - cpu;
  run.wall_s = core::wallSeconds() - wall;
  run.rays = engine.solver->rays();
  run.reached = found.reached;
  run.peakMemory_MiB = peakMemory();
  compareWithReference(found, reference, run);
  return run;
}

std::vector<const StudyRun*> paretoFront(const std::vector<StudyRun>& runs) {
  std::vector<const StudyRun*> front;
  for (const StudyRun& run : runs) {
    const bool beaten = std::any_of(runs.begin(), runs.end(), [&](const StudyRun& other) {
      return (other.cpu_s < run.cpu_s && other.rms <= run.rms) || (other.cpu_s <= run.cpu_s && other.rms < run.rms);
    });
    if (!beaten) front.push_back(&run);
  }
  std::sort(front.begin(), front.end(), [](const auto* a, const auto* b) { return a->cpu_s < b->cpu_s; });
  return front;
}

plot::LineChart workPrecisionChart(const std::string& project, const std::vector<StudyRun>& runs,
                                   const StudyReference& reference) {
  plot::LineChart chart;
  chart.title = project;
  chart.subtitle = "What accuracy costs: each run against one long unbiased reference";
  chart.x = {"CPU time / s", true};
  chart.y = {"RMS error of the points / %", true};
  // Below its own noise the reference cannot tell one run from another.
  if (reference.noise > 0) chart.guides = {100 * reference.noise};
  for (const StudyRun& run : runs) {
    auto line = std::find_if(chart.curves.begin(), chart.curves.end(),
                             [&](const plot::ChartCurve& curve) { return curve.name == run.setting.line; });
    if (line == chart.curves.end()) line = chart.curves.insert(line, {run.setting.line, {}, true});
    line->points.emplace_back(run.cpu_s, drawnPercent(run.rms));
  }
  for (plot::ChartCurve& curve : chart.curves)
    std::sort(curve.points.begin(), curve.points.end(), [](const auto& a, const auto& b) { return a.x < b.x; });
  for (const StudyRun& run : runs)
    if (run.isAuto) {
      chart.notes.push_back({"auto", {run.cpu_s, drawnPercent(run.rms)}});
      chart.facts.push_back(fmt::format("auto chose {} at ± {:g} %: {:.2g} s, RMS {:.2g} %", run.setting.solver,
                                        100 * run.setting.accuracy, run.cpu_s, 100 * run.rms));
    }
  for (const StudyRun& run : runs)
    if (run.inside < 0.5) {
      chart.facts.push_back(fmt::format("{}: biased, stays at {:.2g} %", run.setting.line, 100 * run.rms));
      break;
    }
  chart.footer = fmt::format("goniolux {} · grey line: the reference's own noise, {:.2g} % · {} points",
                             programVersion(), 100 * reference.noise, [&] {
                               std::size_t points = 0;
                               for (const auto& grid : reference.results.grids) points += grid.points.size();
                               return points;
                             }());
  return chart;
}

std::string studyCsv(const std::vector<StudyRun>& runs) {
  std::string csv =
      "line,solver,accuracy_asked_percent,spectral,auto,reached,cpu_s,wall_s,rays,rms_percent,largest_percent,"
      "mean_percent,inside_percent,peak_memory_mib\n";
  for (const StudyRun& run : runs)
    csv += fmt::format("{},{},{:g},{},{},{},{:.4g},{:.4g},{},{:.4g},{:.4g},{:.4g},{:.4g},{:.0f}\n", run.setting.line,
                       run.setting.solver, 100 * run.setting.accuracy, run.setting.spectral, run.isAuto ? 1 : 0,
                       run.reached ? 1 : 0, run.cpu_s, run.wall_s, run.rays, 100 * run.rms, 100 * run.largest,
                       100 * run.mean, 100 * run.inside, run.peakMemory_MiB);
  return csv;
}

core::Value toJson(const StudyRun& run) {
  core::Value json;
  json.set("line", run.setting.line);
  json.set("solver", run.setting.solver);
  json.set("accuracy", run.setting.accuracy);
  json.set("spectral", run.setting.spectral);
  json.set("auto", run.isAuto);
  json.set("reached", run.reached);
  json.set("cpu_s", run.cpu_s);
  json.set("wall_s", run.wall_s);
  json.set("rays", static_cast<double>(run.rays));
  json.set("rms", run.rms);
  json.set("largest", run.largest);
  json.set("mean", run.mean);
  json.set("inside", run.inside);
  json.set("peak_memory_mib", run.peakMemory_MiB);
  return json;
}

std::optional<StudyRun> studyRunFromJson(const core::Value& json) {
  StudyRun run;
  if (!json.isObject()) return std::nullopt;
  const auto text = [&](const char* key, std::string& into) {
    const core::Value* value = json.find(key);
    if (value == nullptr || !value->isString()) return false;
    into = value->string();
    return true;
  };
  const auto number = [&](const char* key, double& into) {
    const core::Value* value = json.find(key);
    if (value == nullptr || !value->isNumber()) return false;
    into = value->number();
    return true;
  };
  const auto yes = [&](const char* key, bool& into) {
    const core::Value* value = json.find(key);
    if (value == nullptr || !value->isBoolean()) return false;
    into = value->boolean();
    return true;
  };
  double rays = 0;
  if (!text("line", run.setting.line) || !text("solver", run.setting.solver) ||
      !number("accuracy", run.setting.accuracy) || !text("spectral", run.setting.spectral) ||
      !yes("auto", run.isAuto) || !yes("reached", run.reached) || !number("cpu_s", run.cpu_s) ||
      !number("wall_s", run.wall_s) || !number("rays", rays) || !number("rms", run.rms) ||
      !number("largest", run.largest) || !number("mean", run.mean) || !number("inside", run.inside) ||
      !number("peak_memory_mib", run.peakMemory_MiB))
    return std::nullopt;
  run.rays = static_cast<std::uint64_t>(rays);
  return run;
}

}  // namespace goniolux::pipeline
