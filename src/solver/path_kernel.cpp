#include "solver/path_kernel.h"

#include <cassert>

#include "solver/path_caustics.h"
#include "solver/path_connections.h"
#include "solver/path_guidance.h"
#include "solver/path_receiver.h"
#include "solver/path_steps.h"
#include "solver/world_extent.h"

namespace goniolux::solver {

namespace {

// With this many lights or fewer, a vertex that the camera sees is connected to each of them.
constexpr std::size_t fewLights = 8;
// What is fainter is not looked for to the last mirror, cd/m2.
constexpr double faintLuminance = 0.01;
// Of an opening's luminance, roughly: narrow beams.
constexpr double peakOverMean = 10;
// From nearer than this number of its edge lengths a cell does not answer.
constexpr double nearCells = 2;
// Indirect paths per sample of a pixel.
constexpr std::uint32_t branches = 4;

}  // namespace

template <int W>
PathSolver<W>::PathSolver(const Problem& problem)
    : world_(problem.world),
      tracer_(problem.tracer),
      freeView_(problem.world),
      pilotRays_(std::clamp(pilotRaysTimesAccuracy / problem.accuracy, 128.0, 4096.0)) {
  const spectrum::SpectralQuadrature& quadrature = problem.quadrature;
  assert(quadrature.wavelengths.size() <= static_cast<std::size_t>(W));
  std::vector<bool> isMirror;
  std::vector<double> largestMirror;  // reflectance, where it is one
  for (const material::Material& material : world_.materials) {
    bsdfs_.push_back(reflection::makeBsdf(material, quadrature));
    hasTextures_ = hasTextures_ || material.texture;
    const reflection::Bsdf& bsdf = *bsdfs_.back();
    isMirror.push_back(bsdf.isSpecular() && bsdf.lobes().mirror);
    Spectral reflectance = Spectral::filled(0);
    if (isMirror.back()) bsdf.mirrorReflectance(1, reflectance.v.data());
    mirrorReflectance_.push_back(reflectance);
    // Panes mirror nearly everything at grazing incidence.
    largestMirror.push_back(!isMirror.back()       ? 0.0
                            : bsdf.lobes().angular ? 1.0
                                                   : static_cast<double>(reflectance.largest()));
    hasPanes_ = hasPanes_ || bsdf.lobes().straight || (bsdf.lobes().mirror && bsdf.lobes().angular);
    if (bsdf.medium() == nullptr) continue;
    hasMedia_ = true;
    disperses_ = disperses_ || bsdf.medium()->disperses;
  }
  std::vector<double> seen(quadrature.wavelengths.size(), 0);
  for (const auto& nodes : quadrature.weights) {
    std::vector<std::array<float, W>> channels(spectrum::responseChannels);
    for (auto& channel : channels) channel.fill(0);
    for (std::size_t k = 0; k < nodes.size(); ++k)
      for (std::size_t c = 0; c < channels.size(); ++c) {
        channels[c][k] = static_cast<float>(nodes[k][c]);
        seen[k] += std::abs(nodes[k][c]);
      }
    weights_.push_back(std::move(channels));
  }
  double total = 0;
  for (const double s : seen) total += s;
  double sum = 0;
  for (const double s : seen) {
    heroProbability_.push_back(total > 0 ? s / total : 1.0 / static_cast<double>(seen.size()));
    heroCumulative_.push_back(sum += heroProbability_.back());
  }
  lights_ = std::make_unique<LightList>(world_, largestMirror);
  lightsAreFew_ = lights_->lights().size() <= fewLights;

  // Emitting triangles stand in World::emitters in the order of the triangles.
  emitterOfTriangle_.assign(world_.triangles.size(), scene::none);
  std::uint32_t emitter = 0;
  for (std::size_t t = 0; t < world_.triangles.size(); ++t) {
    if (!(world_.surfaces[world_.triangleSurfaces[t]].luminance > 0)) continue;
    while (emitter < world_.emitters.size() && world_.emitters[emitter].luminaire != scene::none) ++emitter;
    if (emitter < world_.emitters.size()) emitterOfTriangle_[t] = emitter++;
  }

  findSpots(areaOf(world_));

  for (const scene::Surface& surface : world_.surfaces) brightest_ = std::max(brightest_, surface.luminance);
  for (const scene::LightSource& source : world_.emitters) {
    if (!source.hasGeometry) continue;
    const Vec3 d = source.bounds.extent();
    const double faces = d.x * d.y + d.y * d.z + d.z * d.x;
    brightest_ = std::max(brightest_, peakOverMean * source.emitter->flux() / (core::pi * std::max(faces, 1e-12)));
  }

  findCaustics(quadrature.wavelengths.size(), problem.accuracy);
}

template <int W>
std::vector<std::string> PathSolver<W>::leftOut() const {
  return leftOut_;
}

template <int W>
void PathSolver<W>::add(Response& sum, std::uint32_t spectrum, const Spectral& throughput, double factor) const {
  const auto& channels = weights_[spectrum];
  for (std::size_t c = 0; c < channels.size(); ++c) {
    float dot = 0;
    const float* w = channels[c].data();
    const float* t = throughput.v.data();
#pragma omp simd reduction(+ : dot)
    for (int k = 0; k < W; ++k) dot += w[k] * t[k];
    sum[c] += factor * static_cast<double>(dot);
  }
}

template <int W>
typename PathSolver<W>::Path PathSolver<W>::pathFrom(const Vertex& at, const core::Frame& frame,
                                                     core::Sampler& random) const {
  Path path{at.start, cosineDirection(frame, random.next2()), Spectral::filled(static_cast<float>(core::pi))};
  chooseHero(path, random);
  path.connected = path.isOpen = true;
  path.white = core::pi;
  return path;
}

template <int W>
typename PathSolver<W>::CellAnswer PathSolver<W>::cellAt(const Path& path, const tracer::Hit& hit, const Vertex& at,
                                                         core::Sampler& random) const {
  // A cell stands for a point only from some way off: near by, its mean light is not that of the point.
  if (hit.distance < nearCells * solution_->cellSize()) return {};
  const std::uint32_t cell = solution_->find(hit.surface, at.point, at.normal);
  if (cell == LightSolution::none) return {};
  // One of the cells about the point, by chance: on average the light between cell centres is interpolated.
  const core::Vec2 u = random.next2();
  const Vec3 a = glm::abs(at.normal);
  const int axis = a.x >= a.y && a.x >= a.z ? 0 : a.y >= a.z ? 1 : 2;
  Vec3 beside = at.point;
  beside[(axis + 1) % 3] += (u.x - 0.5) * solution_->cellSize();
  beside[(axis + 2) % 3] += (u.y - 0.5) * solution_->cellSize();
  const std::uint32_t other = solution_->find(hit.surface, beside, at.normal);
  const std::uint32_t answering = other == LightSolution::none ? cell : other;
  return {answering, path.onSpot || solution_->isRough(cell) || solution_->isRough(answering)};
}

template <int W>
void PathSolver<W>::addCell(Response& sum, const CellAnswer& answer, const Spectral& throughput, double factor) const {
  for (std::uint32_t s = 0; s < solution_->sources(); ++s) {
    Spectral light = throughput;
    const float* radiance =
        answer.withoutDirect ? solution_->interreflected(answer.cell, s) : solution_->radiance(answer.cell, s);
#pragma omp simd
    for (int k = 0; k < W; ++k) light.v[k] *= radiance[k];
    add(sum, s, light, factor);
  }
}

template <int W>
void PathSolver<W>::addShared(Response& sum, const Vertex& at, const Meeting& met, const core::Frame& frame,
                              const Vec3& out, const Path& path, double share, core::Sampler& random,
                              std::uint64_t& rays) const {
  if (share == 1) {
    addDirect(sum, at, met, out, {frame}, path, false, random, rays);
    return;
  }
  Path shared = path;
  shared.throughput *= static_cast<float>(share);
  addDirect(sum, at, met, out, {frame}, shared, false, random, rays);
}

template <int W>
void PathSolver<W>::follow(Response& sum, Path& path, Ending ending, core::Sampler& random, std::uint64_t& rays) const {
  Meeting met;
  for (int reflections = 1; reflections <= mostReflections; ++reflections) {
    if (!meet(path, met, rays)) return;
    const double share = directShare(path, met.hit);
    // What lies before the place where the path would have ended is no part of the remainder.
    if (ending != Ending::remainder) addEmitted(sum, path, met.hit);
    if (path.direct != nullptr) addEmitted(*path.direct, path, met.hit);
    const Vertex at = vertexAt(met.hit, path.direction);
    const core::Frame frame = frameAbout(at.normal);
    const Vec3 out = frame.toLocal(-path.direction);
    bool addsDirect = ending != Ending::remainder;
    if (ending != Ending::never && met.bsdf->isLambertian()) {
      if (const CellAnswer answer = cellAt(path, met.hit, at, random); answer.cell != LightSolution::none) {
        if (ending == Ending::solution) {
          if (answer.withoutDirect) addShared(sum, at, met, frame, out, path, share, random, rays);
          if (path.white > 0) {
            const Response& known = answer.withoutDirect ? solution_->interreflectedResponse(answer.cell)
                                                         : solution_->response(answer.cell);
            for (std::size_t c = 0; c < sum.size(); ++c) sum[c] += path.white * known[c];
          } else {
            addCell(sum, answer, path.throughput, 1);
          }
          return;
        }
        addCell(sum, answer, path.throughput, -1);
        // Direct light that the ending path would have got itself is missing in neither.
        addsDirect = !answer.withoutDirect;
        ending = Ending::never;
      }
    }
    if (met.bsdf->lobes().spread) {
      path.direct = nullptr;
      if (hasMedia_ && met.bsdf->medium() != nullptr && met.bsdf->medium()->disperses) collapse(path);
      if (addsDirect) addShared(sum, at, met, frame, out, path, share, random, rays);
      path.share = 1 / static_cast<double>(lights_->lights().size());
    }
    reflection::BsdfSample next;
    Spectral weight = Spectral::filled(0);
    if (!met.bsdf->sample(out, random.next2(), met.interface, next, weight.v.data())) return;
    // No roulette at the first reflection: in room R1 that takes a third less time for the same interval.
    if (!goOn(path, met, at, frame, next, weight, reflections > 1, random)) return;
    if (met.bsdf->isLambertian()) addSpot(sum, path, at, ending, random, rays);
  }
}

template <int W>
Response PathSolver<W>::radiance(const Vec3& eye, const Vec3& view, std::uint64_t key, std::uint32_t sample) const {
  return radianceBy(ending(), eye, view, key, sample);
}

template <int W>
PartedLight PathSolver<W>::partedLight(const Vec3& eye, const Vec3& view, std::uint64_t key,
                                       std::uint32_t sample) const {
  PartedLight light;
  light.whole = radianceBy(ending(), eye, view, key, sample, &light.direct);
  return light;
}

template <int W>
Response PathSolver<W>::radianceBy(Ending ending, const Vec3& eye, const Vec3& view, std::uint64_t key,
                                   std::uint32_t sample, Response* direct) const {
  const bool whole = ending != Ending::remainder;
  Response sum{};
  bool isParted = false;  // what is in the sum before paths branch off is direct light
  std::uint64_t rays = 0;
  core::Sampler random(core::combine(key, lightStream), sample);
  Path path{eye, view, Spectral::filled(1)};
  chooseHero(path, random);
  Meeting met;
  // What the eye sees by itself: emitters, directly, in mirrors and through glass, up to the first matt surface.
  for (int mirrors = 0; mirrors < mostReflections && meet(path, met, rays); ++mirrors) {
    if (whole) addEmitted(sum, path, met.hit);
    const reflection::Bsdf& bsdf = *met.bsdf;
    const Vertex at = vertexAt(met.hit, path.direction);
    const Shading shading = shadingSeen(met, at, -path.direction);
    const core::Frame& frame = shading.frame;
    const Vec3 out = frame.toLocal(-path.direction);
    reflection::BsdfSample next;
    Spectral weight = Spectral::filled(0);
    if (bsdf.isSpecular()) {
      if (!bsdf.sample(out, random.next2(), met.interface, next, weight.v.data())) break;
      // A chain of mirrors is followed as long as something visible may stand at its end: with roulette, a lamp behind
      // ten mirrors of 0.5 would be seen by one sample in a thousand.
      const bool faint = static_cast<double>(path.throughput.largest()) * brightest_ < faintLuminance;
      if (!goOn(path, met, at, frame, next, weight, faint, random)) break;
      continue;
    }
    if (bsdf.largestReflectance() <= 0) break;
    if (hasMedia_ && bsdf.medium() != nullptr && bsdf.medium()->disperses) collapse(path);
    if (whole) addDirect(sum, at, met, out, shading, path, true, random, rays);
    path.share = lightsAreFew_ ? 1 : 1 / static_cast<double>(lights_->lights().size());
    if (direct != nullptr) *direct = sum;
    isParted = true;
    // Several indirect paths from here: the eye's ray and the connections to the lights cost more than one of them.
    for (std::uint32_t branch = 0; branch < branches; ++branch) {
      core::Sampler own(core::combine(key, indirectStream), sample * branches + branch);
      reflection::BsdfSample start;
      if (!bsdf.sample(out, own.next2(), met.interface, start, weight.v.data())) continue;
      if (shading.isTilted) {
        // Nothing comes through the surface itself, whichever way it seems to lean.
        if (start.direction.z * glm::dot(frame.toWorld(start.direction), at.normal) <= 0) continue;
        weight *= static_cast<float>(shading.gain);
      }
      Path indirect = path;
      indirect.throughput *= 1.0f / branches;
      indirect.direct = direct;
      if (!goOn(indirect, met, at, frame, start, weight, false, own)) continue;
      if (bsdf.isLambertian() && !shading.isTilted) addSpot(sum, indirect, at, ending, own, rays);
      follow(sum, indirect, ending, own, rays);
    }
    break;
  }
  if (direct != nullptr && !isParted) *direct = sum;
  rays_.fetch_add(rays, std::memory_order_relaxed);
  return sum;
}

template class PathSolver<1>;
template class PathSolver<4>;
template class PathSolver<8>;
template class PathSolver<16>;
template class PathSolver<32>;
template class PathSolver<96>;
template class PathSolver<480>;

}  // namespace goniolux::solver
