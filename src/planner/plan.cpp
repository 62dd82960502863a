#include "planner/plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "analysis/grid_estimate.h"
#include "planner/spectral_choice.h"
#include "reflection/shading.h"
#include "solver/solver.h"

namespace goniolux::planner {
namespace {

// Share of the asked accuracy that the choice of wavelengths may use up.
constexpr double spectralShare = 0.1;

// The paper's models are no BSDFs: only intersection trees can be shaded by them.
bool needsTrees(const project::Project& project) {
  return project.settings.reflectionModel != "material" ||
         std::any_of(project.environment.materials.begin(), project.environment.materials.end(),
                     [](const auto& m) { return reflection::findShadingModel(m.model) != nullptr; });
}

void chooseSolver(const project::Project& project, bool forColour, Plan& plan) {
  const auto& settings = project.settings;
  plan.tree = {settings.treeMaxDepth,    settings.treeCutoff, settings.treeAdaptive,
               settings.reflectionModel, settings.asPrinted,  settings.ambient};
  if (needsTrees(project)) {
    if (settings.solver != "auto" && settings.solver != "tree")
      throw core::InputError({project.file, 0, 0}, "not-for-this-solver",
                             fmt::format("phong, whitted and hall are local shading models, no BSDFs: the solver "
                                         "\"{}\" cannot use them; set \"solver\" to \"tree\" or \"auto\"",
                                         settings.solver));
    plan.solver = "tree";
    plan.reasons.emplace_back("solver tree: the project uses phong, whitted or hall, which do not conserve energy");
    return;
  }
  if (project.settings.solver == "auto") {
    // A light solution pays when many points share it, and pictures are of many points.
    const bool few = std::all_of(project.grids.begin(), project.grids.end(),
                                 [](const analysis::Grid& grid) { return grid.points.size() < analysis::fewPoints; });
    if (few && !forColour) {
      plan.solver = "path";
      plan.reasons.push_back(
          fmt::format("solver path: no grid has {} points, too few for a light solution to pay", analysis::fewPoints));
      return;
    }
    plan.solver = "gather";
    plan.reasons.emplace_back(
        "solver gather: closed-form direct light, and paths that end in a light solution whose error is measured");
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

// Nodes on which dispersed light makes a spectrum and no handful of ghosts.
constexpr int nodesForDispersion = 16;

// A refractive index that varies, of anything but a metal.
bool disperses(const scene::World& world) {
  return std::any_of(world.materials.begin(), world.materials.end(), [](const material::Material& material) {
    const auto index = material.spectra.find("ior");
    return index != material.spectra.end() && !index->second.isFlat() && !material.spectra.contains("k");
  });
}

SpectralAllowance allowanceFor(const project::Project& project, const scene::World& world, bool forColour) {
  const auto& settings = project.settings;
  SpectralAllowance allowance;
  if (disperses(world)) allowance.leastCount = nodesForDispersion;
  allowance.illuminance = spectralShare * settings.accuracy.grid;
  allowance.melanopic = std::any_of(project.grids.begin(), project.grids.end(),
                                    [](const analysis::Grid& grid) { return grid.quantity == "melanopic-edi"; });
  allowance.pictures = forColour;
  allowance.luminance = spectralShare * settings.accuracy.image;
  allowance.colour = settings.accuracy.colourDe;
  return allowance;
}

const spectrum::SpectralScheme& askedScheme(const project::Project& project) {
  const auto& settings = project.settings;
  const spectrum::SpectralScheme* scheme = spectrum::findSpectralScheme(settings.spectralScheme);
  if (scheme == nullptr) {
    std::vector<std::string> names = {"auto"};
    for (const auto& known : spectrum::spectralSchemes()) names.push_back(known.name);
    throw core::InputError({project.file, 0, 0}, "unknown-spectral-scheme",
                           fmt::format("there is no spectral scheme \"{}\"; choose one of: {}", settings.spectralScheme,
                                       fmt::join(names, ", ")));
  }
  if (settings.spectralSamples != 0 &&
      (settings.spectralSamples < scheme->leastCount || settings.spectralSamples > scheme->mostCount))
    throw core::InputError({project.file, 0, 0}, "spectral-samples",
                           fmt::format("the spectral scheme \"{}\" has {} to {} samples, not {}", scheme->name,
                                       scheme->leastCount, scheme->mostCount, settings.spectralSamples));
  return *scheme;
}

void chooseSpectral(const project::Project& project, const scene::World& world, bool forColour, Plan& plan) {
  const auto& settings = project.settings;
  const std::vector<Finish> finishes = finishesOf(world);
  const SpectralAllowance allowance = allowanceFor(project, world, forColour);
  SpectralChoice choice;
  if (settings.spectralScheme == "auto") {
    choice = chooseWavelengths(finishes, world.sourceSpectra, allowance);
  } else {
    const spectrum::SpectralScheme& scheme = askedScheme(project);
    const int samples = settings.spectralSamples > 0 ? settings.spectralSamples : scheme.defaultCount;
    choice = wavelengthsOf(scheme, samples, finishes, world.sourceSpectra, allowance);
    if (scheme.distorts)
      plan.leftOut.push_back({"what \"" + scheme.name + "\" loses: it is a control case, not for photometric numbers",
                              0, "see the bound of its spectral samples"});
  }
  plan.quadrature = std::move(choice.quadrature);
  plan.spectralBound = choice.error.illuminance;
  plan.melanopicBound = choice.error.melanopic;
  plan.colourBound = choice.error.colour;
  const std::size_t nodes = plan.quadrature.wavelengths.size();
  if (settings.spectralScheme == "auto" && nodes == 1 && choice.error.luminance == 0) {
    plan.reasons.emplace_back("1 spectral sample: every finish reflects all wavelengths alike");
    return;
  }
  plan.reasons.push_back(fmt::format(
      "{} spectral samples{}: on this scene's likely light paths illuminance is within {:.2g} %{} of 1 nm", nodes,
      settings.spectralScheme == "auto" ? "" : " as the project asks", 100 * choice.error.illuminance,
      forColour ? fmt::format(", luminance within {:.2g} % and colour within {:.2g} CIEDE2000",
                              100 * choice.error.luminance, choice.error.colour)
                : ""));
}

}  // namespace

Plan makePlan(const project::Project& project, const scene::World& world, bool forColour) {
  Plan plan;
  const auto& asked = project.settings.accuracy;
  plan.accuracy = forColour ? std::min(asked.grid, asked.image) : asked.grid;
  chooseSolver(project, forColour, plan);
  chooseSpectral(project, world, forColour, plan);
  const std::size_t nodes = plan.quadrature.wavelengths.size();
  if (nodes < 471 && plan.spectralBound > 0)
    plan.leftOut.push_back(
        {fmt::format("wavelengths between {} spectral samples", nodes), 100 * plan.spectralBound, "% of E"});
  if (world.chordError > 0)
    plan.leftOut.push_back({"the difference between splines or parametric surfaces and their facets", world.chordError,
                            "m of their place"});
  const auto isTube = [](const scene::Luminaire& each) {
    return each.opening.shape == emitter::Opening::Shape::tube || each.opening.shape == emitter::Opening::Shape::line;
  };
  const auto& luminaires = project.environment.luminaires;
  if (std::any_of(luminaires.begin(), luminaires.end(), isTube))
    plan.leftOut.push_back(
        {"end effects of tubes: the last centimetres before the electrodes are taken to be as bright as the rest", 0,
         "not modelled"});
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
