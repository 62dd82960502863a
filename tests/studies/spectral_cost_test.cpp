// What wavelengths cost: the same rays with nine samples and with three, in interleaved pairs.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/parallel.h"
#include "core/random.h"
#include "pipeline/engine.h"

namespace goniolux::pipeline {
namespace {

std::unique_ptr<Engine> engineFor(const project::Project& project) {
  return std::make_unique<Engine>(project, true);
}

project::Project projectWith(const std::string& scheme) {
  StageRequest request;
  request.inputs = {(std::filesystem::path(GONIOLUX_SOURCE_DIR) / "projects" / "small-office").string()};
  request.common.spectral = scheme;
  return readProjectFor(request, AccuracyOf::both);
}

// CPU time of a small picture, one sample a pixel; the rays traced are the same for every scheme but for the few paths
// that Russian roulette ends.
double cpuOf(const Engine& engine, std::uint64_t key) {
  const double before = core::processCpuSeconds();
  double sum = 0;
  for (int y = 0; y < 36; ++y) {
    for (int x = 0; x < 48; ++x) {
      const core::Vec3 direction = glm::normalize(core::Vec3(1, (x - 24) / 30.0, (18 - y) / 30.0));
      sum += engine.solver->radiance(core::Vec3(0.3, 0.3, 1.6) - engine.world.origin, direction,
                                     core::combine(key, static_cast<std::uint64_t>(y * 48 + x)), 0)[1];
    }
  }
  EXPECT_GT(sum, 0);
  return core::processCpuSeconds() - before;
}

TEST(SpectralCost, NineSamplesCostLittleMoreThanThree) {
  const auto three = projectWith("adapted:3"), nine = projectWith("adapted:9");
  const auto few = engineFor(three), many = engineFor(nine);
  std::vector<double> ratios;
  cpuOf(*few, 0), cpuOf(*many, 0);  // caches
  constexpr int pairs = 21;
  for (std::uint64_t pair = 1; pair <= pairs; ++pair) {
    const bool swapped = pair % 2 == 0;  // neither always goes first
    const double a = cpuOf(swapped ? *many : *few, pair), b = cpuOf(swapped ? *few : *many, pair);
    ratios.push_back(swapped ? a / b : b / a);
  }
  std::sort(ratios.begin(), ratios.end());
  const double raysRatio = static_cast<double>(many->solver->rays()) / static_cast<double>(few->solver->rays());
  std::printf("nine samples against three: CPU time %.3f (quartiles %.3f to %.3f of %d pairs), rays %.4f\n",
              ratios[pairs / 2], ratios[pairs / 4], ratios[3 * pairs / 4], pairs, raysRatio);
  // The paper says 2 %, and 5 % is our aim; a busy machine scatters by more than that. What must not happen is that
  // wavelengths are paid for one by one.
  EXPECT_LE(ratios[pairs / 2], 1.25);
}

}  // namespace
}  // namespace goniolux::pipeline
