// Study of wavelengths, the paper's Figure 8 for a project's own colours: what each way of sampling the spectrum misses
// on the light paths that are likely in its scene, over the number of samples. No chance is involved.
#include <fmt/format.h>

#include <algorithm>

#include "pipeline/engine.h"
#include "pipeline/study_choices.h"
#include "planner/spectral_choice.h"

namespace goniolux::pipeline {
namespace {

constexpr int counts[] = {3, 4, 5, 6, 7, 9, 12, 16, 24, 31, 48, 81};
constexpr const char* schemes[] = {"adapted", "uniform", "bins", "point", "paper", "xyz"};
constexpr double drawnAtLeast = 1e-3;  // CIEDE2000: below it nothing is seen, and the axis is logarithmic
constexpr double justVisible = 1;

ChoiceResult run(const project::Project& project, core::ProgressSink& progress) {
  const scene::World world = scene::buildWorld(project.environment);
  const auto finishes = planner::finishesOf(world);
  bool coloured = false;
  for (const auto& finish : finishes) coloured = coloured || !finish.reflectance.isFlat();
  if (!coloured)
    nothingToStudy(project, "every finish of the project is grey: one wavelength is exact; give a material a spectrum");
  ChoiceResult result;
  result.columns = {"scheme", "samples", "largest_de2000", "largest_illuminance_error_percent"};
  plot::LineChart& chart = result.chart;
  chart.title = project.name;
  chart.subtitle = "What few wavelengths spoil: largest colour difference over the scene's likely light paths";
  chart.x = {"wavelengths (or colour channels)", true};
  chart.y = {"CIEDE2000 to every nanometre", true};
  chart.guides = {justVisible};
  planner::SpectralAllowance allowance;
  allowance.pictures = true;
  std::size_t done = 0;
  for (const char* name : schemes) {
    const spectrum::SpectralScheme& scheme = *spectrum::findSpectralScheme(name);
    for (const int count : counts) {
      progress.progress(project.name, static_cast<double>(++done) / (std::size(schemes) * std::size(counts)),
                        fmt::format("{}:{}", name, count));
      if (progress.cancelled()) return result;
      if (count < scheme.leastCount || count > scheme.mostCount) continue;
      // An adapted set of many nodes takes long to find and is no better than the accuracy of its search.
      if (scheme.name == "adapted" && count > 16) continue;
      const auto choice = planner::wavelengthsOf(scheme, count, finishes, world.sourceSpectra, allowance);
      addPoint(chart, name, count, std::max(choice.error.colour, drawnAtLeast));
      result.rows.push_back({name, fmt::format("{}", count), fmt::format("{:.4g}", choice.error.colour),
                             fmt::format("{:.4g}", 100 * choice.error.illuminance)});
    }
  }
  const Engine engine(project, true);
  chart.facts.push_back(fmt::format("the planner takes {}: at most ΔE {:.2g} for pictures",
                                    engine.plan.quadrature.scheme, engine.plan.colourBound));
  chart.notes.push_back({"auto",
                         {static_cast<double>(engine.plan.quadrature.wavelengths.size()),
                          std::max(engine.plan.colourBound, drawnAtLeast)}});
  chart.footer =
      fmt::format("goniolux {} · grey line: a difference that one just sees · {} finishes, {} spectra of lamps",
                  programVersion(), finishes.size(), world.sourceSpectra.size());
  return result;
}

}  // namespace

ChoiceStudy wavelengthStudy() {
  return {
      "wavelengths", "number and choice of wavelengths",
      "largest colour difference and error of illuminance on the scene's likely light paths, by scheme and number of "
      "samples (the paper's Figure 8)",
      run};
}

}  // namespace goniolux::pipeline
