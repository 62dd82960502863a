// The path kernel's share of directions towards bright spots. Part of path_kernel.cpp.
#pragma once

#include "solver/directions.h"
#include "solver/emission.h"
#include "solver/path_kernel.h"

namespace goniolux::solver {

namespace {

constexpr std::size_t raysForSpots = 4096, raysPerEmitter = 64, mostRaysForSpots = 65536;
constexpr std::uint64_t spotKey = 0x5907;
constexpr int mostSteps = 256;  // at finishes that are not diffuse

}  // namespace

template <int W>
void PathSolver<W>::findSpots(double area) {
  double flux = 0;
  for (const scene::LightSource& source : world_.emitters) flux += source.emitter->flux();
  if (!(flux > 0)) return;
  const std::size_t wanted = std::clamp(raysPerEmitter * world_.emitters.size(), raysForSpots, mostRaysForSpots);
  std::vector<LandedLight> landed;
  std::uint64_t rays = 0;
  std::uint32_t index = 0;
  for (const scene::LightSource& source : world_.emitters) {
    const double share = source.emitter->flux() / flux;
    const auto count = static_cast<std::uint32_t>(std::ceil(share * static_cast<double>(wanted)));
    const Emission emission(source, 1e3 * world_.radius);
    for (std::uint32_t i = 0; i < count; ++i) {
      core::Sampler random(core::combine(spotKey, index), i);
      const core::Vec2 forDirection = random.next2();
      const EmittedRay ray = emission.ray(forDirection, random.next2());
      if (!(ray.flux > 0)) continue;
      const Arrival arrival = arrive(tracer_.leave(ray.origin, ray.direction), ray.direction, random, rays);
      if (!arrival.found) continue;
      const double reflected = ray.flux / count * static_cast<double>(arrival.filter.largest()) *
                               bsdfOf(arrival.surface).largestReflectance();
      if (reflected > 0) landed.push_back({arrival.at.point, arrival.at.normal, arrival.surface, reflected});
    }
    ++index;
  }
  rays_.fetch_add(rays, std::memory_order_relaxed);
  spots_ = BrightSpots(std::move(landed), area);
}

template <int W>
bool PathSolver<W>::guide(Path& path, const Vertex& at, core::Sampler& random) const {
  if (spots_.empty()) return true;
  Guidance& guidance = path.guidance;
  guidance.choice = spots_.from(at.start, at.normal);
  guidance.target = scene::none;
  guidance.pending = guidance.choice.total > 0;
  if (!guidance.pending) return true;
  const double u = random.next();
  if (u >= spots_.share()) return true;
  return spots_.direction(guidance.choice, u / spots_.share(), random.next2(), path.direction, guidance.target);
}

template <int W>
bool PathSolver<W>::weighGuidance(Path& path, const tracer::Hit& hit) const {
  path.onSpot = false;
  Guidance& guidance = path.guidance;
  if (!guidance.pending) return true;
  guidance.pending = false;
  if (guidance.target != scene::none && guidance.target != hit.surface) return false;
  const double byCosine = glm::dot(path.direction, guidance.choice.normal) / core::pi;
  const double bySpots = spots_.density(guidance.choice, path.direction, hit.surface);
  const double factor = byCosine / ((1 - spots_.share()) * byCosine + spots_.share() * bySpots);
  path.throughput *= static_cast<float>(factor);
  path.white *= factor;
  path.onSpot = bySpots > 0;
  return true;
}

}  // namespace goniolux::solver
