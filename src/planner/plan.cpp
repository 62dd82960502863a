#include "planner/plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "planner/spectral_error.h"
#include "solver/solver.h"

namespace goniolux::planner {
namespace {

using spectrum::SpectralDistribution;

// Share of the asked accuracy that the choice of wavelengths may use up.
constexpr double spectralShare = 0.1;
constexpr std::array<int, 7> ladder = {4, 8, 12, 16, 31, 81, 471};

std::vector<SpectralDistribution> finishesOf(const scene::World& world) {
  std::vector<SpectralDistribution> finishes;
  for (const auto& material : world.materials)
    for (const auto& [key, curve] : material.spectra)
      if (std::find(finishes.begin(), finishes.end(), curve) == finishes.end()) finishes.push_back(curve);
  return finishes;
}

void chooseSolver(const project::Project& project, Plan& plan) {
  if (project.settings.solver == "auto") {
    plan.solver = "path";
    plan.reasons.emplace_back("solver path: closed-form direct light and unbiased interreflection");
    return;
  }
  if (solver::findSolverType(project.settings.solver) == nullptr) {
    std::vector<std::string> names = {"auto"};
    for (const auto& type : solver::solverTypes()) names.push_back(type.name);
    throw core::InputError({project.file, 0, 0}, "unknown-solver",
                           fmt::format("there is no solver \"{}\" in this version; choose one of: {}",
                                       project.settings.solver, fmt::join(names, ", ")));
  }
  plan.solver = project.settings.solver;
  plan.reasons.push_back("solver " + plan.solver + ": as the project asks");
}

void chooseWavelengths(const project::Project& project, const scene::World& world, bool forColour, Plan& plan) {
  const auto& settings = project.settings;
  const std::vector<SpectralDistribution> finishes = finishesOf(world);
  const bool grey = std::all_of(finishes.begin(), finishes.end(), [](const auto& f) { return f.isFlat(); });
  const auto measure = [&] {
    const SpectralError error = spectralError(plan.quadrature, world.sourceSpectra, finishes);
    plan.spectralBound = error.luminance;
    plan.colourBound = error.colour;
  };
  if (settings.spectralScheme == "auto" && grey) {
    plan.quadrature = spectrum::flatQuadrature(world.sourceSpectra);
    plan.reasons.emplace_back("1 spectral sample: every finish reflects all wavelengths alike");
    return;
  }
  if (settings.spectralScheme != "auto") {
    if (settings.spectralScheme != "uniform")
      throw core::InputError({project.file, 0, 0}, "unknown-spectral-scheme",
                             fmt::format("not supported yet: spectral scheme \"{}\"; use \"auto\" or \"uniform\"",
                                         settings.spectralScheme));
    plan.quadrature =
        spectrum::uniformQuadrature(settings.spectralSamples > 0 ? settings.spectralSamples : 9, world.sourceSpectra);
    measure();
    plan.reasons.push_back(fmt::format("{} spectral samples: as the project asks", plan.quadrature.wavelengths.size()));
    return;
  }
  const double allowedY =
      spectralShare * (forColour ? std::min(settings.accuracy.grid, settings.accuracy.image) : settings.accuracy.grid);
  for (const int samples : ladder) {
    plan.quadrature = spectrum::uniformQuadrature(samples, world.sourceSpectra);
    measure();
    if (plan.spectralBound <= allowedY && (!forColour || plan.colourBound <= settings.accuracy.colourDe)) break;
  }
  plan.reasons.push_back(
      fmt::format("{} spectral samples: after one or two reflections on this scene's finishes Y is within {:.2g} % and "
                  "CIEDE2000 within "
                  "{:.2g} of 1 nm",
                  plan.quadrature.wavelengths.size(), 100 * plan.spectralBound, plan.colourBound));
}

}  // namespace

Plan makePlan(const project::Project& project, const scene::World& world, bool forColour) {
  Plan plan;
  chooseSolver(project, plan);
  chooseWavelengths(project, world, forColour, plan);
  const std::size_t nodes = plan.quadrature.wavelengths.size();
  if (nodes < 471 && plan.spectralBound > 0)
    plan.leftOut.push_back(
        {fmt::format("wavelengths between {} spectral samples", nodes), 100 * plan.spectralBound, "% of E"});
  plan.leftOut.push_back({"fluorescence, polarisation, and air (no absorption or scattering)", 0, "not modelled"});
  return plan;
}

core::Value toJson(const Plan& plan, const project::Project& project) {
  core::Value json;
  json.set("solver", plan.solver);
  json.set("spectral_scheme", plan.quadrature.scheme);
  json.set("spectral_samples", static_cast<double>(plan.quadrature.wavelengths.size()));
  const auto& accuracy = project.settings.accuracy;
  core::Value asked;
  asked.set("grid", accuracy.grid);
  asked.set("u0", accuracy.u0);
  asked.set("image", accuracy.image);
  asked.set("colour_de", accuracy.colourDe);
  asked.set("confidence", accuracy.confidence);
  json.set("accuracy", std::move(asked));
  return json;
}

}  // namespace goniolux::planner
