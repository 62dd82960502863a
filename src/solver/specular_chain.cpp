#include "solver/specular_chain.h"

#include <algorithm>
#include <cmath>

#include "geometry/quadric_intersect.h"
#include "reflection/fresnel.h"

namespace goniolux::solver {

using core::Vec3;
using Kind = SpecularStep::Kind;

namespace {

// Interfaces within other bodies that a ray passes in a row.
constexpr int mostPassed = 64;

double indexAt(const reflection::Medium* medium, std::size_t node) {
  return medium != nullptr ? static_cast<double>(medium->index[node]) : 1.0;
}

}  // namespace

bool SpecularChains::meet(Vec3 origin, const Vec3& direction, Media media, Encounter& met, std::uint64_t& rays) const {
  const Vec3 start = origin;
  for (int passed = 0; passed < mostPassed; ++passed) {
    ++rays;
    if (!tracer_.intersect(origin, direction, met.hit)) return false;
    const scene::Surface& surface = world_.surfaces[met.hit.surface];
    const reflection::Bsdf& bsdf = *bsdfs_[surface.material];
    const reflection::Medium* own = bsdf.medium();
    met.fromInside = glm::dot(met.hit.normal, direction) > 0;
    if (own != nullptr && met.fromInside) media.enter(surface.object, own);  // new only where the way began in it
    met.media = media;
    met.here = met.beyond = media.here();
    met.distance = glm::dot(met.hit.position - start, direction);
    met.isSpecular = bsdf.isSpecular() && bsdf.largestReflectance() > 0;
    if (own == nullptr) return true;
    Media past = media;
    met.fromInside ? past.leave(surface.object) : past.enter(surface.object, own);
    met.beyond = past.here();
    if (met.beyond != met.here) return true;
    media = past;
    origin = tracer_.leave(met.hit.position, met.fromInside ? met.hit.normal : -met.hit.normal);
  }
  return false;
}

SpecularStep SpecularChains::stepAt(const Encounter& met, Kind kind) const {
  SpecularStep step;
  step.kind = kind;
  step.surface = met.hit.surface;
  step.material = world_.surfaces[met.hit.surface].material;
  step.isInterface = bsdfs_[step.material]->medium() != nullptr;
  if (met.hit.primitive != scene::none && met.hit.primitive >= world_.triangles.size())
    step.patch = met.hit.primitive - static_cast<std::uint32_t>(world_.triangles.size());
  step.point = met.hit.position;
  step.normal = met.hit.normal;
  step.here = met.here;
  step.beyond = met.beyond;
  return step;
}

bool SpecularChains::isPane(const Encounter& met) const {
  return bsdfs_[world_.surfaces[met.hit.surface].material]->lobes().straight;
}

Media SpecularChains::mediaAfter(const Encounter& met, Kind kind) const {
  Media media = met.media;
  if (kind != Kind::refracted) return media;
  const scene::Surface& surface = world_.surfaces[met.hit.surface];
  met.fromInside ? media.leave(surface.object) : media.enter(surface.object, bsdfs_[surface.material]->medium());
  return media;
}

// `normal` faces the ray.
bool SpecularChains::bend(const SpecularStep& step, const Vec3& normal, std::size_t node, Vec3& direction) {
  const double cosine = -glm::dot(normal, direction);
  if (step.kind == Kind::straight) return true;
  if (step.kind == Kind::reflected) {
    direction = glm::normalize(direction + normal * (2 * cosine));
    return true;
  }
  const double ratio = indexAt(step.here, node) / indexAt(step.beyond, node);
  const double sineSquared = ratio * ratio * (1 - cosine * cosine);
  if (sineSquared >= 1) return false;
  direction = glm::normalize(direction * ratio + normal * (ratio * cosine - std::sqrt(1 - sineSquared)));
  return true;
}

bool SpecularChains::advance(const SpecularStep& step, Vec3& origin, Vec3& direction, std::size_t node, double& length,
                             double& cosine) const {
  Vec3 normal = step.normal;
  if (step.patch == scene::none) {
    const double slope = glm::dot(direction, normal);
    if (slope == 0) return false;
    length = glm::dot(step.point - origin, normal) / slope;
    if (!(length > 0)) return false;
    origin += direction * length;
  } else {
    const scene::PlacedPatch& patch = world_.patches[step.patch];
    const Vec3 from(patch.toCanonical * glm::dvec4(origin, 1)), along(patch.toCanonical * glm::dvec4(direction, 0));
    // Not where the ray has just left it.
    if (!geometry::intersect(patch.patch, from, along, tracer_.slack(), 8 * world_.radius, length)) return false;
    origin += direction * length;
    const Vec3 canonical(patch.toCanonical * glm::dvec4(origin, 1));
    normal = glm::normalize(glm::transpose(core::Mat3(patch.toCanonical)) *
                            geometry::canonicalNormal(patch.patch, canonical));
  }
  if (glm::dot(normal, direction) > 0) normal = -normal;
  cosine = -glm::dot(normal, direction);
  return cosine > 0 && bend(step, normal, node, direction);
}

bool SpecularChains::run(std::span<const SpecularStep> steps, Vec3 origin, Vec3 direction, std::size_t node,
                         ChainEnd& end) const {
  double length = 0, cosine = 0;
  for (const SpecularStep& step : steps)
    if (!advance(step, origin, direction, node, length, cosine)) return false;
  end = {origin, direction};
  return true;
}

bool SpecularChains::run(std::span<const SpecularStep> steps, Vec3 origin, Vec3 direction, std::size_t node,
                         ChainEnd& end, float* filter) const {
  double length = 0, cosine = 0;
  for (const SpecularStep& step : steps) {
    if (!advance(step, origin, direction, node, length, cosine)) return false;
    absorb(step.here, length, filter);
    applyStep(step, cosine, filter);
  }
  end = {origin, direction};
  return true;
}

void SpecularChains::absorb(const reflection::Medium* medium, double distance, float* filter) const {
  if (medium == nullptr || !medium->absorbs) return;
  for (std::size_t k = 0; k < nodes_; ++k)
    filter[k] *= std::exp(-medium->attenuation[k] * static_cast<float>(distance));
}

void SpecularChains::applyStep(const SpecularStep& step, double cosine, float* filter) const {
  if (step.isInterface) {
    for (std::size_t k = 0; k < nodes_; ++k) {
      const double relative = indexAt(step.beyond, k) / indexAt(step.here, k);
      const double r = reflection::dielectricReflectance(std::min(cosine, 1.0), relative).mean();
      filter[k] *= static_cast<float>(step.kind == Kind::reflected ? r : 1 - r);
    }
    return;
  }
  std::vector<float> factors(nodes_, 0.0f);
  const reflection::Bsdf& bsdf = *bsdfs_[step.material];
  step.kind == Kind::straight ? bsdf.straightTransmittance(cosine, factors.data())
                              : bsdf.mirrorReflectance(cosine, factors.data());
  for (std::size_t k = 0; k < nodes_; ++k) filter[k] *= factors[k];
}

bool SpecularChains::confirm(std::span<const SpecularStep> steps, Vec3 origin, Vec3 direction, std::size_t node,
                             const Vec3& target, std::uint64_t& rays) const {
  Media media;
  Encounter met;
  Vec3 ideal = origin, idealDirection = direction;
  for (const SpecularStep& step : steps) {
    double length = 0, cosine = 0;
    if (!meet(origin, direction, media, met, rays)) return false;
    if (!advance(step, ideal, idealDirection, node, length, cosine)) return false;
    // The same place of the same finish; its neighbour triangle in the same plane will do.
    const double slack = 16 * tracer_.slack() / std::max(cosine, 1e-3);
    if (world_.surfaces[met.hit.surface].material != step.material || glm::distance(met.hit.position, ideal) > slack)
      return false;
    if (step.patch == scene::none && std::abs(glm::dot(met.hit.normal, step.normal)) < 1 - 1e-9) return false;
    media = mediaAfter(met, step.kind);
    const Vec3 facing = met.fromInside ? -met.hit.normal : met.hit.normal;
    origin = tracer_.leave(met.hit.position, step.kind == Kind::reflected ? facing : -facing);
    direction = idealDirection;
  }
  // On to the target, past interfaces within other bodies.
  const Vec3 way = target - origin;
  const double length = glm::length(way);
  if (!(length > tracer_.slack())) return true;
  if (!meet(origin, way / length, media, met, rays)) return true;
  return met.distance >= length * (1 - 1e-5) - tracer_.slack();
}

}  // namespace goniolux::solver
