// Receivers of the path kernel: what light a point gets straight from the lights, what is known about it without rays,
// and the paths that start there. Definitions of PathSolver's members, part of path_kernel.cpp.
#pragma once

#include "solver/directions.h"
#include "solver/path_kernel.h"

namespace goniolux::solver {

namespace {

// Shadow rays of a receiver's pilot, over all lights, times the accuracy asked for: a light that is blocked by less
// than these can see spoils at most a share of that accuracy.
constexpr double pilotRaysTimesAccuracy = 5.12;
constexpr std::uint32_t pilotPaths = 16;
// Relative; what is left is estimated and stated as "source_subdivision".
constexpr double quadratureTolerance = 3e-4;

/// As Emitter::importance(), for light from any direction.
inline double importanceAllAround(const emitter::Emitter& emitter, const core::Vec3& point) {
  double sum = 0;
  for (int axis = 0; axis < 3; ++axis) {
    core::Vec3 normal(0);
    normal[axis] = 1;
    sum += emitter.importance(point, normal) + emitter.importance(point, -normal);
  }
  return sum;
}

}  // namespace

template <int W>
std::unique_ptr<ReceiverPlan> PathSolver<W>::plan(const Receiver& receiver, std::uint64_t key) const {
  auto plan = std::make_unique<Plan>();
  std::uint64_t rays = 0;

  std::vector<emitter::Illuminance> unoccluded;
  double total = 0;
  for (std::uint32_t i = 0; i < lights_->lights().size(); ++i) {
    const Light& light = lights_->lights()[i];
    if (!receiver.directLight && light.mirrors.empty()) continue;
    const Unfolded seen = lights_->unfold(light, receiver.point, receiver.normal);
    // A body is lit from all around, and has no closed form: its light is sampled.
    const double importance = receiver.isPlane() ? light.emitter->importance(seen.point, seen.normal)
                                                 : importanceAllAround(*light.emitter, seen.point);
    if (importance == 0) continue;
    const emitter::Illuminance e = receiver.isPlane()
                                       ? light.emitter->illuminance(seen.point, seen.normal, quadratureTolerance)
                                       : emitter::Illuminance{importance, 0};
    if (e.value == 0 && e.bound == 0) continue;
    plan->lights.push_back({i, false, 0, 0});
    unoccluded.push_back(e);
    total += e.value;
  }
  for (std::size_t i = 0; i < plan->lights.size(); ++i) {
    LightPlan& entry = plan->lights[i];
    // In proportion to what a light that was wrongly thought to be free could spoil.
    const double share = total > 0 ? unoccluded[i].value / total : 0;
    const Light& light = lights_->lights()[entry.light];
    if (receiver.isPlane() && light.mirrors.empty() &&
        freeView_.isFree(receiver.point, world_.emitters[light.source].bounds, light.source)) {
      entry.fromExact = true;
    } else {
      entry.pilot = static_cast<std::uint32_t>(std::clamp(std::ceil(pilotRays_ * share), 4.0, 0.5 * pilotRays_));
      studyVisibility(entry, receiver, key, rays);
    }
    if (!entry.fromExact) continue;
    const Response exact = exactResponse(lights_->lights()[entry.light], unoccluded[i].value);
    for (std::size_t c = 0; c < exact.size(); ++c) plan->exact[c] += exact[c];
    const Response bound =
        exactResponse(lights_->lights()[entry.light], unoccluded[i].bound + light.rest * unoccluded[i].value);
    for (std::size_t c = 0; c < bound.size(); ++c) plan->quadratureBound[c] += bound[c];
  }

  if (caustics_) planCaustics(*plan, receiver, rays);

  // Spread of single paths, for sharing effort between paths and shadow rays.
  double sum = 0, squares = 0;
  const std::uint64_t stream = core::combine(key, indirectStream);
  for (std::uint32_t i = 0; i < pilotPaths; ++i) {
    Response arrived{};
    addPath(arrived, receiver, stream, i, ending(), rays);
    for (std::size_t c = 0; c < arrived.size(); ++c) plan->interreflected[c] += arrived[c] / pilotPaths;
    sum += photopic(arrived);
    squares += photopic(arrived) * photopic(arrived);
  }
  const double mean = sum / pilotPaths;
  plan->indirectSigma = std::sqrt(std::max(0.0, squares / pilotPaths - mean * mean));
  rays_.fetch_add(rays, std::memory_order_relaxed);
  return plan;
}

template <int W>
Response PathSolver<W>::directLight(const Plan& plan, const Receiver& receiver, std::uint64_t key,
                                    std::uint32_t samples, std::uint64_t& rays) const {
  Response result = plan.exact;
  for (const LightPlan& entry : plan.lights) {
    if (entry.pilot == 0) continue;
    // Shadow rays in proportion to their spread; a path costs some six of them.
    const double share = plan.indirectSigma > 0 ? 2.5 * entry.sigma / plan.indirectSigma : entry.sigma > 0 ? 1.0 : 0.0;
    const double least = std::ceil(entry.pilot / 16.0);
    const auto count =
        static_cast<std::uint32_t>(std::max(least, std::min(std::ceil(samples * share), 16.0 * samples)));
    Response sum{};
    for (std::uint32_t i = 0; i < count; ++i) {
      core::Sampler random(core::combine(core::combine(key, lightStream), entry.light), i);
      const Response one = connectOnce(entry, receiver, random.next2(), rays);
      for (std::size_t c = 0; c < sum.size(); ++c) sum[c] += one[c];
    }
    for (std::size_t c = 0; c < sum.size(); ++c) result[c] += sum[c] / count;
  }
  return result;
}

template <int W>
void PathSolver<W>::addPath(Response& sum, const Receiver& receiver, std::uint64_t stream, std::uint32_t sample,
                            Ending ending, std::uint64_t& rays) const {
  core::Sampler random(stream, sample);
  const Vec3 normal = receiver.isPlane() ? receiver.normal : receiver.surfaceNormal(random.next2());
  const Vertex from = vertexOf(receiver);
  Path path = pathFrom(from, frameAbout(normal), random);
  addSpot(sum, path, {from.point, from.start, normal}, ending, random, rays);
  follow(sum, path, ending, random, rays);
}

template <int W>
Response PathSolver<W>::illuminanceBy(Ending ending, const Receiver& receiver, const ReceiverPlan& plan,
                                      std::uint64_t key, std::uint32_t samples) const {
  std::uint64_t rays = 0;
  Response result = directLight(static_cast<const Plan&>(plan), receiver, key, samples, rays);
  const std::uint64_t stream = core::combine(key, indirectStream);
  Response sum{};
  for (std::uint32_t i = 0; i < samples; ++i) addPath(sum, receiver, stream, i, ending, rays);
  for (std::size_t c = 0; c < sum.size(); ++c) result[c] += sum[c] / samples;
  rays_.fetch_add(rays, std::memory_order_relaxed);
  return result;
}

template <int W>
Response PathSolver<W>::illuminance(const Receiver& receiver, const ReceiverPlan& plan, std::uint64_t key,
                                    std::uint32_t samples) const {
  return illuminanceBy(ending(), receiver, plan, key, samples);
}

template <int W>
Response PathSolver<W>::wholeIlluminance(const Receiver& receiver, const ReceiverPlan& plan, std::uint64_t key,
                                         std::uint32_t samples) const {
  return illuminanceBy(Ending::never, receiver, plan, key, samples);
}

}  // namespace goniolux::solver
