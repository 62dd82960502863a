#include "planner/light_paths.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/queries.h"
#include "reflection/models.h"
#include "reflection/shading.h"

namespace goniolux::planner {
namespace {

using spectrum::SpectralDistribution;

// Closed rooms of nearly white finishes: more reflections than this mean allows end in openings and gaps.
constexpr double largestMean = 0.98;
// Pairs of finishes looked at; scenes with more take an even choice of them.
constexpr std::size_t mostPairs = 400;

/// Area in m2 of each material of the world.
std::vector<double> areasOf(const scene::World& world) {
  std::vector<double> areas(world.materials.size(), 0.0);
  const auto add = [&](std::uint32_t surface, double area) {
    const std::uint32_t material = world.surfaces[surface].material;
    if (material != scene::none && std::isfinite(area)) areas[material] += area;
  };
  for (std::size_t i = 0; i < world.triangles.size(); ++i) {
    const auto& [a, b, c] = world.triangles[i];
    add(world.triangleSurfaces[i],
        0.5 * glm::length(glm::cross(world.vertices[b] - world.vertices[a], world.vertices[c] - world.vertices[a])));
  }
  for (const scene::PlacedPatch& placed : world.patches) {
    geometry::Shape alone;
    alone.partNames = {"patch"};
    alone.patches = {placed.patch};
    alone.patches.front().part = 0;
    add(placed.surface, geometry::area(alone));
  }
  return areas;
}

/// The spectra that a finish's parameters multiply light by: shares between 0 and 1, unlike indices and attenuations.
std::vector<SpectralDistribution> factorsOf(const material::Material& material) {
  std::vector<SpectralDistribution> factors;
  const reflection::ReflectionModel* model = reflection::findReflectionModel(material.model);
  const reflection::ShadingModel* shading = reflection::findShadingModel(material.model);
  if (model == nullptr && shading == nullptr) return factors;
  for (const core::Parameter& parameter : model != nullptr ? model->parameters : shading->parameters) {
    const auto found = material.spectra.find(parameter.key);
    if (parameter.kind == core::ParameterKind::spectrum && parameter.maximum <= 1 && found != material.spectra.end())
      factors.push_back(found->second);
  }
  // Coloured glass: what a piece of it lets through that takes half of the light at its clearest wavelength and more
  // elsewhere.
  const auto attenuation = material.spectra.find("attenuation_per_m");
  if (attenuation != material.spectra.end() && !attenuation->second.isFlat()) {
    const auto [least, most] = attenuation->second.range();
    const double thickness = std::log(2.0) / std::max(least, 0.1 * most);
    std::vector<SpectralDistribution::Sample> samples;
    for (int nm = 360; nm <= 830; nm += 5)
      samples.push_back({static_cast<double>(nm), std::exp(-thickness * attenuation->second.continuum(nm))});
    factors.push_back(SpectralDistribution::sampled(std::move(samples), SpectralDistribution::Outside::hold));
  }
  return factors;
}

}  // namespace

std::vector<Finish> finishesOf(const scene::World& world) {
  const std::vector<double> areas = areasOf(world);
  std::vector<Finish> finishes;
  double total = 0;
  for (std::size_t i = 0; i < world.materials.size(); ++i) {
    for (const SpectralDistribution& factor : factorsOf(world.materials[i])) {
      const auto same = std::find_if(finishes.begin(), finishes.end(),
                                     [&](const Finish& known) { return known.reflectance == factor; });
      if (same == finishes.end())
        finishes.push_back({factor, areas[i]});
      else
        same->share += areas[i];
      total += areas[i];
    }
  }
  for (Finish& finish : finishes)
    finish.share = total > 0 ? finish.share / total : 1.0 / static_cast<double>(finishes.size());
  std::stable_sort(finishes.begin(), finishes.end(),
                   [](const Finish& a, const Finish& b) { return a.share > b.share; });
  return finishes;
}

LightPaths::LightPaths(const std::vector<Finish>& finishes) {
  const std::size_t n = finishes.size();
  for (const Finish& finish : finishes) shares_.push_back(finish.share);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i; j < n; ++j) pairs_.emplace_back(i, j);
  if (pairs_.size() > mostPairs) {
    std::vector<std::pair<std::size_t, std::size_t>> chosen;
    for (std::size_t k = 0; k < mostPairs; ++k) chosen.push_back(pairs_[k * pairs_.size() / mostPairs]);
    pairs_ = std::move(chosen);
  }
  seen_.assign(3 * n + pairs_.size(), Seen::byGrid);
  seen_.insert(seen_.end(), 3 * n + pairs_.size(), Seen::byEye);
}

std::vector<std::vector<double>> LightPaths::transmittances(
    const std::vector<std::vector<double>>& reflectances) const {
  const std::size_t n = shares_.size(), nodes = n == 0 ? 0 : reflectances.front().size();
  std::vector<double> mean(nodes, 0.0);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = 0; k < nodes; ++k) mean[k] += shares_[i] * reflectances[i][k];

  std::vector<std::vector<double>> paths;
  const auto add = [&](auto transmittance) {
    auto& path = paths.emplace_back(nodes);
    for (std::size_t k = 0; k < nodes; ++k) path[k] = transmittance(k);
  };
  // 1 / (1 - m): light that goes on being reflected.
  const auto series = [](double m) { return 1 / (1 - std::min(m, largestMean)); };
  const auto near = [&](const std::vector<double>& rho, std::size_t k) { return (rho[k] + mean[k]) / 2; };

  // Arriving at a grid's point near a finish …
  for (const auto& rho : reflectances) add([&](std::size_t k) { return near(rho, k) * series(mean[k]); });
  // … which is all that the point sees, …
  for (const auto& rho : reflectances) add([&](std::size_t k) { return rho[k] * series(mean[k]); });
  // … or which makes half of the room, …
  for (const auto& rho : reflectances) add([&](std::size_t k) { return near(rho, k) * series(near(rho, k)); });
  // … or after one reflection more near another finish.
  for (const auto& [i, j] : pairs_) {
    const auto &a = reflectances[i], &b = reflectances[j];
    add([&](std::size_t k) { return near(a, k) * near(b, k) * series(mean[k]); });
  }

  // Seen by an eye: a surface under direct light, indirect light, both, or a neighbour's.
  for (const auto& rho : reflectances) add([&](std::size_t k) { return rho[k]; });
  for (const auto& rho : reflectances) add([&](std::size_t k) { return rho[k] * mean[k] * series(mean[k]); });
  for (const auto& rho : reflectances) add([&](std::size_t k) { return rho[k] * series(mean[k]); });
  for (const auto& [i, j] : pairs_) {
    const auto &a = reflectances[i], &b = reflectances[j];
    add([&](std::size_t k) { return a[k] * b[k]; });
  }
  return paths;
}

}  // namespace goniolux::planner
