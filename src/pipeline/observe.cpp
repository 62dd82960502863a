#include "pipeline/observe.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/glare.h"
#include "core/parallel.h"
#include "core/random.h"
#include "geometry/inside.h"
#include "pipeline/solids.h"

namespace goniolux::pipeline {
namespace {

std::string luminaireName(const project::Project& project, const Engine& engine, std::uint32_t source) {
  const std::uint32_t luminaire = engine.world.emitters[source].luminaire;
  return luminaire == scene::none ? "emitting surface" : project.environment.luminaires[luminaire].name;
}

/// The sources that CIE 117 does not vouch for, as a sentence; empty: none.
std::string outsideRange(const analysis::GlareEstimate& estimate) {
  std::string text;
  if (estimate.tooSmall > 0)
    text = fmt::format("{} luminous parts below 0.0003 sr, counted as small sources (CIE 147)", estimate.tooSmall);
  if (estimate.tooLarge > 0)
    text += fmt::format("{}{} luminous parts above 0.1 sr, for which UGR is not meant", text.empty() ? "" : "; ",
                        estimate.tooLarge);
  return text;
}

project::ObserverResult resultOf(const analysis::Observer& observer, const analysis::GlareEstimate& estimate,
                                 const project::Project& project, const Engine& engine) {
  project::ObserverResult result;
  result.name = observer.name;
  result.quantity = observer.quantity;
  result.value = estimate.ugr;
  result.eye = observer.eye;
  result.direction = observer.direction;
  result.background = estimate.background;
  // A luminaire of several openings, and an emitting surface of many triangles, is one line.
  for (const analysis::SeenGlare& seen : estimate.sources) {
    const std::string name = luminaireName(project, engine, seen.source);
    const auto known = std::find_if(result.sources.begin(), result.sources.end(),
                                    [&](const auto& source) { return source.luminaire == name; });
    if (known == result.sources.end()) {
      result.sources.push_back({name, seen.luminance, seen.solidAngle, seen.positionIndex, seen.share});
      continue;
    }
    const double whole = known->solidAngle + seen.solidAngle;
    known->luminance = (known->luminance * known->solidAngle + seen.luminance * seen.solidAngle) / whole;
    known->solidAngle = whole;
    known->share += seen.share;
  }
  return result;
}

}  // namespace

void rateObservers(const project::Project& project, const Engine& engine, double secondsLeft,
                   core::ProgressSink& progress, project::Results& results, const core::Keeping& keeping) {
  if (project.observers.empty()) return;
  const double start = core::wallSeconds();
  const auto elapsed = [&] { return core::wallSeconds() - start; };
  const std::vector<geometry::InsideTest> solids = solidsOf(project);
  const solver::SeenLights lights(engine.problem());
  const auto& asked = project.settings.accuracy;
  std::size_t left = project.observers.size();
  for (const analysis::Observer& observer : project.observers) {
    for (const geometry::InsideTest& solid : solids)
      if (solid.contains(observer.eye))
        throw core::InputError(
            observer.position, "eye-inside-object",
            fmt::format("the eye of observer \"{}\" lies inside a solid object; move it", observer.name));
    progress.progress(observer.name, 0, "glare rating");
    const double limit = (secondsLeft - elapsed()) / static_cast<double>(left--);
    const analysis::GlareEstimate estimate =
        analysis::estimateGlare(*engine.solver, lights, observer.eye - engine.world.origin, observer.direction,
                                core::keyOf(project.settings.seed, observer.name), asked.ugr, asked.confidence, limit,
                                progress, keeping.part("observer " + observer.name));
    results.observers.push_back(resultOf(observer, estimate, project, engine));
    if (const std::string outside = outsideRange(estimate); !outside.empty())
      results.leftOut.push_back(fmt::format("observer \"{}\": {}", observer.name, outside));
    if (!estimate.reached) {
      const bool dark = !progress.cancelled() && !(estimate.background.value > 0);
      results.reached = false;
      results.reachedText +=
          fmt::format("{}{}: {}", results.reachedText.empty() ? "" : "; ", observer.name,
                      dark ? "no UGR without any light on the background"
                           : fmt::format("UGR within {:.2g}, {:g} was asked", estimate.ugr.halfWidth(), asked.ugr));
    }
    progress.progress(observer.name, 1, fmt::format("UGR {:.1f}", estimate.ugr.value));
  }
}

}  // namespace goniolux::pipeline
