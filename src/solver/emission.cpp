#include "solver/emission.h"

#include <algorithm>
#include <cmath>

#include "solver/directions.h"

namespace goniolux::solver {

using core::Vec2;
using core::Vec3;

namespace {

constexpr int rings = 48, sectors = 16;
constexpr double evenShare = 0.05;  // of the rays, spread evenly: the table may have missed a narrow beam

// Angles from the aim grow with the square: the first ring of 48 is 0.08 degrees wide.
double cosineAt(double ring) {
  const double part = ring / rings;
  return std::cos(core::pi * part * part);
}

}  // namespace

Emission::Emission(const scene::LightSource& source, double far)
    : source_(source), frame_(frameAbout(source.emitter->aim())), center_(source.bounds.center()), far_(far) {
  double sum = 0;
  for (int ring = 0; ring < rings; ++ring) {
    const double cosine = cosineAt(ring + 0.5), sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
    const double solidAngle = 2 * core::pi * (cosineAt(ring) - cosineAt(ring + 1)) / sectors;
    for (int sector = 0; sector < sectors; ++sector) {
      const double angle = 2 * core::pi * (sector + 0.5) / sectors;
      Vec3 origin;
      const Vec3 direction = frame_.toWorld({sine * std::cos(angle), sine * std::sin(angle), cosine});
      sum += solidAngle * intensity(direction, {0.5, 0.5}, origin);
      cumulative_.push_back(sum);
    }
  }
  if (sum > 0)
    for (double& c : cumulative_) c /= sum;
}

// Seen from far away, any emitter's sample is an element and the intensity that it stands for.
double Emission::intensity(const Vec3& direction, const Vec2& place, Vec3& origin) const {
  const Vec3 from = center_ + direction * far_;
  const emitter::IncidentLight light = source_.emitter->sample(from, place);
  origin = from + light.direction * light.distance;
  return light.normalIlluminance * light.distance * light.distance;
}

EmittedRay Emission::ray(const Vec2& forDirection, const Vec2& forPlace) const {
  EmittedRay ray;
  double cosine = 0, angle = 0, density = 0;
  const bool known = cumulative_.back() > 0;
  if (!known || forDirection.x < evenShare) {
    cosine = 1 - 2 * (known ? forDirection.x / evenShare : forDirection.x);
    angle = 2 * core::pi * forDirection.y;
  } else {
    const double u = (forDirection.x - evenShare) / (1 - evenShare);
    const auto found = std::upper_bound(cumulative_.begin(), cumulative_.end() - 1, u);
    const double below = found == cumulative_.begin() ? 0 : *(found - 1), share = std::max(*found - below, 1e-300);
    const auto index = static_cast<int>(found - cumulative_.begin());
    const int ring = index / sectors, sector = index % sectors;
    const double outer = cosineAt(ring + 1), inner = cosineAt(ring);
    cosine = inner + (outer - inner) * std::clamp((u - below) / share, 0.0, 1.0);
    angle = 2 * core::pi * (sector + forDirection.y) / sectors;
  }
  // Both ways of choosing it.
  const double part = std::sqrt(std::acos(std::clamp(cosine, -1.0, 1.0)) / core::pi);
  const int ring = std::min(rings - 1, static_cast<int>(part * rings));
  const int sector = std::min(sectors - 1, static_cast<int>(angle / (2 * core::pi) * sectors));
  const auto index = static_cast<std::size_t>(ring * sectors + sector);
  const double solidAngle = 2 * core::pi * (cosineAt(ring) - cosineAt(ring + 1)) / sectors;
  const double share = cumulative_[index] - (index == 0 ? 0 : cumulative_[index - 1]);
  density = known ? evenShare / (4 * core::pi) + (1 - evenShare) * share / solidAngle : 1 / (4 * core::pi);
  const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
  ray.direction = frame_.toWorld({sine * std::cos(angle), sine * std::sin(angle), cosine});
  ray.flux = intensity(ray.direction, forPlace, ray.origin) / density;
  return ray;
}

}  // namespace goniolux::solver
