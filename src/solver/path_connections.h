// The path kernel's connections to the lights: shadow rays, through panes and by plane mirrors. Part of
// path_kernel.cpp.
#pragma once

#include "solver/path_kernel.h"

namespace goniolux::solver {

template <int W>
bool PathSolver<W>::connected(const Light& light, const Vertex& from, const Vec3& unfoldedDirection, double distance,
                              Spectral& filter, std::uint64_t& rays) const {
  Vec3 origin = from.start;
  // Mirrors show the receiver elsewhere and leave the light where it is: the aimed-at point is known exactly. Followed
  // from mirror to mirror instead, the ray ends beside it by the offset of its start, and beyond a panel that it comes
  // to at a grazing angle (a third of the light by a mirror 6 m away was lost so).
  const Vec3 target = lights_->unfold(light, from.point, from.normal).point + unfoldedDirection * distance;
  Vec3 direction = lights_->fold(light, unfoldedDirection);
  for (const std::uint32_t plane : light.mirrors) {
    tracer::Hit hit;
    do {
      ++rays;
      if (!tracer_.intersect(origin, direction, hit) || hit.distance >= distance) return false;
      if (lights_->planeOf(hit.primitive) == plane) break;
      const reflection::Bsdf& other = bsdfOf(hit.surface);
      if (!other.lobes().straight) return false;
      Spectral transmittance = Spectral::filled(0);
      other.straightTransmittance(std::abs(glm::dot(hit.normal, direction)), transmittance.v.data());
      filter *= transmittance;
      distance -= hit.distance;
      origin = tracer_.leave(hit.position, glm::dot(hit.normal, direction) < 0 ? -hit.normal : hit.normal);
    } while (true);
    const std::uint32_t material = world_.surfaces[hit.surface].material;
    if (hasPanes_) {
      Spectral reflectance = Spectral::filled(0);
      bsdfs_[material]->mirrorReflectance(std::abs(glm::dot(hit.normal, direction)), reflectance.v.data());
      filter *= reflectance;
    } else {
      filter *= mirrorReflectance_[material];
    }
    distance -= hit.distance;
    const Vec3 facing = glm::dot(hit.normal, direction) < 0 ? hit.normal : -hit.normal;
    direction = lights_->planes()[plane].reflectDirection(direction);
    origin = tracer_.leave(hit.position, facing);
  }
  // From where the ray really starts to the very point of the emitter: moved sideways instead, rays to the rim of a
  // sphere or a tube would meet its near side (found against Radiance in the gallery: 0.4 % of the light).
  const Vec3 toTarget = target - origin;
  const double length = glm::length(toTarget);
  if (!(length > tracer_.slack())) return true;
  const double reach = length * (1 - 1e-5) - tracer_.slack();
  const auto& housings = world_.emitters[light.source].housings;
  if (hasPanes_ || !housings.empty()) return seenThroughPanes(housings, origin, toTarget / length, reach, filter, rays);
  ++rays;
  return !tracer_.occluded(origin, toTarget / length, reach);
}

template <int W>
bool PathSolver<W>::seenThroughPanes(const std::vector<std::uint32_t>& housings, Vec3 origin, const Vec3& direction,
                                     double length, Spectral& filter, std::uint64_t& rays) const {
  while (length > 0) {
    tracer::Hit hit;
    ++rays;
    if (!tracer_.intersect(origin, direction, hit) || hit.distance >= length) return true;
    const scene::Surface& surface = world_.surfaces[hit.surface];
    if (std::find(housings.begin(), housings.end(), surface.object) == housings.end()) {
      const reflection::Bsdf& bsdf = bsdfOf(hit.surface);
      if (!bsdf.lobes().straight) return false;
      Spectral transmittance = Spectral::filled(0);
      bsdf.straightTransmittance(std::abs(glm::dot(hit.normal, direction)), transmittance.v.data());
      filter *= transmittance;
    }
    const Vec3 next = tracer_.leave(hit.position, glm::dot(hit.normal, direction) < 0 ? -hit.normal : hit.normal);
    length -= std::max(glm::dot(next - origin, direction), tracer_.slack());
    origin = next;
  }
  return true;
}

template <int W>
Response PathSolver<W>::exactResponse(const Light& light, double value) const {
  Response sum{};
  Spectral filter = Spectral::filled(1);
  for (const std::uint32_t plane : light.mirrors) filter *= mirrorReflectance_[lights_->planes()[plane].material];
  add(sum, light.spectrum, filter, value);
  return sum;
}

template <int W>
double PathSolver<W>::answerTo(const Light& light, const Receiver& receiver, const Vec3& unfoldedDirection) const {
  return receiver.response(lights_->fold(light, unfoldedDirection));
}

template <int W>
Response PathSolver<W>::connectOnce(const LightPlan& plan, const Receiver& receiver, const core::Vec2& u,
                                    std::uint64_t& rays) const {
  const Light& light = lights_->lights()[plan.light];
  const Unfolded seen = lights_->unfold(light, receiver.point, receiver.normal);
  const emitter::IncidentLight incident = light.emitter->sample(seen.point, u);
  Response result{};
  if (incident.normalIlluminance <= 0) return result;
  const double answer = answerTo(light, receiver, incident.direction);
  if (answer <= 0) return result;
  Spectral filter = Spectral::filled(1);
  const bool visible = connected(light, vertexOf(receiver), incident.direction, incident.distance, filter, rays);
  const double value = incident.normalIlluminance * answer;
  // What is seen in full is in the exact part already.
  if (visible && (hasPanes_ || !plan.fromExact)) add(result, light.spectrum, filter, value);
  if (plan.fromExact && (hasPanes_ || !visible)) {
    const Response whole = exactResponse(light, value);
    for (std::size_t c = 0; c < result.size(); ++c) result[c] -= whole[c];
  }
  return result;
}

template <int W>
void PathSolver<W>::studyVisibility(LightPlan& entry, const Receiver& receiver, std::uint64_t key,
                                    std::uint64_t& rays) const {
  const Light& light = lights_->lights()[entry.light];
  const Unfolded seen = lights_->unfold(light, receiver.point, receiver.normal);
  const Vertex at = vertexOf(receiver);
  const double whole = photopic(exactResponse(light, 1));
  double sum = 0, visibleSum = 0, squaresSeen = 0, squaresLost = 0;
  for (std::uint32_t i = 0; i < entry.pilot; ++i) {
    core::Sampler random(core::combine(core::combine(key, lightStream), entry.light), i);
    const emitter::IncidentLight incident = light.emitter->sample(seen.point, random.next2());
    const double value =
        incident.normalIlluminance > 0 ? incident.normalIlluminance * answerTo(light, receiver, incident.direction) : 0;
    sum += value;
    Spectral filter = Spectral::filled(1);
    double visible = 0;
    if (value > 0 && connected(light, at, incident.direction, incident.distance, filter, rays)) {
      visible = value;
      if (hasPanes_ && whole > 0) {
        Response filtered{};
        add(filtered, light.spectrum, filter, value);
        visible = photopic(filtered) / whole;
      }
    }
    visibleSum += visible;
    squaresSeen += visible * visible;
    squaresLost += (value - visible) * (value - visible);
  }
  const double n = entry.pilot;
  bool constant = true;  // mirrors whose reflectance depends on the angle have no exact value to start from
  for (const std::uint32_t plane : light.mirrors)
    constant = constant && !bsdfs_[lights_->planes()[plane].material]->lobes().angular;
  entry.fromExact = receiver.isPlane() && constant && visibleSum >= 0.5 * sum && sum > 0;
  const double mean = (entry.fromExact ? sum - visibleSum : visibleSum) / n;
  entry.sigma = std::sqrt(std::max(0.0, (entry.fromExact ? squaresLost : squaresSeen) / n - mean * mean));
}

template <int W>
void PathSolver<W>::addDirect(Response& sum, const Vertex& at, const Meeting& met, const Vec3& out,
                              const Shading& shading, const Path& path, bool everyLight, core::Sampler& random,
                              std::uint64_t& rays) const {
  const reflection::Lobes& lobes = met.bsdf->lobes();
  const bool toEach = everyLight && lightsAreFew_;
  const double share = toEach ? 1 : 1 / static_cast<double>(lights_->lights().size());
  const auto connect = [&](const Vertex& side, std::uint32_t index, double weight) {
    const Light& light = lights_->lights()[index];
    const Unfolded seen = lights_->unfold(light, side.point, side.normal);
    const emitter::IncidentLight incident = light.emitter->sample(seen.point, random.next2());
    const double cosine = glm::dot(incident.direction, seen.normal);
    if (incident.normalIlluminance <= 0 || cosine <= 0) return;
    Spectral filter = path.throughput;
    if (!connected(light, side, incident.direction, incident.distance, filter, rays)) return;
    const Vec3 in = shading.frame.toLocal(lights_->fold(light, incident.direction));
    // A tilted surface takes light by its own cosine, but none from behind the real one.
    if (shading.isTilted && in.z * glm::dot(side.normal, at.normal) <= 0) return;
    const double response = shading.isTilted ? std::abs(in.z) * shading.gain : cosine;
    Spectral f = Spectral::filled(0);
    met.bsdf->evaluate(out, in, met.interface, f.v.data());
    f *= filter;
    // What sample() finds as well is shared with it (balance heuristic with a nominal density of the light, the same
    // on both sides, so that the shares add up to 1 exactly).
    if (lobes.glossy && world_.emitters[light.source].canBeMet()) {
      const double solidAngle = light.emitter->roughSolidAngle(seen.point);
      weight *= share / (share + met.bsdf->density(out, in, met.interface) * solidAngle);
    }
    add(sum, light.spectrum, f, incident.normalIlluminance * response * weight);
  };
  const auto fromSide = [&](const Vertex& side) {
    if (toEach) {
      for (std::uint32_t i = 0; i < lights_->lights().size(); ++i) connect(side, i, 1);
      return;
    }
    std::uint32_t chosen = 0;
    double probability = 0;
    if (lights_->choose(side.point, side.normal, random.next(), chosen, probability))
      connect(side, chosen, 1 / probability);
  };
  fromSide(at);
  if (lobes.transmits) fromSide({at.point, tracer_.leave(at.point, -at.normal), -at.normal});
  if (caustics_) addCaustics(sum, at, met, out, shading, path, everyLight, random, rays);
}

}  // namespace goniolux::solver
