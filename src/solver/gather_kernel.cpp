#include "solver/gather_kernel.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"
#include "solver/directions.h"
#include "solver/path_caustics.h"
#include "solver/world_extent.h"

namespace goniolux::solver {

namespace {

constexpr std::uint64_t seedKey = 0x5eed, exploreKey = 0xe491, linkKey = 0x1147, directKey = 0xd17ec7,
                        chosenKey = 0xc400;
constexpr std::size_t exploringRays = 12;
constexpr std::size_t mostCells = 200000;
// Of a cell's points' direct light, relative to all its light: above this spread the mean stands for none of them.
// The mean of so few points is as wrong as half of it, so finer answers allow less.
constexpr double roughSpread = 0.35, roughSpreadOverAccuracy = 10, leastRoughSpread = 0.08;
constexpr double lookTolerance = 3e-2;
constexpr double solveTolerance = 1e-4;
// Lights beyond this number are sampled by importance.
constexpr std::size_t fewLights = 32;

core::Vec3 uniformDirection(const core::Vec2& u) {
  const double z = 1 - 2 * u.x, r = std::sqrt(std::max(0.0, 1 - z * z)), angle = 2 * core::pi * u.y;
  return {r * std::cos(angle), r * std::sin(angle), z};
}

}  // namespace

template <int W>
GatherSolver<W>::GatherSolver(const Problem& problem) : Base(problem), accuracy_(problem.accuracy) {
  for (const auto& bsdf : this->bsdfs_) {
    Spectral rho = Spectral::filled(0);
    if (bsdf->isLambertian()) bsdf->diffuseReflectance(rho.v.data());
    reflectance_.push_back(rho);
  }

  // Finer answers need a finer solution; the remainder (missed()) tells whether it was fine enough.
  const double cells = std::clamp(16 / std::max(problem.accuracy, 1e-4), 300.0, 20000.0);
  linksPerCell_ = problem.accuracy >= 0.03 ? 48 : problem.accuracy >= 0.008 ? 64 : 128;
  const double size = std::sqrt(std::max(areaOf(this->world_), 1e-12) / cells);
  this->solution_ = std::make_unique<LightSolution>(size, this->world_.sourceSpectra.size(), W);
  LightSolution::Transport transport;
  discover(transport);
  lightCells(transport);
  this->solution_->solve(transport, solveTolerance);
  setResponses();
}

template <int W>
void GatherSolver<W>::linkCells(std::size_t from, std::size_t to, std::size_t raysPerCell,
                                std::vector<LightSolution::Link>& links, std::vector<float>& filters) {
  LightSolution& solution = *this->solution_;
  std::vector<Arrival> arrivals((to - from) * raysPerCell);
  core::parallelFor(to - from, 8, [&](std::size_t begin, std::size_t end) {
    std::uint64_t rays = 0;
    for (std::size_t j = begin; j < end; ++j) {
      const auto cell = static_cast<std::uint32_t>(from + j);
      const auto points = solution.pointsOf(cell);
      const bool black = reflectance_[this->world_.surfaces[solution.surfaceOf(cell)].material].largest() <= 0;
      for (std::size_t i = 0; i < raysPerCell && !black; ++i) {
        const LightSolution::Point& point = points[i % points.size()];
        core::Sampler random(core::combine(core::combine(linkKey, raysPerCell), cell), static_cast<std::uint32_t>(i));
        const Vec3 direction = cosineDirection(frameAbout(point.normal), random.next2());
        arrivals[j * raysPerCell + i] =
            this->arrive(this->tracer_.leave(point.position, point.normal), direction, random, rays);
      }
    }
    this->rays_.fetch_add(rays, std::memory_order_relaxed);
  });
  for (const Arrival& arrival : arrivals) {
    LightSolution::Link link;
    if (arrival.found && solution.cellCount() < mostCells) {
      link.cell = solution.add(arrival.surface, arrival.at.point, arrival.at.normal);
      if (arrival.textured) {
        TexturedCell& cell = texturedCells_[link.cell];
        for (std::size_t k = 0; k < static_cast<std::size_t>(W); ++k) cell.sum.v[k] += arrival.reflectance.v[k];
        ++cell.count;
      }
      if (arrival.filtered) {
        link.filter = static_cast<std::uint32_t>(filters.size() / W);
        filters.insert(filters.end(), arrival.filter.v.begin(), arrival.filter.v.end());
      }
    }
    links.push_back(link);
  }
}

template <int W>
void GatherSolver<W>::discover(LightSolution::Transport& transport) {
  LightSolution& solution = *this->solution_;
  // First cells: where rays from random places of the scene's box end.
  const geometry::Bounds box = boundsOf(this->world_);
  std::uint64_t rays = 0;
  const auto seeds = static_cast<std::uint32_t>(256);
  for (std::uint32_t i = 0; i < seeds; ++i) {
    core::Sampler random(seedKey, i);
    const core::Vec2 xy = random.next2();
    const double z = random.next();
    const Vec3 origin = box.min + (box.max - box.min) * Vec3(xy, z);
    const Arrival arrival = this->arrive(origin, uniformDirection(random.next2()), random, rays);
    if (arrival.found) solution.add(arrival.surface, arrival.at.point, arrival.at.normal);
  }
  this->rays_.fetch_add(rays, std::memory_order_relaxed);
  // Then whatever those see, with few rays, until nothing new turns up; this also gives cells their points.
  std::vector<LightSolution::Link> ignoredLinks;
  std::vector<float> ignoredFilters;
  for (std::size_t done = 0; done < solution.cellCount();) {
    const std::size_t known = solution.cellCount();
    linkCells(done, known, exploringRays, ignoredLinks, ignoredFilters);
    done = known;
  }
  transport.linksPerCell = linksPerCell_;
  for (std::size_t done = 0; done < solution.cellCount();) {
    const std::size_t known = solution.cellCount();
    linkCells(done, known, linksPerCell_, transport.links, transport.filters);
    done = known;
  }
}

template <int W>
void GatherSolver<W>::directAt(const Vertex& at, std::uint64_t key, std::vector<Spectral>& bySource,
                               std::uint64_t& rays) const {
  const auto& lights = this->lights_->lights();
  const auto connect = [&](std::uint32_t index, double weight, std::uint32_t samples) {
    const Light& light = lights[index];
    const Unfolded seen = this->lights_->unfold(light, at.point, at.normal);
    if (light.emitter->importance(seen.point, seen.normal) <= 0) return;
    Spectral mirrored = Spectral::filled(1);
    for (const std::uint32_t plane : light.mirrors)
      mirrored *= this->mirrorReflectance_[this->lights_->planes()[plane].material];
    // In closed form less what is blocked, or what is seen.
    Spectral full = mirrored;
    const bool closed = light.emitter->hasClosedForm() && !this->hasPanes_;
    if (closed)
      full *= static_cast<float>(light.emitter->illuminance(seen.point, seen.normal, lookTolerance).value);
    else
      full = Spectral::filled(0);
    for (std::uint32_t i = 0; i < samples; ++i) {
      core::Sampler random(core::combine(key, index), i);
      const emitter::IncidentLight incident = light.emitter->sample(seen.point, random.next2());
      const double cosine = glm::dot(incident.direction, seen.normal);
      if (incident.normalIlluminance <= 0 || cosine <= 0) continue;
      Spectral filter = Spectral::filled(1);
      const double value = incident.normalIlluminance * cosine / samples;
      if (this->connected(light, at, incident.direction, incident.distance, filter, rays) == closed) continue;
      if (closed) filter = mirrored;
      filter *= static_cast<float>(closed ? -value : value);
      for (int k = 0; k < W; ++k) full.v[k] += filter.v[k];
    }
    full *= static_cast<float>(weight);
    for (int k = 0; k < W; ++k) bySource[light.spectrum].v[k] += full.v[k];
  };
  if (this->caustics_) {
    this->everyCausticAt(at.point, -1, rays, [&](const Caustics::Arrival& arrival, Spectral& filter) {
      filter *= static_cast<float>(arrival.normalIlluminance * std::max(0.0, glm::dot(arrival.direction, at.normal)));
      const std::uint32_t spectrum = this->world_.emitters[arrival.source].spectrum;
      for (int k = 0; k < W; ++k) bySource[spectrum].v[k] += filter.v[k];
    });
  }
  if (lights.size() <= fewLights) {
    for (std::uint32_t i = 0; i < lights.size(); ++i) connect(i, 1, lights[i].emitter->hasClosedForm() ? 1 : 4);
    return;
  }
  thread_local std::vector<LightList::Choice> choices;
  core::Sampler random(core::combine(key, chosenKey), 0);
  this->lights_->chooseMany(at.point, at.normal, random.next(), fewLights, choices);
  for (const auto& [light, weight] : choices) connect(light, weight, 1);
}

template <int W>
void GatherSolver<W>::lightCells(LightSolution::Transport& transport) {
  LightSolution& solution = *this->solution_;
  const std::size_t cells = solution.cellCount(), sources = solution.sources();
  transport.direct.assign(cells * sources * W, 0.0f);
  transport.reflectance.assign(cells * W, 0.0f);
  std::vector<float> spread(cells);
  core::parallelFor(cells, 8, [&](std::size_t begin, std::size_t end) {
    std::uint64_t rays = 0;
    std::vector<Spectral> bySource(sources);
    for (std::size_t c = begin; c < end; ++c) {
      const auto cell = static_cast<std::uint32_t>(c);
      Spectral rho = reflectance_[this->world_.surfaces[solution.surfaceOf(cell)].material];
      if (const auto textured = texturedCells_.find(cell); textured != texturedCells_.end()) {
        rho = textured->second.sum;
        rho *= 1 / static_cast<float>(textured->second.count);
      }
      std::copy(rho.v.begin(), rho.v.end(), transport.reflectance.begin() + static_cast<std::ptrdiff_t>(c * W));
      if (rho.largest() <= 0) continue;
      const auto points = solution.pointsOf(cell);
      double sum = 0, squares = 0;
      for (std::size_t p = 0; p < points.size(); ++p) {
        std::fill(bySource.begin(), bySource.end(), Spectral::filled(0));
        const Vertex at{points[p].position, this->tracer_.leave(points[p].position, points[p].normal),
                        points[p].normal};
        directAt(at, core::combine(core::combine(directKey, c), p), bySource, rays);
        double all = 0;
        for (std::size_t s = 0; s < sources; ++s) {
          float* direct = transport.direct.data() + (c * sources + s) * W;
          for (int k = 0; k < W; ++k) direct[k] += bySource[s].v[k] / static_cast<float>(points.size());
          all += static_cast<double>(bySource[s].largest());
        }
        sum += all;
        squares += all * all;
      }
      const double n = static_cast<double>(points.size()), mean = sum / n;
      spread[c] = static_cast<float>(std::sqrt(std::max(0.0, squares / n - mean * mean)));
    }
    this->rays_.fetch_add(rays, std::memory_order_relaxed);
  });
  const double allowed = std::clamp(roughSpreadOverAccuracy * accuracy_, leastRoughSpread, roughSpread);
  for (std::uint32_t c = 0; c < cells; ++c) {
    double all = 0;
    for (std::size_t s = 0; s < sources; ++s) {
      const float* direct = transport.direct.data() + (c * sources + s) * W;
      all += static_cast<double>(*std::max_element(direct, direct + W));
    }
    if (static_cast<double>(spread[c]) > allowed * all) solution.setRough(c);
  }
}

template <int W>
void GatherSolver<W>::setResponses() {
  LightSolution& solution = *this->solution_;
  std::vector<Response> all(solution.cellCount(), Response{}), interreflected = all;
  const Spectral white = Spectral::filled(1);
  for (std::uint32_t c = 0; c < all.size(); ++c) {
    this->addCell(all[c], {c, false}, white, 1);
    this->addCell(interreflected[c], {c, true}, white, 1);
  }
  solution.setResponses(std::move(all), std::move(interreflected));
}

template <int W>
Response GatherSolver<W>::missed(const Receiver& receiver, std::uint64_t key, std::uint32_t sample) const {
  std::uint64_t rays = 0;
  Response result{};
  this->addPath(result, receiver, key, sample, Ending::remainder, rays);
  this->rays_.fetch_add(rays, std::memory_order_relaxed);
  return result;
}

template class GatherSolver<1>;
template class GatherSolver<4>;
template class GatherSolver<8>;
template class GatherSolver<16>;
template class GatherSolver<32>;
template class GatherSolver<96>;
template class GatherSolver<480>;

}  // namespace goniolux::solver
