// The reference and the runs of a study on the grids.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "analysis/grid_estimate.h"
#include "core/parallel.h"
#include "core/random.h"
#include "core/statistics.h"
#include "core/text.h"
#include "pipeline/engine.h"
#include "pipeline/illuminate.h"
#include "pipeline/study.h"

namespace goniolux::pipeline {
namespace {

namespace fs = std::filesystem;

constexpr double referenceAccuracy = 0.0015;  // finer than any rung, if time allows
constexpr double longEnough = 0.7;            // of the time that a kept reference would be given now
// A point below this share of its grid's mean is judged by it, as accuracy is asked for.
constexpr double leastShare = 0.1;

}  // namespace

// Linux keeps the peak of a process and starts anew when told to; elsewhere it stays unknown.
void forgetPeakMemory() {
  std::ofstream("/proc/self/clear_refs") << "5";
}
double peakMemory_MiB() {
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

// The reference's document says `key` where results have their project's hash.
StudyReference makeReference(const project::Project& project, const std::string& key, const std::string& file,
                             double seconds, core::ProgressSink& progress) {
  StudyReference reference;
  bool known = false;
  if (fs::exists(file)) {
    try {
      reference.results = project::readResults(file);
      known = reference.results.projectHash == key && reference.results.grids.size() == project.grids.size() &&
              (reference.results.reached || reference.results.wallTime_s >= longEnough * seconds);
    } catch (const core::InputError&) {
      known = false;  // damaged: made again
    }
  }
  if (!known) {
    project::Project own = project;
    own.settings.solver = "path";
    own.settings.seed = core::mix(project.settings.seed ^ 0x5eedull);
    own.settings.timeLimit_s = seconds;
    own.settings.accuracy.grid = referenceAccuracy;
    own.observers.clear();
    own.requirements.clear();
    const Engine engine(own, false);
    reference.results = calculateGrids(own, engine, progress);
    reference.results.projectHash = key;
    if (!progress.cancelled()) core::writeFile(file, core::toJson(project::toJson(reference.results)));
  }
  const double quantile = core::studentQuantile(analysis::replicateCount - 1, reference.results.confidence);
  double squares = 0, count = 0;
  for (const project::GridResult& grid : reference.results.grids)
    for (std::size_t i = 0; i < grid.values.size(); ++i) {
      if (!std::isfinite(grid.values[i]) || !(grid.values[i] > 0)) continue;
      const double relative = grid.halfWidths[i] / std::max(grid.values[i], leastShare * grid.mean.value) / quantile;
      squares += relative * relative;
      ++count;
    }
  reference.noise = count > 0 ? std::sqrt(squares / count) : 0;
  return reference;
}

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
                    std::uint64_t seed, double seconds, core::ProgressSink& progress, project::Results* kept) {
  project::Project own = withSetting(project, setting, seed, seconds);
  own.settings.accuracy.grid = setting.accuracy;
  own.observers.clear();
  StudyRun run;
  run.setting = setting;
  forgetPeakMemory();
  const double cpu = core::processCpuSeconds(), wall = core::wallSeconds();
  const Engine engine(own, false);
  project::Results found = calculateGrids(own, engine, progress);
  run.cpu_s = core::processCpuSeconds() - cpu;
  run.wall_s = core::wallSeconds() - wall;
  run.rays = engine.solver->rays();
  run.reached = found.reached;
  run.peakMemory_MiB = peakMemory_MiB();
  if (!found.leftOut.empty()) run.leftOut = found.leftOut.front();
  compareWithReference(found, reference, run);
  if (kept != nullptr) *kept = std::move(found);
  return run;
}

}  // namespace goniolux::pipeline
