#include "planner/light_paths.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/queries.h"
#include "spectrum/hats.h"

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

// Lengths in a medium that attenuation is looked at, as shares of the scene's radius; a stated thickness goes first.
constexpr double lengthsInMedia[] = {0.05, 0.5};

/// exp(-attenuation x length).
SpectralDistribution transmittanceThrough(const SpectralDistribution& attenuation, double metres) {
  if (attenuation.isFlat()) return SpectralDistribution::flat(std::exp(-attenuation.continuum(550) * metres));
  std::vector<SpectralDistribution::Sample> samples;
  for (double w = spectrum::visibleFrom; w <= spectrum::visibleTo; w += 1)
    samples.push_back({w, std::exp(-attenuation.continuum(w) * metres)});
  return SpectralDistribution::sampled(std::move(samples), SpectralDistribution::Outside::hold);
}

/// Fresnel's reflectance of a metal at normal incidence.
SpectralDistribution metalReflectance(const SpectralDistribution& n, const SpectralDistribution& k) {
  const auto at = [&](double w) {
    const double a = n.continuum(w), b = k.continuum(w);
    return ((a - 1) * (a - 1) + b * b) / ((a + 1) * (a + 1) + b * b);
  };
  if (n.isFlat() && k.isFlat()) return SpectralDistribution::flat(at(550));
  std::vector<SpectralDistribution::Sample> samples;
  for (double w = spectrum::visibleFrom; w <= spectrum::visibleTo; w += 1) samples.push_back({w, at(w)});
  return SpectralDistribution::sampled(std::move(samples), SpectralDistribution::Outside::hold);
}

/// The spectra that a finish multiplies light by, from its parameters.
std::vector<SpectralDistribution> factorsOf(const material::Material& material, double radius) {
  std::vector<SpectralDistribution> factors;
  for (const auto& [key, curve] : material.spectra) {
    if (key == "k") continue;
    if (key == "ior") {
      const auto k = material.spectra.find("k");
      if (k != material.spectra.end()) factors.push_back(metalReflectance(curve, k->second));
    } else if (key == "attenuation_per_m") {
      const auto thickness = material.numbers.find("thickness_m");
      if (thickness != material.numbers.end()) {
        factors.push_back(transmittanceThrough(curve, thickness->second));
      } else {
        for (const double share : lengthsInMedia) factors.push_back(transmittanceThrough(curve, share * radius));
      }
    } else if (curve.range().first >= 0 && curve.range().second <= 1) {
      factors.push_back(curve);
    }
  }
  return factors;
}

}  // namespace

std::vector<Finish> finishesOf(const scene::World& world) {
  const std::vector<double> areas = areasOf(world);
  std::vector<Finish> finishes;
  double total = 0;
  for (std::size_t i = 0; i < world.materials.size(); ++i) {
    std::vector<SpectralDistribution> factors = factorsOf(world.materials[i], world.radius);
    // Of a textured finish also what it is made of: light meets each of them somewhere.
    for (const material::Material& component : world.materials[i].components)
      for (SpectralDistribution& factor : factorsOf(component, world.radius)) factors.push_back(std::move(factor));
    for (const SpectralDistribution& factor : factors) {
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
