#include "solver/path_kernel.h"

#include <cassert>

namespace goniolux::solver {

namespace {

// With this many lights or fewer, a vertex that the camera sees is connected to each of them.
constexpr std::size_t fewLights = 8;
// Shadow rays of a receiver's pilot, over all lights: a light that is blocked by less than these can see spoils at most
// a few tenths of a percent.
constexpr double pilotRays = 512;
constexpr std::uint32_t pilotPaths = 16;
constexpr double quadratureTolerance = 1e-4;
// Indirect paths per sample of a pixel.
constexpr std::uint32_t branches = 4;
// Far beyond what Russian roulette lets live; guards against mirrors of reflectance 1.
constexpr int mostReflections = 10000;

// Keys of the independent random streams of one estimate.
constexpr std::uint64_t indirectStream = 0x1d1, lightStream = 0x119;

double photopic(const Response& r) {
  return r[1];
}

core::Frame frameAbout(const core::Vec3& normal) {
  core::Frame frame;
  frame.z = normal;
  core::perpendiculars(normal, frame.x, frame.y);
  return frame;
}

core::Vec3 cosineDirection(const core::Frame& frame, const core::Vec2& u) {
  const double r = std::sqrt(u.x), angle = 2 * core::pi * u.y;
  return frame.toWorld({r * std::cos(angle), r * std::sin(angle), std::sqrt(std::max(0.0, 1 - u.x))});
}

}  // namespace

template <int W>
PathSolver<W>::PathSolver(const Problem& problem) : world_(problem.world), tracer_(problem.tracer) {
  const spectrum::SpectralQuadrature& quadrature = problem.quadrature;
  assert(quadrature.wavelengths.size() <= static_cast<std::size_t>(W));
  std::vector<bool> isMirror;
  for (const material::Material& material : world_.materials) {
    const reflection::ReflectionModel* model = reflection::findReflectionModel(material.model);
    assert(model != nullptr);  // the project reader refuses unknown models
    bsdfs_.push_back(model->make(material, quadrature));
    isMirror.push_back(bsdfs_.back()->isSpecular());
    Spectral reflectance = Spectral::filled(0);
    reflection::BsdfSample ignored;
    if (bsdfs_.back()->isSpecular()) bsdfs_.back()->sample({0, 0, 1}, {0, 0}, ignored, reflectance.v.data());
    mirrorReflectance_.push_back(reflectance);
  }
  for (const auto& nodes : quadrature.weights) {
    std::vector<std::array<float, W>> channels(spectrum::responseChannels);
    for (auto& channel : channels) channel.fill(0);
    for (std::size_t k = 0; k < nodes.size(); ++k)
      for (std::size_t c = 0; c < channels.size(); ++c) channels[c][k] = static_cast<float>(nodes[k][c]);
    weights_.push_back(std::move(channels));
  }
  lights_ = std::make_unique<LightList>(world_, isMirror);
  lightsAreFew_ = lights_->lights().size() <= fewLights;

  // Points and lines have no geometry that a ray could hit: their light by mirrors is found through plane images only.
  bool invisible = false, curvedMirror = false;
  for (const scene::LightSource& source : world_.emitters) invisible = invisible || !source.hasGeometry;
  for (const scene::PlacedPatch& patch : world_.patches)
    curvedMirror = curvedMirror || isMirror[world_.surfaces[patch.surface].material];
  losesCaustics_ = invisible && (curvedMirror || !lights_->planes().empty());
}

template <int W>
std::vector<std::string> PathSolver<W>::leftOut() const {
  if (!losesCaustics_) return {};
  return {"light of point and line luminaires that arrives by curved mirrors, or by more than " +
          std::to_string(lights_->imageDepth()) + " plane mirrors in a row"};
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
bool PathSolver<W>::connected(const Light& light, const Vertex& from, const Vec3& unfoldedDirection, double distance,
                              Spectral& filter, std::uint64_t& rays) const {
  Vec3 point = from.point, origin = from.start;
  Vec3 direction = lights_->fold(light, unfoldedDirection);
  for (const std::uint32_t plane : light.mirrors) {
    tracer::Hit hit;
    ++rays;
    if (!tracer_.intersect(origin, direction, hit) || hit.distance >= distance) return false;
    if (lights_->planeOf(hit.primitive) != plane) return false;
    filter *= mirrorReflectance_[world_.surfaces[hit.surface].material];
    distance -= hit.distance;
    const Vec3 facing = glm::dot(hit.normal, direction) < 0 ? hit.normal : -hit.normal;
    direction = lights_->planes()[plane].reflectDirection(direction);
    point = hit.position;
    origin = tracer_.leave(hit.position, facing);
  }
  ++rays;
  // From where the ray really starts to the very point of the emitter: moved sideways instead, rays to the rim of a
  // sphere or a tube would meet its near side (found against Radiance in the gallery: 0.4 % of the light).
  const Vec3 toTarget = point + direction * distance - origin;
  const double length = glm::length(toTarget);
  if (!(length > tracer_.slack())) return true;
  return !tracer_.occluded(origin, toTarget / length, length * (1 - 1e-5) - tracer_.slack());
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
Response PathSolver<W>::connectOnce(const LightPlan& plan, const Vertex& at, const core::Vec2& u,
                                    std::uint64_t& rays) const {
  const Light& light = lights_->lights()[plan.light];
  const Unfolded seen = lights_->unfold(light, at.point, at.normal);
  const emitter::IncidentLight incident = light.emitter->sample(seen.point, u);
  Response result{};
  const double cosine = glm::dot(incident.direction, seen.normal);
  if (incident.normalIlluminance <= 0 || cosine <= 0) return result;
  Spectral filter = Spectral::filled(1);
  const bool visible = connected(light, at, incident.direction, incident.distance, filter, rays);
  const double value = incident.normalIlluminance * cosine;
  if (!plan.fromExact) {
    if (visible) add(result, light.spectrum, filter, value);
  } else if (!visible) {
    const Response lost = exactResponse(light, value);
    for (std::size_t c = 0; c < result.size(); ++c) result[c] = -lost[c];
  }
  return result;
}

template <int W>
void PathSolver<W>::studyVisibility(LightPlan& entry, const Vertex& at, std::uint64_t key, std::uint64_t& rays) const {
  const Light& light = lights_->lights()[entry.light];
  const Unfolded seen = lights_->unfold(light, at.point, at.normal);
  double sum = 0, visibleSum = 0, squares = 0, visibleSquares = 0;
  for (std::uint32_t i = 0; i < entry.pilot; ++i) {
    core::Sampler random(core::combine(core::combine(key, lightStream), entry.light), i);
    const emitter::IncidentLight incident = light.emitter->sample(seen.point, random.next2());
    const double value =
        std::max(0.0, incident.normalIlluminance) * std::max(0.0, glm::dot(incident.direction, seen.normal));
    sum += value;
    squares += value * value;
    Spectral filter = Spectral::filled(1);
    if (value > 0 && connected(light, at, incident.direction, incident.distance, filter, rays)) {
      visibleSum += value;
      visibleSquares += value * value;
    }
  }
  const double n = entry.pilot;
  entry.fromExact = visibleSum >= 0.5 * sum && sum > 0;
  const double mean = (entry.fromExact ? sum - visibleSum : visibleSum) / n;
  entry.sigma =
      std::sqrt(std::max(0.0, (entry.fromExact ? squares - visibleSquares : visibleSquares) / n - mean * mean));
}

template <int W>
std::unique_ptr<ReceiverPlan> PathSolver<W>::plan(const Receiver& receiver, std::uint64_t key) const {
  auto plan = std::make_unique<Plan>();
  const Vertex at{receiver.point, tracer_.leave(receiver.point, receiver.normal), receiver.normal};
  std::uint64_t rays = 0;

  std::vector<emitter::Illuminance> unoccluded;
  double total = 0;
  for (std::uint32_t i = 0; i < lights_->lights().size(); ++i) {
    const Light& light = lights_->lights()[i];
    const Unfolded seen = lights_->unfold(light, receiver.point, receiver.normal);
    if (light.emitter->importance(seen.point, seen.normal) == 0) continue;
    const emitter::Illuminance e = light.emitter->illuminance(seen.point, seen.normal, quadratureTolerance);
    if (e.value == 0 && e.bound == 0) continue;
    plan->lights.push_back({i, false, 0, 0});
    unoccluded.push_back(e);
    total += e.value;
  }
  for (std::size_t i = 0; i < plan->lights.size(); ++i) {
    LightPlan& entry = plan->lights[i];
    // In proportion to what a light that was wrongly thought to be free could spoil.
    const double share = total > 0 ? unoccluded[i].value / total : 0;
    entry.pilot = static_cast<std::uint32_t>(std::clamp(std::ceil(pilotRays * share), 4.0, 256.0));
    studyVisibility(entry, at, key, rays);
    if (!entry.fromExact) continue;
    const Response exact = exactResponse(lights_->lights()[entry.light], unoccluded[i].value);
    for (std::size_t c = 0; c < exact.size(); ++c) plan->exact[c] += exact[c];
    plan->quadratureBound += unoccluded[i].bound;
  }

  // Spread of single paths, for sharing effort between paths and shadow rays.
  const core::Frame frame = frameAbout(receiver.normal);
  double sum = 0, squares = 0;
  for (std::uint32_t i = 0; i < pilotPaths; ++i) {
    core::Sampler random(core::combine(key, indirectStream), i);
    Response arrived{};
    follow(arrived, at.start, cosineDirection(frame, random.next2()), Spectral::filled(static_cast<float>(core::pi)),
           random, rays);
    sum += photopic(arrived);
    squares += photopic(arrived) * photopic(arrived);
  }
  const double mean = sum / pilotPaths;
  plan->indirectSigma = std::sqrt(std::max(0.0, squares / pilotPaths - mean * mean));
  rays_.fetch_add(rays, std::memory_order_relaxed);
  return plan;
}

template <int W>
Response PathSolver<W>::illuminance(const Receiver& receiver, const ReceiverPlan& generalPlan, std::uint64_t key,
                                    std::uint32_t samples) const {
  const auto& plan = static_cast<const Plan&>(generalPlan);
  const Vertex at{receiver.point, tracer_.leave(receiver.point, receiver.normal), receiver.normal};
  std::uint64_t rays = 0;
  Response result = plan.exact;

  for (const LightPlan& entry : plan.lights) {
    // Shadow rays in proportion to their spread; a path costs some six of them.
    const double share = plan.indirectSigma > 0 ? 2.5 * entry.sigma / plan.indirectSigma : entry.sigma > 0 ? 1.0 : 0.0;
    const double least = std::ceil(entry.pilot / 16.0);
    const auto count =
        static_cast<std::uint32_t>(std::max(least, std::min(std::ceil(samples * share), 16.0 * samples)));
    Response sum{};
    for (std::uint32_t i = 0; i < count; ++i) {
      core::Sampler random(core::combine(core::combine(key, lightStream), entry.light), i);
      const Response one = connectOnce(entry, at, random.next2(), rays);
      for (std::size_t c = 0; c < sum.size(); ++c) sum[c] += one[c];
    }
    for (std::size_t c = 0; c < sum.size(); ++c) result[c] += sum[c] / count;
  }

  const core::Frame frame = frameAbout(receiver.normal);
  Response sum{};
  const std::uint64_t stream = core::combine(key, indirectStream);
  for (std::uint32_t i = 0; i < samples; ++i) {
    core::Sampler random(stream, i);
    follow(sum, at.start, cosineDirection(frame, random.next2()), Spectral::filled(static_cast<float>(core::pi)),
           random, rays);
  }
  for (std::size_t c = 0; c < sum.size(); ++c) result[c] += sum[c] / samples;
  rays_.fetch_add(rays, std::memory_order_relaxed);
  return result;
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
typename PathSolver<W>::Vertex PathSolver<W>::vertexAt(const tracer::Hit& hit, const Vec3& direction) const {
  const Vec3 normal = glm::dot(hit.normal, direction) < 0 ? hit.normal : -hit.normal;
  return {hit.position, tracer_.leave(hit.position, normal), normal};
}

template <int W>
void PathSolver<W>::addDirect(Response& sum, const Vertex& at, const reflection::Bsdf& bsdf, const Vec3& out,
                              const core::Frame& frame, const Spectral& throughput, bool everyLight,
                              core::Sampler& random, std::uint64_t& rays) const {
  const auto connect = [&](std::uint32_t index, double weight) {
    const Light& light = lights_->lights()[index];
    const Unfolded seen = lights_->unfold(light, at.point, at.normal);
    const emitter::IncidentLight incident = light.emitter->sample(seen.point, random.next2());
    const double cosine = glm::dot(incident.direction, seen.normal);
    if (incident.normalIlluminance <= 0 || cosine <= 0) return;
    Spectral filter = throughput;
    if (!connected(light, at, incident.direction, incident.distance, filter, rays)) return;
    Spectral f = Spectral::filled(0);
    bsdf.evaluate(out, frame.toLocal(lights_->fold(light, incident.direction)), f.v.data());
    f *= filter;
    add(sum, light.spectrum, f, incident.normalIlluminance * cosine * weight);
  };
  if (everyLight && lightsAreFew_) {
    for (std::uint32_t i = 0; i < lights_->lights().size(); ++i) connect(i, 1);
    return;
  }
  std::uint32_t chosen = 0;
  double probability = 0;
  if (lights_->choose(at.point, at.normal, random.next(), chosen, probability)) connect(chosen, 1 / probability);
}

template <int W>
void PathSolver<W>::follow(Response& sum, Vec3 origin, Vec3 direction, Spectral throughput, core::Sampler& random,
                           std::uint64_t& rays) const {
  // Mirrors met since the last point that was connected to the lights, and whether image lights have found what they
  // show.
  int mirrors = 0, reflections = 0;
  bool byImages = true;
  while (reflections < mostReflections) {
    tracer::Hit hit;
    ++rays;
    if (!tracer_.intersect(origin, direction, hit)) return;
    const bool alreadyCounted = byImages && mirrors <= lights_->imageDepth();
    std::uint32_t spectrum = 0;
    if (!alreadyCounted)
      if (const double luminance = emittedLuminance(hit, -direction, spectrum); luminance > 0)
        add(sum, spectrum, throughput, luminance);

    const reflection::Bsdf& bsdf = *bsdfs_[world_.surfaces[hit.surface].material];
    const Vertex at = vertexAt(hit, direction);
    const core::Frame frame = frameAbout(at.normal);
    const Vec3 out = frame.toLocal(-direction);

    if (!bsdf.isSpecular()) {
      addDirect(sum, at, bsdf, out, frame, throughput, false, random, rays);
      mirrors = 0;
      byImages = true;
    } else {
      ++mirrors;
      byImages = byImages && lights_->planeOf(hit.primitive) != scene::none;
    }

    reflection::BsdfSample next;
    Spectral weight = Spectral::filled(0);
    if (!bsdf.sample(out, random.next2(), next, weight.v.data())) return;
    // Russian roulette on this reflection's largest weight: throughput stays near 1, long paths end as light is
    // absorbed. Not at the first reflection: in room R1 that takes a third less time for the same interval.
    const float survive = ++reflections == 1 ? 1.0f : std::min(1.0f, weight.largest());
    if (survive <= 0 || random.next() >= static_cast<double>(survive)) return;
    throughput *= weight;
    throughput *= 1 / survive;
    direction = frame.toWorld(next.direction);
    origin = at.start;
  }
}

template <int W>
Response PathSolver<W>::radiance(const Vec3& eye, const Vec3& view, std::uint64_t key, std::uint32_t sample) const {
  Response sum{};
  std::uint64_t rays = 0;
  core::Sampler random(core::combine(key, lightStream), sample);
  Vec3 origin = eye, direction = view;
  Spectral throughput = Spectral::filled(1);
  // What the eye sees by itself: emitters, directly and in mirrors, up to the first matt surface.
  for (int mirrors = 0; mirrors < mostReflections; ++mirrors) {
    tracer::Hit hit;
    ++rays;
    if (!tracer_.intersect(origin, direction, hit)) break;
    std::uint32_t spectrum = 0;
    if (const double luminance = emittedLuminance(hit, -direction, spectrum); luminance > 0)
      add(sum, spectrum, throughput, luminance);
    const reflection::Bsdf& bsdf = *bsdfs_[world_.surfaces[hit.surface].material];
    const Vertex at = vertexAt(hit, direction);
    const core::Frame frame = frameAbout(at.normal);
    const Vec3 out = frame.toLocal(-direction);
    reflection::BsdfSample next;
    Spectral weight = Spectral::filled(0);
    if (bsdf.isSpecular()) {
      if (!bsdf.sample(out, random.next2(), next, weight.v.data())) break;
      const float survive = std::min(1.0f, weight.largest());
      if (survive <= 0 || random.next() >= static_cast<double>(survive)) break;
      throughput *= weight;
      throughput *= 1 / survive;
      direction = frame.toWorld(next.direction);
      origin = at.start;
      continue;
    }
    if (bsdf.largestReflectance() <= 0) break;
    addDirect(sum, at, bsdf, out, frame, throughput, true, random, rays);
    // Several indirect paths from here: the eye's ray and the connections to the lights cost more than one of them.
    for (std::uint32_t branch = 0; branch < branches; ++branch) {
      core::Sampler own(core::combine(key, indirectStream), sample * branches + branch);
      if (!bsdf.sample(out, own.next2(), next, weight.v.data())) continue;
      Spectral carried = throughput;
      carried *= weight;
      carried *= 1.0f / branches;
      follow(sum, at.start, frame.toWorld(next.direction), carried, own, rays);
    }
    break;
  }
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
