#include "pipeline/kept_wavelengths.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "analysis/quantity.h"
#include "core/random.h"
#include "pipeline/scene_groups.h"
#include "spectrum/cie_data.h"

namespace goniolux::pipeline {
namespace {

using project::GridResult;
using project::Results;
using spectrum::SpectralDistribution;

// Share of the asked accuracy that the choice of wavelengths may use up, as in the planner.
constexpr double spectralShare = 0.1;
// One of every kind of lamp that there is spectral data of (CIE 15, CIE 251).
constexpr const char* lampsOfEveryKind[] = {"CIE A", "CIE D65", "CIE FL2", "CIE FL11", "CIE LED-B3"};

void addSpectralPart(GridResult& grid, double bound) {
  std::vector<double>& part = grid.parts["spectral"];
  part.resize(grid.values.size());
  for (std::size_t i = 0; i < grid.values.size(); ++i) {
    part[i] = bound * std::abs(grid.values[i]);
    grid.halfWidths[i] += part[i];
  }
  for (core::Estimate* each : {&grid.mean, &grid.min, &grid.max})
    each->systematic["spectral"] = bound * std::abs(each->value);
}

}  // namespace

KeptWavelengths::KeptWavelengths(const project::Project& project, const scene::World& world)
    : finishes_(planner::finishesOf(world)) {
  std::vector<SpectralDistribution> lamps;
  for (const char* name : lampsOfEveryKind) lamps.push_back(spectrum::illuminant(name).value());
  allowance_.illuminance = spectralShare * project.settings.accuracy.grid;
  allowance_.melanopic = std::any_of(project.grids.begin(), project.grids.end(), [](const analysis::Grid& grid) {
    return analysis::findQuantity(grid.quantity)->channel != 1;
  });
  wavelengths_ = planner::chooseWavelengths(finishes_, lamps, allowance_).quadrature.wavelengths;
}

planner::SpectralChoice KeptWavelengths::with(const SpectralDistribution& lamp) const {
  if (wavelengths_.size() == 1) return {spectrum::flatQuadrature({lamp}), {}};
  return planner::atWavelengths(wavelengths_, finishes_, {lamp}, allowance_);
}

Results KeptWavelengths::of(const SpectralDistribution& lamp, const std::vector<Results>& kept,
                            const project::Project& project) const {
  const planner::SpectralChoice choice = with(lamp);
  const std::vector<spectrum::Response>& weights = choice.quadrature.weights.front();
  const planner::SpectralError& error = choice.error;
  const auto sumOf = [&](std::size_t channel, double factor) {
    std::map<std::string, Results> parts;
    std::map<std::string, double> levels;
    for (std::size_t k = 0; k < kept.size(); ++k) {
      const std::string name = fmt::format("{:03}", k);
      parts[name] = kept[k];
      levels[name] = factor * weights[k][channel];
    }
    return superposed(parts, levels);
  };
  Results results = sumOf(1, 1);
  std::optional<Results> melanopic;
  for (std::size_t i = 0; i < results.grids.size(); ++i) {
    const analysis::Quantity& quantity = *analysis::findQuantity(project.grids[i].quantity);
    const bool isMelanopic = quantity.channel != 1;
    if (isMelanopic) {
      if (!melanopic) melanopic = sumOf(quantity.channel, quantity.factor);
      results.grids[i] = melanopic->grids[i];
      results.grids[i].quantity = quantity.name;
      results.grids[i].unit = quantity.unit;
    }
    addSpectralPart(results.grids[i], isMelanopic ? error.melanopic : error.illuminance);
  }
  return results;
}

project::Project atWavelength(const project::Project& project, double wavelength) {
  project::Project one = project;
  for (material::Material& each : one.environment.materials)
    for (auto& [key, curve] : each.spectra) curve = SpectralDistribution::flat(curve.continuum(wavelength));
  one.settings.spectralScheme = "auto";
  one.settings.spectralSamples = 0;
  for (analysis::Grid& grid : one.grids)
    if (analysis::findQuantity(grid.quantity)->channel != 1) grid.quantity = "illuminance";
  // Each wavelength draws random numbers of its own: their errors are independent, as superposed() takes them to be.
  one.settings.seed =
      core::combine(project.settings.seed, static_cast<std::uint64_t>(std::llround(1000 * wavelength))) >> 11;
  return one;
}

SpectralDistribution lampSpectrumOf(const project::Project& project, const std::string& group) {
  const SpectralDistribution* found = nullptr;
  const auto take = [&](const SpectralDistribution& spectrum, const core::SourcePosition& position) {
    if (found == nullptr) found = &spectrum;
    if (*found == spectrum) return;
    throw core::InputError(
        position, "spectra-within-group",
        fmt::format("the lamps of \"{}\" have different spectra, so that none can be exchanged for all of them; put "
                    "them into groups of their own, or keep results for dimming only (--keep levels)",
                    group));
  };
  if (group == emittingSurfaces) {
    for (const material::Material& each : project.environment.materials)
      if (each.emission && each.emission->exitance_lm_m2 > 0) take(each.emission->spectrum, each.position);
  } else {
    for (const scene::Luminaire& luminaire : project.environment.luminaires)
      if (luminaire.group == group) take(project.environment.sourceSpectra[luminaire.spectrum], luminaire.position);
  }
  return *found;
}

}  // namespace goniolux::pipeline
