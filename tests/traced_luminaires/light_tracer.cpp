#include "traced_luminaires/light_tracer.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"
#include "core/random.h"
#include "scene/world.h"
#include "tracer/tracer.h"

namespace goniolux::traced {
namespace {

using core::pi;
using core::Vec2;
using core::Vec3;
using photometry::HorizontalSymmetry;

// Light that has been at so many surfaces is lost; below a tenth of its start it goes on by chance.
constexpr int mostHits = 200;

Vec3 cosineDirection(const Vec3& normal, const Vec2& u) {
  Vec3 x, y;
  core::perpendiculars(normal, x, y);
  const double r = std::sqrt(u.x), phi = 2 * pi * u.y;
  return x * (r * std::cos(phi)) + y * (r * std::sin(phi)) + normal * std::sqrt(std::max(0.0, 1 - u.x));
}

struct Start {
  Vec3 point, normal;
};

Start startOn(const Lamp& lamp, const Vec2& u) {
  switch (lamp.kind) {
    case Lamp::Kind::disc: {
      Vec3 x, y;
      core::perpendiculars(lamp.normal, x, y);
      const double r = 0.5 * lamp.diameter * std::sqrt(u.x), phi = 2 * pi * u.y;
      return {lamp.center + x * (r * std::cos(phi)) + y * (r * std::sin(phi)), lamp.normal};
    }
    case Lamp::Kind::rectangle: {
      const Vec3 across = glm::cross(lamp.normal, lamp.along);
      return {lamp.center + lamp.along * (lamp.length * (u.x - 0.5)) + across * (lamp.width * (u.y - 0.5)),
              lamp.normal};
    }
    case Lamp::Kind::tube: {
      Vec3 x, y;
      core::perpendiculars(lamp.along, x, y);
      const double phi = 2 * pi * u.y;
      const Vec3 normal = x * std::cos(phi) + y * std::sin(phi);
      return {lamp.center + lamp.along * (lamp.length * (u.x - 0.5)) + normal * (0.5 * lamp.diameter), normal};
    }
    case Lamp::Kind::sphere:
      break;
  }
  const double z = 1 - 2 * u.x, s = std::sqrt(std::max(0.0, 1 - z * z)), phi = 2 * pi * u.y;
  const Vec3 normal(s * std::cos(phi), s * std::sin(phi), z);
  return {lamp.center + normal * (0.5 * lamp.diameter), normal};
}

/// Flux by table angle: each angle's neighbourhood reaches halfway to its neighbours.
class Bins {
 public:
  explicit Bins(const Fixture& fixture) : planes_(fixture.planes), gammas_(fixture.gammas) {
    symmetry_ = photometry::horizontalSymmetry(photometry::PhotometryType::c, planes_).value();
    flux_.assign(planes_.size() * gammas_.size(), 0.0);
  }

  void add(const Vec3& direction, double flux) {
    const double gamma = std::acos(std::clamp(-direction.z, -1.0, 1.0)) / core::degree;
    double c = std::atan2(direction.y, direction.x) / core::degree;
    if (c < 0) c += 360;
    switch (symmetry_) {
      case HorizontalSymmetry::rotational:
        c = 0;
        break;
      case HorizontalSymmetry::quadrant:
        c = c > 180 ? 360 - c : c;
        c = c > 90 ? 180 - c : c;
        break;
      case HorizontalSymmetry::aboutC0:
        c = c > 180 ? 360 - c : c;
        break;
      case HorizontalSymmetry::aboutC90:
        c = c < 90 ? 180 - c : c > 270 ? 540 - c : c;
        break;
      default:
        break;
    }
    const std::size_t g = nearest(gammas_, gamma);
    std::size_t h = nearest(planes_, c);
    if (symmetry_ == HorizontalSymmetry::none && c > 0.5 * (planes_.back() + 360)) h = 0;
    if (std::abs(gamma - gammas_[g]) > 2 * (gammas_.back() - gammas_[gammas_.size() - 2])) return;
    flux_[h * gammas_.size() + g] += flux;
  }

  void add(const Bins& other) {
    for (std::size_t i = 0; i < flux_.size(); ++i) flux_[i] += other.flux_[i];
  }

  // Flux over the solid angle of each neighbourhood, all copies together. Planes are one at the poles.
  [[nodiscard]] std::vector<double> candelas() const {
    std::vector<double> result(flux_.size());
    const double copies = photometry::symmetryCopies(symmetry_);
    for (std::size_t g = 0; g < gammas_.size(); ++g) {
      const double low = g == 0 ? gammas_[0] : 0.5 * (gammas_[g - 1] + gammas_[g]);
      const double high = g + 1 == gammas_.size() ? gammas_[g] : 0.5 * (gammas_[g] + gammas_[g + 1]);
      const double ring = std::cos(low * core::degree) - std::cos(high * core::degree);
      double all = 0;
      for (std::size_t h = 0; h < planes_.size(); ++h) all += flux_[h * gammas_.size() + g];
      const bool pole = gammas_[g] == 0 || gammas_[g] == 180;
      for (std::size_t h = 0; h < planes_.size(); ++h)
        result[h * gammas_.size() + g] =
            pole ? all / (2 * pi * ring) : flux_[h * gammas_.size() + g] / (copies * width(h) * core::degree * ring);
    }
    return result;
  }

 private:
  static std::size_t nearest(const std::vector<double>& angles, double angle) {
    const auto above = std::lower_bound(angles.begin(), angles.end(), angle);
    if (above == angles.begin()) return 0;
    if (above == angles.end()) return angles.size() - 1;
    const auto i = static_cast<std::size_t>(above - angles.begin());
    return angle - angles[i - 1] <= angles[i] - angle ? i - 1 : i;
  }
  // Extent in C of a plane's neighbourhood within the stated range, degrees.
  [[nodiscard]] double width(std::size_t h) const {
    if (symmetry_ == HorizontalSymmetry::rotational) return 360;
    const bool open = symmetry_ == HorizontalSymmetry::none;
    const double before = h > 0 ? planes_[h - 1] : open ? planes_.back() - 360 : planes_[0];
    const double after = h + 1 < planes_.size() ? planes_[h + 1] : open ? planes_[0] + 360 : planes_[h];
    return 0.5 * (after - before);
  }

  std::vector<double> planes_, gammas_, flux_;
  HorizontalSymmetry symmetry_ = HorizontalSymmetry::none;
};

struct Sum {
  Bins bins;
  double left = 0, hits = 0;
};

void traceRay(const Fixture& fixture, const scene::World& world, const tracer::Tracer& tracer, core::Sampler& random,
              double flux, Sum& sum) {
  double pick = random.next();
  std::size_t lamp = 0;
  while (lamp + 1 < fixture.lamps.size() && pick >= fixture.lamps[lamp].share) pick -= fixture.lamps[lamp++].share;
  const Start start = startOn(fixture.lamps[lamp], random.next2());
  Vec3 point = start.point - world.origin, direction = cosineDirection(start.normal, random.next2());
  point = tracer.leave(point, start.normal);
  double weight = flux;
  for (int hits = 0; hits < mostHits; ++hits) {
    tracer::Hit hit;
    if (!tracer.intersect(point, direction, hit)) {
      sum.bins.add(direction, weight);
      sum.left += weight;
      return;
    }
    sum.hits += 1;
    const Part& part = fixture.parts[world.surfaces[hit.surface].object];
    const Vec3 side = glm::dot(hit.normal, direction) < 0 ? hit.normal : -hit.normal;
    Vec3 leaving = side;
    switch (part.finish) {
      case Finish::black:
        return;
      case Finish::mirror:
        weight *= part.reflectance;
        direction = glm::normalize(direction - side * (2 * glm::dot(direction, side)));
        break;
      case Finish::diffuse:
        weight *= part.reflectance;
        direction = cosineDirection(side, random.next2());
        break;
      case Finish::diffuser: {
        const double all = part.reflectance + part.transmittance;
        weight *= all;
        if (random.next() * all < part.transmittance) leaving = -side;
        direction = cosineDirection(leaving, random.next2());
        break;
      }
    }
    if (weight < 0.1 * flux) {
      constexpr double survival = 0.5;
      if (random.next() >= survival) return;
      weight /= survival;
    }
    point = tracer.leave(hit.position, leaving);
  }
}

constexpr std::uint32_t noiseParts = 16;

// Largest relative standard error of the sum of equal parts, among values above a tenth of the largest.
double noiseOf(const std::vector<Bins>& parts) {
  std::vector<std::vector<double>> tables;
  for (const Bins& part : parts) tables.push_back(part.candelas());
  const auto n = static_cast<double>(parts.size());
  std::vector<double> sums(tables.front().size(), 0.0), errors(sums.size(), 0.0);
  for (std::size_t i = 0; i < sums.size(); ++i) {
    for (const auto& table : tables) sums[i] += table[i];
    for (const auto& table : tables) errors[i] += (table[i] - sums[i] / n) * (table[i] - sums[i] / n);
    errors[i] = std::sqrt(errors[i] * n / (n - 1));  // of the sum
  }
  const double largest = *std::max_element(sums.begin(), sums.end());
  double noise = 0;
  for (std::size_t i = 0; i < sums.size(); ++i)
    if (sums[i] > 0.1 * largest) noise = std::max(noise, errors[i] / sums[i]);
  return noise;
}

}  // namespace

TracedLight trace(const Fixture& fixture, int logRays) {
  scene::Environment environment;
  for (const Part& part : fixture.parts) {
    scene::Object object;
    object.shape = part.shape;
    object.materials.assign(std::max<std::size_t>(1, part.shape.partNames.size()), 0);
    environment.objects.push_back(std::move(object));
  }
  environment.materials.emplace_back();
  const scene::World world = scene::buildWorld(environment);
  const tracer::Tracer tracer(world);
  const std::uint32_t rays = 1u << logRays;
  const double flux = fixture.lampFlux / rays;
  // Packets of rays, summed in their order.
  const std::uint32_t packet = std::min(1u << 14, std::max(1u, rays / noiseParts));
  const std::size_t packets = std::max<std::size_t>(1, rays / packet);
  std::vector<Sum> sums(packets, Sum{Bins(fixture)});
  core::parallelFor(packets, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p)
      for (std::uint32_t i = 0; i < std::min(rays, packet); ++i) {
        core::Sampler random(20261123, static_cast<std::uint32_t>(p) * packet + i);
        traceRay(fixture, world, tracer, random, flux, sums[p]);
      }
  });
  Sum sum{Bins(fixture)};
  std::vector<Bins> parts(noiseParts, Bins(fixture));
  for (std::size_t p = 0; p < packets; ++p) {
    sum.bins.add(sums[p].bins);
    sum.left += sums[p].left;
    sum.hits += sums[p].hits;
    parts[p * noiseParts / packets].add(sums[p].bins);
  }
  using photometry::PhotometryType;
  using photometry::TabulatedDistribution;
  std::vector<double> candelas = sum.bins.candelas();
  const TabulatedDistribution raw(PhotometryType::c, fixture.planes, fixture.gammas, candelas);
  for (double& value : candelas) value *= raw.flux() > 0 ? sum.left / raw.flux() : 0;
  // Four digits are more than the noise allows.
  const double unit = std::pow(10, std::floor(std::log10(*std::max_element(candelas.begin(), candelas.end()))) - 3);
  for (double& value : candelas) value = std::round(value / unit) * unit;
  return {std::make_shared<const TabulatedDistribution>(PhotometryType::c, fixture.planes, fixture.gammas, candelas),
          sum.left / fixture.lampFlux, sum.hits / rays, packets < noiseParts ? 1 : noiseOf(parts)};
}

}  // namespace goniolux::traced
