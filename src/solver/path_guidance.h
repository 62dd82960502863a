// The path kernel's connections to bright spots. Part of path_kernel.cpp.
#pragma once

#include "solver/directions.h"
#include "solver/emission.h"
#include "solver/path_kernel.h"

namespace goniolux::solver {

namespace {

constexpr std::size_t raysForSpots = 4096, raysPerEmitter = 64, mostRaysForSpots = 65536;
constexpr std::size_t raysForFineSpots = 32768;
constexpr std::uint64_t spotKey = 0x5907;
constexpr int mostSteps = 256;  // at finishes that are not diffuse

}  // namespace

template <int W>
std::vector<LandedLight> PathSolver<W>::landLight(std::size_t wanted) const {
  double flux = 0;
  for (const scene::LightSource& source : world_.emitters) flux += source.emitter->flux();
  std::vector<LandedLight> landed;
  if (!(flux > 0)) return landed;
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
  return landed;
}

template <int W>
void PathSolver<W>::findSpots(double area) {
  const std::size_t wanted = std::clamp(raysPerEmitter * world_.emitters.size(), raysForSpots, mostRaysForSpots);
  spots_ = BrightSpots(landLight(wanted), area);
  if (spots_.empty()) return;
  BrightSpots outlined(landLight(std::max(wanted, raysForFineSpots)), area, BrightSpots::fine);
  if (!outlined.empty()) spots_ = std::move(outlined);
}

template <int W>
void PathSolver<W>::addSpot(Response& sum, Path& path, const Vertex& at, Ending ending, core::Sampler& random,
                            std::uint64_t& rays) const {
  path.guidance.pending = false;
  if (spots_.empty()) return;
  Guidance& guidance = path.guidance;
  guidance.choice = spots_.from(at.start, at.normal);
  guidance.pending = guidance.choice.total > 0;
  // Direct light at the next vertex is no part of the remainder, by whichever way it is found.
  if (!guidance.pending || ending == Ending::remainder) return;
  const double u = random.next();
  if (u >= spots_.share()) return;
  Path connection = path;
  connection.direct = nullptr;
  std::uint32_t target = scene::none;
  if (!spots_.direction(guidance.choice, u / spots_.share(), random.next2(), connection.direction, target)) return;
  Meeting met;
  if (!meet(connection, met, rays) || met.hit.surface != target) return;
  const Vertex there = vertexAt(met.hit, connection.direction);
  const core::Frame frame = frameAbout(there.normal);
  connection.throughput *= static_cast<float>(directShare(connection, met.hit));
  addDirect(sum, there, met, frame.toLocal(-connection.direction), {frame}, connection, false, random, rays);
}

template <int W>
double PathSolver<W>::directShare(Path& path, const tracer::Hit& hit) const {
  path.onSpot = false;
  if (!path.guidance.pending) return 1;
  path.guidance.pending = false;
  const double bySpots = spots_.density(path.guidance.choice, path.direction, hit.surface);
  if (!(bySpots > 0)) return 1;
  path.onSpot = true;
  const double byCosine = glm::dot(path.direction, path.guidance.choice.normal) / core::pi;
  return byCosine / (byCosine + spots_.share() * bySpots);
}

}  // namespace goniolux::solver
