// Studies of the intersection tree: its depth (the paper's Table 2) and its reflection models (Figures 5 and 6), on a
// view of the project.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/parallel.h"
#include "pipeline/engine.h"
#include "pipeline/study_choices.h"
#include "reflection/bsdf.h"

namespace goniolux::pipeline {
namespace {

constexpr int studyWidth = 160;  // pixels of the view, one ray each
constexpr int depths[] = {1, 2, 3, 4, 5, 6, 8, 10, 12, 15};
constexpr double cutoffs[] = {0.5, 0.2, 0.1, 0.05, 0.02, 0.01, 0.005, 0.002, 0.001};
constexpr int deepEnough = 60;
constexpr double mostNodes = 300;           // of a forced tree: it may double with every level
constexpr double drawnAtLeast = 1e-3;       // %, the axis is logarithmic
constexpr std::uint32_t pathSamples = 256;  // per pixel of the profile that the trees are held against

struct TreeRun {
  std::vector<double> luminances;
  double nodes = 0, cpu_s = 0;
};

scene::View smallView(const project::Project& project) {
  if (project.views.empty()) nothingToStudy(project, "trees belong to pictures, and the project has no view; add one");
  return smallFirstView(project, studyWidth);
}

/// One ray through the middle of every pixel of the rows [from, to).
TreeRun trace(const project::Project& project, const scene::View& view, int from, int to, std::uint32_t samples = 1) {
  const double cpu = core::processCpuSeconds();
  const Engine engine(project, false);
  TreeRun run;
  run.luminances.resize(static_cast<std::size_t>(view.width) * static_cast<std::size_t>(to - from));
  core::parallelFor(run.luminances.size(), 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto row = static_cast<int>(i) / view.width, column = static_cast<int>(i) % view.width;
      const scene::ViewRay ray = scene::rayThrough(view, column + 0.5, from + row + 0.5);
      if (!ray.inside) continue;
      for (std::uint32_t s = 0; s < samples; ++s)
        run.luminances[i] +=
            engine.solver->radiance(ray.origin - engine.world.origin, ray.direction, i, s)[1] / samples;
    }
  });
  for (const solver::Statistic& statistic : engine.solver->statistics())
    if (statistic.name == "average_tree_depth") run.nodes = statistic.value;
  run.cpu_s = core::processCpuSeconds() - cpu;
  return run;
}

project::Project treeProject(const project::Project& project, int depth, double cutoff, bool adaptive) {
  project::Project own = project;
  own.settings.solver = "tree";
  own.settings.treeMaxDepth = depth;
  own.settings.treeCutoff = cutoff;
  own.settings.treeAdaptive = adaptive;
  return own;
}

ChoiceResult depth(const project::Project& project, core::ProgressSink& progress) {
  const scene::View view = smallView(project);
  const TreeRun reference = trace(treeProject(project, deepEnough, 0, true), view, 0, view.height);
  double sum = 0;
  for (const double luminance : reference.luminances) sum += luminance;
  if (!(sum > 0)) nothingToStudy(project, fmt::format("the view \"{}\" shows no light", view.name));
  ChoiceResult result;
  result.columns = {"control", "value", "nodes_per_ray", "cpu_s", "error_percent"};
  plot::LineChart& chart = result.chart;
  chart.title = project.name;
  chart.subtitle = fmt::format("View \"{}\": what ending the intersection trees spoils, and saves", view.name);
  chart.x = {"nodes per ray", true};
  chart.y = {"mean error of luminance / %", true};
  double forcedNodes = 0, adaptiveNodes = 0, forced_s = 0, adaptive_s = 0;
  const auto add = [&](const std::string& control, double value, const TreeRun& run) {
    double error = 0;
    for (std::size_t i = 0; i < run.luminances.size(); ++i)
      error += std::abs(run.luminances[i] - reference.luminances[i]);
    addPoint(chart, control, run.nodes, std::max(100 * error / sum, drawnAtLeast));
    result.rows.push_back({control, fmt::format("{:g}", value), fmt::format("{:.4f}", run.nodes),
                           fmt::format("{:.3g}", run.cpu_s), fmt::format("{:.4g}", 100 * error / sum)});
  };
  const double steps = 2 * std::size(depths) + std::size(cutoffs);
  double done = 0;
  const auto next = [&](const std::string& text) {
    progress.progress(project.name, ++done / steps, text);
    return !progress.cancelled();
  };
  for (const int cap : depths) {
    if (!next(fmt::format("adaptive to depth {}", cap))) return result;
    const TreeRun run = trace(treeProject(project, cap, 0, true), view, 0, view.height);
    add("adaptive, depth cap", cap, run);
    adaptiveNodes = run.nodes, adaptive_s = run.cpu_s;
  }
  for (const double cutoff : cutoffs) {
    if (!next(fmt::format("cut-off {}", cutoff))) return result;
    add("adaptive, cut-off", cutoff, trace(treeProject(project, deepEnough, cutoff, true), view, 0, view.height));
  }
  double before = 1;
  for (const int cap : depths) {
    if (!next(fmt::format("forced to depth {}", cap))) return result;
    const TreeRun run = trace(treeProject(project, cap, 0, false), view, 0, view.height);
    add("forced to depth", cap, run);
    forcedNodes = run.nodes, forced_s = run.cpu_s;
    if (run.nodes * std::max(2.0, run.nodes / before) > mostNodes) break;
    before = run.nodes;
  }
  chart.facts.push_back(fmt::format("forced {:.2f} nodes a ray, adaptive {:.2f} (Hall and Greenberg: 14.89 and 1.71)",
                                    forcedNodes, adaptiveNodes));
  if (adaptive_s > 0)
    chart.facts.push_back(fmt::format("CPU time forced : adaptive = {:.2g} (theirs 8.2)", forced_s / adaptive_s));
  chart.footer = fmt::format("goniolux {} · against adaptive trees of depth {} · {} × {} rays", programVersion(),
                             deepEnough, view.width, view.height);
  return result;
}

ChoiceResult models(const project::Project& project, core::ProgressSink& progress) {
  const scene::View view = smallView(project);
  const int row = view.height / 2;
  ChoiceResult result;
  result.columns = {"model", "column", "luminance_cd_m2"};
  plot::LineChart& chart = result.chart;
  chart.title = project.name;
  chart.subtitle = fmt::format("View \"{}\", middle row: the same scene by each reflection model", view.name);
  chart.x = {"column of the picture / pixels", false};
  chart.y = {"luminance / (cd/m²)", true};
  std::vector<std::pair<std::string, TreeRun>> runs;
  const char* names[] = {"material", "phong", "whitted", "hall"};
  for (const char* name : names) {
    progress.progress(project.name, static_cast<double>(runs.size()) / 5, name);
    if (progress.cancelled()) return result;
    project::Project own = treeProject(project, project.settings.treeMaxDepth, project.settings.treeCutoff, true);
    own.settings.reflectionModel = name;
    runs.emplace_back(std::string(name) == "material" ? "own finishes (tree)" : name, trace(own, view, row, row + 1));
  }
  // Paths need finishes that say how much light they reflect; the paper's models do not.
  const auto& materials = project.environment.materials;
  const bool physical = std::all_of(materials.begin(), materials.end(), [](const material::Material& m) {
    return reflection::findReflectionModel(m.model) != nullptr;
  });
  if (physical) {
    project::Project whole = project;
    whole.settings.solver = "path";
    progress.progress(project.name, 0.8, "with interreflection");
    runs.emplace_back("with interreflection (path)", trace(whole, view, row, row + 1, pathSamples));
  }
  double lowest = 0;
  for (const auto& [name, run] : runs)
    for (const double luminance : run.luminances) lowest = std::max(lowest, 1e-4 * luminance);
  if (!(lowest > 0))
    nothingToStudy(project, fmt::format("the view \"{}\" shows no light in its middle row", view.name));
  const auto& standard = physical ? runs.back() : runs.front();
  const std::vector<double>& truth = standard.second.luminances;
  for (const auto& [name, run] : runs) {
    double difference = 0, sum = 0;
    for (std::size_t i = 0; i < truth.size(); ++i) {
      addPoint(chart, name, static_cast<double>(i), std::max(run.luminances[i], lowest));
      result.rows.push_back({name, fmt::format("{}", i), fmt::format("{:.5g}", run.luminances[i])});
      difference += run.luminances[i] - truth[i];
      sum += truth[i];
    }
    if (&run != &standard.second)
      chart.facts.push_back(fmt::format("{}: {:+.0f} % on average", name, 100 * difference / sum));
  }
  for (plot::ChartCurve& curve : chart.curves) curve.marked = false;
  chart.footer =
      fmt::format("goniolux {} · the paper's models leave interreflection to their ambient term (settings.ambient)",
                  programVersion());
  return result;
}

}  // namespace

ChoiceStudy treeDepthStudy() {
  return {"tree-depth", "depth of the intersection trees",
          "mean error of the first view's luminances over the nodes per ray: trees forced to a depth, ended "
          "adaptively, cut "
          "off (the paper's Table 2)",
          depth};
}

ChoiceStudy reflectionModelStudy() {
  return {
      "reflection-model", "the reflection model",
      "luminance along the middle row of the first view by each finish's own model and by those of the paper (Figures "
      "5 and 6), and with interreflection",
      models};
}

}  // namespace goniolux::pipeline
