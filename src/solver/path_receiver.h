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
constexpr double quadratureTolerance = 1e-4;

}  // namespace

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
    const Light& light = lights_->lights()[entry.light];
    if (light.mirrors.empty() && freeView_.isFree(receiver.point, world_.emitters[light.source].bounds, light.source)) {
      entry.fromExact = true;
    } else {
      entry.pilot = static_cast<std::uint32_t>(std::clamp(std::ceil(pilotRays_ * share), 4.0, 0.5 * pilotRays_));
      studyVisibility(entry, at, key, rays);
    }
    if (!entry.fromExact) continue;
    const Response exact = exactResponse(lights_->lights()[entry.light], unoccluded[i].value);
    for (std::size_t c = 0; c < exact.size(); ++c) plan->exact[c] += exact[c];
    plan->quadratureBound += unoccluded[i].bound;
  }

  // Spread of single paths, for sharing effort between paths and shadow rays.
  double sum = 0, squares = 0;
  const std::uint64_t stream = core::combine(key, indirectStream);
  for (std::uint32_t i = 0; i < pilotPaths; ++i) {
    Response arrived{};
    addPath(arrived, at, stream, i, ending(), rays);
    sum += photopic(arrived);
    squares += photopic(arrived) * photopic(arrived);
  }
  const double mean = sum / pilotPaths;
  plan->interreflected = mean;
  plan->indirectSigma = std::sqrt(std::max(0.0, squares / pilotPaths - mean * mean));
  rays_.fetch_add(rays, std::memory_order_relaxed);
  return plan;
}

template <int W>
Response PathSolver<W>::directLight(const Plan& plan, const Vertex& at, std::uint64_t key, std::uint32_t samples,
                                    std::uint64_t& rays) const {
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
      const Response one = connectOnce(entry, at, random.next2(), rays);
      for (std::size_t c = 0; c < sum.size(); ++c) sum[c] += one[c];
    }
    for (std::size_t c = 0; c < sum.size(); ++c) result[c] += sum[c] / count;
  }
  return result;
}

template <int W>
void PathSolver<W>::addPath(Response& sum, const Vertex& at, std::uint64_t stream, std::uint32_t sample, Ending ending,
                            std::uint64_t& rays) const {
  core::Sampler random(stream, sample);
  Path path = pathFrom(at, frameAbout(at.normal), random);
  follow(sum, path, ending, random, rays);
}

template <int W>
Response PathSolver<W>::illuminanceBy(Ending ending, const Receiver& receiver, const ReceiverPlan& plan,
                                      std::uint64_t key, std::uint32_t samples) const {
  const Vertex at{receiver.point, tracer_.leave(receiver.point, receiver.normal), receiver.normal};
  std::uint64_t rays = 0;
  Response result = directLight(static_cast<const Plan&>(plan), at, key, samples, rays);
  const std::uint64_t stream = core::combine(key, indirectStream);
  Response sum{};
  for (std::uint32_t i = 0; i < samples; ++i) addPath(sum, at, stream, i, ending, rays);
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
