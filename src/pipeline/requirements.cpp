#include "pipeline/requirements.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>

#include "spectrum/colour_rendering.h"

namespace goniolux::pipeline {
namespace {

using Verdict = project::RequirementResult::Verdict;

/// The lowest R_a among the luminaires that are on; NaN where a spectrum is not known (an equal-energy one stands in).
core::Estimate colourRenderingOf(const project::Project& project) {
  core::Estimate lowest;
  lowest.value = std::numeric_limits<double>::quiet_NaN();
  const scene::Environment& environment = project.environment;
  std::set<std::uint32_t> used;
  for (const scene::Luminaire& luminaire : environment.luminaires)
    if (luminaire.flux_lm * luminaire.dimming > 0) used.insert(luminaire.spectrum);
  for (const std::uint32_t index : used) {
    const spectrum::SpectralDistribution& light = environment.sourceSpectra[index];
    if (light.isFlat()) return {std::numeric_limits<double>::quiet_NaN(), 0, {}};
    const double ra = spectrum::colourRendering(light).ra;
    if (!(lowest.value <= ra)) lowest.value = ra;
  }
  return lowest;
}

/// NaN when it is not known: of a grid that an interrupted run has no numbers of. Nothing where it is not calculated:
/// glare ratings of lighting scenes.
std::optional<core::Estimate> quantityOf(const project::Results& results, const analysis::Requirement& requirement,
                                         const std::string& key) {
  for (const auto& grid : results.grids) {
    if (grid.name != requirement.grid) continue;
    if (key == "mean_lx") return grid.mean;
    if (key == "min_lx") return grid.min;
    if (key == "max_lx") return grid.max;
    if (key == "u0") return grid.u0;
    if (key == "ud") return grid.ud;
  }
  for (const auto& observer : results.observers)
    if (observer.name == requirement.observer && observer.quantity == key) return observer.value;
  if (requirement.grid.empty()) return std::nullopt;
  return core::Estimate{std::numeric_limits<double>::quiet_NaN(), 0, {}};
}

Verdict verdictOf(const core::Estimate& e, const analysis::Limit& limit) {
  if (!std::isfinite(e.value)) return Verdict::undecided;  // an interrupted run
  const double low = e.value - e.halfWidth(), high = e.value + e.halfWidth();
  if ((limit.minimum && high < *limit.minimum) || (limit.maximum && low > *limit.maximum)) return Verdict::fail;
  if ((limit.minimum && low < *limit.minimum) || (limit.maximum && high > *limit.maximum)) return Verdict::undecided;
  return Verdict::pass;
}

std::string limitText(const std::string& what, const analysis::Limit& limit, const core::Estimate& e) {
  std::string text = fmt::format("{} {}", what, limit.key);
  if (limit.minimum) text += fmt::format(" >= {:g}", *limit.minimum);
  if (limit.maximum) text += fmt::format(" <= {:g}", *limit.maximum);
  if (!std::isfinite(e.value)) return text + " (not known)";
  return text + fmt::format(" (is {:.4g} ± {:.2g})", e.value, e.halfWidth());
}

}  // namespace

std::vector<project::RequirementResult> judge(const project::Project& project, const project::Results& results) {
  std::vector<project::RequirementResult> verdicts;
  for (const analysis::Requirement& requirement : project.requirements) {
    const std::string& what = requirement.grid.empty() ? requirement.observer : requirement.grid;
    for (const analysis::Limit& limit : requirement.limits)
      if (const auto e = limit.key == "ra" ? std::optional(colourRenderingOf(project))
                                           : quantityOf(results, requirement, limit.key))
        verdicts.push_back({limitText(what, limit, *e), verdictOf(*e, limit), what, limit.key, limit.minimum,
                            limit.maximum, *e, requirement.clause});
  }
  return verdicts;
}

bool anyFailed(const project::Results& results) {
  return std::any_of(results.requirements.begin(), results.requirements.end(),
                     [](const auto& r) { return r.verdict == Verdict::fail; });
}

}  // namespace goniolux::pipeline
