// Spectral sampling schemes in a picture: the first view by each scheme against every nanometre, colour by colour along
// the middle row, as in Hall and Greenberg's Figure 8.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/parallel.h"
#include "core/random.h"
#include "image/comparison.h"
#include "pipeline/engine.h"
#include "pipeline/render.h"
#include "pipeline/stages.h"
#include "pipeline/study_choices.h"

namespace goniolux::pipeline {
namespace {

struct Scheme {
  const char* name;
  int samples;
  bool drawn;  // a chart holds six curves
};
constexpr Scheme schemes[] = {{"rgb", 3, true},      {"xyz", 3, true},       {"meyer", 4, true},
                              {"paper", 9, true},    {"bins", 9, true},      {"gauss", 9, false},
                              {"uniform", 9, false}, {"uniform", 31, false}, {"adapted", 4, true}};

struct Picture {
  image::XyzImage image;
  double cpu_s = 0;
};

Picture rendered(project::Project project, const scene::View& view, const char* scheme, int samples,
                 core::ProgressSink& progress) {
  project.settings.spectralScheme = scheme;
  project.settings.spectralSamples = samples;
  const Engine engine(project, true);
  const double start = core::processCpuSeconds();
  // One key for all: what chance does is the same in all pictures.
  Picture picture{viewing::renderView(*engine.solver, view, engine.world.origin, core::mix(project.settings.seed),
                                      pixelAccuracyOf(project.settings), std::numeric_limits<double>::infinity(),
                                      progress)
                      .image};
  picture.cpu_s = core::processCpuSeconds() - start;
  return picture;
}

ChoiceResult run(const project::Project& project, core::ProgressSink& progress) {
  if (project.views.empty()) nothingToStudy(project, "the project has no view to show; add one to \"views\"");
  const scene::View& view = project.views.front();
  ChoiceResult result;
  result.columns = {
      "scheme", "samples", "mean_delta_e00", "p95_delta_e00", "largest_delta_e00", "luminance_rmse_percent", "cpu_s"};
  plot::LineChart& chart = result.chart;
  chart.title = project.name;
  chart.subtitle =
      fmt::format("View \"{}\", middle row: colour difference from the picture with every nanometre", view.name);
  chart.facts.emplace_back("mean ΔE00 of all pixels");
  chart.x = {"column of the picture / pixels", false};
  chart.y = {"ΔE00", false};
  const double parts = static_cast<double>(std::size(schemes)) + 1;
  progress.progress(project.name, 0, "every nanometre");
  core::SilentProgress silent;
  const Picture control = rendered(project, view, "control", 471, silent);
  const spectrum::Xyz white = lightestOf(control.image);
  if (!(white.Y > 0)) nothingToStudy(project, fmt::format("the view \"{}\" shows no light", view.name));
  const std::size_t middle = static_cast<std::size_t>(view.height / 2) * static_cast<std::size_t>(view.width);
  double done = 0;
  for (const Scheme& scheme : schemes) {
    progress.progress(project.name, ++done / parts, fmt::format("{}:{}", scheme.name, scheme.samples));
    if (progress.cancelled()) return result;
    const Picture picture = rendered(project, view, scheme.name, scheme.samples, silent);
    const image::Comparison difference = image::compare(control.image, picture.image, white);
    result.rows.push_back({scheme.name, std::to_string(scheme.samples), fmt::format("{:.3f}", difference.deltaMean),
                           fmt::format("{:.3f}", difference.deltaP95), fmt::format("{:.3f}", difference.deltaMax),
                           fmt::format("{:.3f}", 100 * difference.luminanceRmse / difference.meanLuminance),
                           fmt::format("{:.3g}", picture.cpu_s)});
    const std::string name = fmt::format("{} {}", scheme.name, scheme.samples);
    if (scheme.drawn) chart.facts.push_back(fmt::format("{}: {:.2f}", name, difference.deltaMean));
    for (int x = 0; scheme.drawn && x < view.width; ++x)
      addPoint(chart, name, x, static_cast<double>(difference.delta[middle + static_cast<std::size_t>(x)]));
  }
  result.rows.push_back({"control", "471", "0", "0", "0", "0", fmt::format("{:.3g}", control.cpu_s)});
  for (plot::ChartCurve& curve : chart.curves) curve.marked = false;
  chart.footer = fmt::format("goniolux {} · {} × {} pixels · white of CIELAB: {:.4g} cd/m²", programVersion(),
                             view.width, view.height, white.Y);
  return result;
}

}  // namespace

ChoiceStudy schemeStudy() {
  return {"schemes", "spectral sampling scheme of a picture",
          "colour difference along the middle row of the first view from the picture with every nanometre, by scheme "
          "(the paper's Figure 8)",
          run};
}

}  // namespace goniolux::pipeline
