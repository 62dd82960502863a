#include "solver/seen_lights.h"

#include <algorithm>
#include <cmath>

#include "core/random.h"

namespace goniolux::solver {
namespace {

using core::Vec3;

constexpr std::uint64_t stream = 0x5ee;
constexpr int mostPanes = 64;

}  // namespace

SeenLights::SeenLights(const Problem& problem) : problem_(problem) {
  for (const material::Material& material : problem.world.materials)
    bsdfs_.push_back(reflection::findReflectionModel(material.model) != nullptr
                         ? reflection::makeBsdf(material, problem.quadrature)
                         : nullptr);  // a local shading of the paper's: opaque here
}

double SeenLights::transmittance(const Vec3& eye, const Vec3& direction, double distance, std::uint32_t source,
                                 Vec3& normal) const {
  const scene::World& world = problem_.world;
  const tracer::Tracer& tracer = problem_.tracer;
  const std::size_t nodes = problem_.quadrature.wavelengths.size();
  const auto& weights = problem_.quadrature.weights[world.emitters[source].spectrum];
  std::vector<float> through(nodes, 1.0f), pane(nodes);
  const auto photopic = [&] {
    double sum = 0;
    for (std::size_t k = 0; k < nodes; ++k) sum += static_cast<double>(through[k]) * weights[k][1];
    return sum;
  };
  Vec3 origin = eye;
  double left = distance;
  for (int panes = 0; panes < mostPanes; ++panes) {
    tracer::Hit hit;
    const bool found = tracer.intersect(origin, direction, hit);
    if (found && world.surfaces[hit.surface].emitter == source) {
      normal = hit.normal;
      return photopic();
    }
    if (!found || hit.distance >= left * (1 - 1e-5) - tracer.slack()) {
      // An emitting finish, or a point or line that has no geometry.
      normal = found ? hit.normal : -direction;
      return photopic();
    }
    const reflection::Bsdf* bsdf = bsdfs_[world.surfaces[hit.surface].material].get();
    if (bsdf == nullptr || !bsdf->lobes().straight) return 0;
    bsdf->straightTransmittance(std::abs(glm::dot(hit.normal, direction)), pane.data());
    for (std::size_t k = 0; k < nodes; ++k) through[k] *= pane[k];
    const Vec3 next = tracer.leave(hit.position, glm::dot(hit.normal, direction) < 0 ? -hit.normal : hit.normal);
    left -= glm::dot(next - origin, direction);
    origin = next;
  }
  return 0;
}

std::vector<SeenLight> SeenLights::from(const Vec3& eye, std::uint64_t key, std::uint32_t samples) const {
  const scene::World& world = problem_.world;
  std::vector<SeenLight> lights;
  for (std::uint32_t i = 0; i < world.emitters.size(); ++i) {
    const scene::LightSource& source = world.emitters[i];
    SeenLight seen;
    seen.source = i;
    Vec3 middle{0};
    double weight = 0;
    for (std::uint32_t s = 0; s < samples; ++s) {
      core::Sampler random(core::combine(core::combine(key, stream), i), s);
      const emitter::IncidentLight light = source.emitter->sample(eye, random.next2());
      if (light.normalIlluminance <= 0) continue;
      Vec3 normal;
      const double filter = transmittance(eye, light.direction, light.distance, i, normal);
      if (filter <= 0) continue;
      seen.normalIlluminance += light.normalIlluminance * filter / samples;
      double angle = 0;
      if (source.hasGeometry) {
        const Vec3 facing = glm::dot(normal, light.direction) < 0 ? normal : -normal;
        const double luminance = source.emitter->luminance(facing, -light.direction);
        if (luminance > 0) angle = light.normalIlluminance / luminance / samples;
      }
      seen.solidAngle += angle;
      const double share = source.hasGeometry ? angle : 1.0 / samples;
      middle += light.direction * (share * light.distance);
      weight += share;
    }
    if (!(seen.normalIlluminance > 0) || !(weight > 0)) continue;
    seen.distance = glm::length(middle) / weight;
    seen.direction = glm::normalize(middle);
    lights.push_back(seen);
  }
  return lights;
}

}  // namespace goniolux::solver
