// The path kernel's steps from surface to surface: media on the way, emitted light that is met, how a path goes on.
// Part of path_kernel.cpp.
#pragma once

#include "solver/path_kernel.h"

namespace goniolux::solver {

template <int W>
bool PathSolver<W>::meet(Path& path, Meeting& met, std::uint64_t& rays) const {
  for (int passed = 0; passed < mostReflections; ++passed) {
    ++rays;
    if (!tracer_.intersect(path.origin, path.direction, met.hit)) return false;
    met.bsdf = &bsdfOf(met.hit.surface);
    if (hasTextures_) {
      const bool textured = world_.materials[world_.surfaces[met.hit.surface].material].texture.has_value();
      if (textured) met.mixture = scene::mixtureAt(world_, met.hit);
      met.interface.mixture = textured ? &met.mixture : nullptr;
    }
    if (!hasMedia_) return true;
    met.interface = {nullptr, nullptr, path.hero, met.interface.mixture};
    const std::uint32_t body = world_.surfaces[met.hit.surface].object;
    const reflection::Medium* medium = met.bsdf->medium();
    const bool fromInside = glm::dot(met.hit.normal, path.direction) > 0;
    if (medium != nullptr && fromInside) path.media.enter(body, medium);  // new only when the path began in it
    const reflection::Medium* here = path.media.here();
    if (here != nullptr && here->absorbs) {
      path.white = 0;
      for (std::size_t k = 0; k < here->attenuation.size(); ++k)
        path.throughput.v[k] *= std::exp(-here->attenuation[k] * static_cast<float>(met.hit.distance));
    }
    if (medium == nullptr) return true;
    Media past = path.media;
    fromInside ? past.leave(body) : past.enter(body, medium);
    const reflection::Medium* beyond = past.here();
    if (here != beyond) {
      if (here != nullptr) met.interface.indexHere = here->index.data();
      if (beyond != nullptr) met.interface.indexBeyond = beyond->index.data();
      return true;
    }
    path.media = past;
    path.origin = tracer_.leave(met.hit.position, fromInside ? met.hit.normal : -met.hit.normal);
  }
  return false;
}

template <int W>
void PathSolver<W>::addEmitted(Response& sum, const Path& path, const tracer::Hit& hit) const {
  double share = 1;
  if (caustics_ && path.isOpen && path.isBent) {
    const std::uint32_t emitter = emitterAt(hit);
    if (emitter != scene::none && caustics_->serves(emitter)) return;
  }
  if (path.connected && path.mirrors <= lights_->imageDepth()) {
    const std::uint32_t emitter = emitterAt(hit);
    if (emitter != scene::none) {
      if (path.density == 0) return;
      const double solidAngle = world_.emitters[emitter].emitter->roughSolidAngle(path.seenFrom);
      share = path.density * solidAngle / (path.density * solidAngle + path.share);
    }
  }
  std::uint32_t spectrum = 0;
  if (const double luminance = emittedLuminance(hit, -path.direction, spectrum); luminance > 0)
    add(sum, spectrum, path.throughput, luminance * share);
}

template <int W>
void PathSolver<W>::chooseHero(Path& path, core::Sampler& random) const {
  if (!disperses_) return;
  const double u = random.next();
  while (path.hero + 1 < heroCumulative_.size() && heroCumulative_[path.hero] <= u) ++path.hero;
}

// From here on the path is one of the hero's wavelength only, in place of all that would go other ways.
template <int W>
void PathSolver<W>::collapse(Path& path) const {
  if (path.dispersed) return;
  for (std::size_t k = 0; k < static_cast<std::size_t>(W); ++k)
    if (k != path.hero) path.throughput.v[k] = 0;
  path.throughput.v[path.hero] /= static_cast<float>(heroProbability_[path.hero]);
  path.dispersed = true;
  path.white = 0;
}

template <int W>
bool PathSolver<W>::goOn(Path& path, const Meeting& met, const Vertex& at, const core::Frame& frame,
                         const reflection::BsdfSample& next, const Spectral& weight, bool roulette,
                         core::Sampler& random) const {
  if (next.dispersed) collapse(path);
  float survive = 1;
  if (roulette) {
    // On this reflection's largest weight: throughput stays near 1, long paths end as light is absorbed.
    const float kept = path.dispersed ? weight.v[path.hero] : weight.largest();
    survive = std::min(1.0f, kept / static_cast<float>(next.scale));
    if (survive <= 0 || random.next() >= static_cast<double>(survive)) return false;
  }
  path.throughput *= weight;
  path.throughput *= 1 / survive;
  path.white = 0;
  path.direction = frame.toWorld(next.direction);
  const bool through = next.direction.z < 0;
  path.origin = at.start;
  if (through) {
    path.origin = tracer_.leave(at.point, -at.normal);
    const std::uint32_t body = world_.surfaces[met.hit.surface].object;
    if (const reflection::Medium* medium = met.bsdf->medium())
      glm::dot(met.hit.normal, at.normal) > 0 ? path.media.enter(body, medium) : path.media.leave(body);
  }
  if (met.bsdf->lobes().spread) {  // by far the most frequent
    path.connected = path.isOpen = !next.specular;
    path.isBent = false;
    path.mirrors = 0;
    path.seenFrom = at.point;
    path.density = met.bsdf->lobes().glossy ? next.density : 0;
  } else if (!next.straight) {
    const std::uint32_t plane = lights_->planeOf(met.hit.primitive);
    path.connected = path.connected && !through && plane != scene::none;
    path.isBent = path.isBent || through || plane == scene::none;
    ++path.mirrors;
    if (path.connected) path.seenFrom = lights_->planes()[plane].reflectPoint(path.seenFrom);
  }
  return true;
}

template <int W>
typename PathSolver<W>::Arrival PathSolver<W>::arrive(const Vec3& origin, const Vec3& direction, core::Sampler& random,
                                                      std::uint64_t& rays) const {
  Arrival arrival;
  Path path{origin, direction, Spectral::filled(1)};
  chooseHero(path, random);
  Meeting met;
  for (int i = 0; i < mostSteps && meet(path, met, rays); ++i) {
    arrival.at = vertexAt(met.hit, path.direction);
    if (met.bsdf->isLambertian()) {
      arrival.found = true;
      arrival.surface = met.hit.surface;
      arrival.filtered = i > 0 || hasMedia_;
      arrival.filter = path.throughput;
      arrival.textured = met.interface.mixture != nullptr;
      if (arrival.textured) met.bsdf->diffuseReflectanceAt(met.interface, arrival.reflectance.v.data());
      return arrival;
    }
    const core::Frame frame = frameAbout(arrival.at.normal);
    reflection::BsdfSample next;
    Spectral weight = Spectral::filled(0);
    if (!met.bsdf->sample(frame.toLocal(-path.direction), random.next2(), met.interface, next, weight.v.data()) ||
        !goOn(path, met, arrival.at, frame, next, weight, true, random))
      return arrival;
  }
  return arrival;
}

template <int W>
double PathSolver<W>::emittedLuminance(const tracer::Hit& hit, const Vec3& towards, std::uint32_t& spectrum) const {
  const scene::Surface& surface = world_.surfaces[hit.surface];
  if (surface.luminance > 0) {
    spectrum = surface.spectrum;
    return surface.luminance;
  }
  if (surface.emitter == scene::none) return 0;
  const scene::LightSource& source = world_.emitters[surface.emitter];
  spectrum = source.spectrum;
  // A flat opening is seen from both sides; volumes from outside only.
  const Vec3 facing = glm::dot(hit.normal, towards) >= 0 ? hit.normal : -hit.normal;
  return source.emitter->luminance(facing, towards);
}

template <int W>
std::uint32_t PathSolver<W>::emitterAt(const tracer::Hit& hit) const {
  const scene::Surface& surface = world_.surfaces[hit.surface];
  if (surface.emitter != scene::none) return surface.emitter;
  return hit.primitive < emitterOfTriangle_.size() ? emitterOfTriangle_[hit.primitive] : scene::none;
}

template <int W>
typename PathSolver<W>::Shading PathSolver<W>::shadingSeen(const Meeting& met, const Vertex& at,
                                                           const Vec3& towardsEye) const {
  if (!world_.surfaces[met.hit.surface].isDetailed || met.bsdf->isSpecular()) return {frameAbout(at.normal)};
  const Vec3 normal = scene::shownNormal(world_, met.hit, at.normal, towardsEye);
  const double cosine = glm::dot(normal, at.normal);
  if (cosine > 1 - 1e-12) return {frameAbout(at.normal)};
  // Of even light, the part between the two horizons is (1 + cosine)/2 of what a matt surface would get.
  const double gain = met.bsdf->isLambertian() && cosine > 0 ? 2 / (1 + cosine) : 1;
  return {frameAbout(normal), true, gain};
}

template <int W>
typename PathSolver<W>::Vertex PathSolver<W>::vertexAt(const tracer::Hit& hit, const Vec3& direction) const {
  const Vec3 normal = glm::dot(hit.normal, direction) < 0 ? hit.normal : -hit.normal;
  return {hit.position, tracer_.leave(hit.position, normal), normal};
}

}  // namespace goniolux::solver
