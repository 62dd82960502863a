// Study of near-field subdivision: the error of a luminaire that is taken for one point, or for a few, over the
// distance in its own sizes. No chance is involved.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "emitter/near_field.h"
#include "pipeline/engine.h"
#include "pipeline/study_choices.h"

namespace goniolux::pipeline {
namespace {

constexpr int cuts[] = {1, 2, 4, 8};
constexpr double smallest = 0.25, largest = 32;  // distance over size
constexpr double drawnAtLeast = 1e-3;            // %, the axis is logarithmic
constexpr double engineersRule = 5;              // distances of five sizes are taken for far

emitter::Output outputOf(const scene::Luminaire& luminaire) {
  emitter::Output output;
  output.distribution = luminaire.distribution;
  output.frame = luminaire.frame;
  output.scale = luminaire.scale;
  output.flux_lm = luminaire.flux_lm;
  return output;
}

ChoiceResult run(const project::Project& project, core::ProgressSink& progress) {
  // The luminaire with the largest opening; others are rows of the table.
  std::vector<const scene::Luminaire*> types;
  std::set<std::string> seen;
  for (const scene::Luminaire& luminaire : project.environment.luminaires)
    if (emitter::largestExtent(luminaire.opening) > 0 && luminaire.distribution && seen.insert(luminaire.type).second)
      types.push_back(&luminaire);
  if (types.empty())
    nothingToStudy(project,
                   "no luminaire has an opening with a luminous intensity distribution: all are points; give one a "
                   "\"shape\", or a file that states its opening");
  const auto extent = [](const scene::Luminaire* type) { return emitter::largestExtent(type->opening); };
  const scene::Luminaire* drawn =
      *std::max_element(types.begin(), types.end(), [&](auto* a, auto* b) { return extent(a) < extent(b); });
  ChoiceResult result;
  result.columns = {"luminaire", "points", "distance_over_size", "error_percent"};
  plot::LineChart& chart = result.chart;
  chart.title = project.name;
  chart.subtitle =
      fmt::format("\"{}\" ({}) as points: error of the illuminance straight ahead", drawn->type, drawn->photometry);
  chart.x = {"distance / largest size of the opening", true};
  chart.y = {"error / %", true};
  chart.guides = {1};
  for (const scene::Luminaire* type : types) {
    const emitter::Output output = outputOf(*type);
    for (const int n : cuts)
      for (double q = smallest; q <= largest * 1.001; q *= std::sqrt(2.0)) {
        if (progress.cancelled()) return result;
        const auto error = emitter::cutError(type->opening, output, q * extent(type), n);
        if (!error) continue;  // no light straight ahead
        if (type == drawn)
          addPoint(chart, n == 1 ? "one point" : fmt::format("{} × {} points", n, n), q,
                   std::max(std::abs(100 * *error), drawnAtLeast));
        result.rows.push_back(
            {type->type, fmt::format("{}", n * n), fmt::format("{:.4g}", q), fmt::format("{:.4g}", 100 * *error)});
      }
  }
  if (chart.curves.empty())
    nothingToStudy(project, fmt::format("the luminaire \"{}\" gives no light along its aim", drawn->type));
  const auto at = emitter::cutError(drawn->opening, outputOf(*drawn), engineersRule * extent(drawn), 1);
  if (at) chart.facts.push_back(fmt::format("one point at five sizes: {:.2g} %", 100 * std::abs(*at)));
  if (const auto from = emitter::pointModelFrom(drawn->opening, outputOf(*drawn), 0.01))
    chart.facts.push_back(
        fmt::format("one point is within 1 % from {:.2g} sizes = {:.2f} m on", *from / extent(drawn), *from));
  chart.footer = fmt::format("goniolux {} · reference: closed form or quadrature of the opening · grey line: 1 %",
                             programVersion());
  return result;
}

}  // namespace

ChoiceStudy nearFieldStudy() {
  return {
      "near-field", "subdivision of luminous openings",
      "error of the illuminance straight ahead when an opening is one point, or a few, over the distance in sizes of "
      "the opening",
      run};
}

}  // namespace goniolux::pipeline
