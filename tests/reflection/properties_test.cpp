// What every entry of the registry promises: energy, reciprocity, sampling that agrees with evaluation, no NaN.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "core/random.h"
#include "core/statistics.h"
#include "reflection/cases.h"

namespace goniolux::reflection {
namespace {

using core::Vec3;

Vec3 viewAt(double cosine, double azimuth = 0.4) {
  const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
  return {sine * std::cos(azimuth), sine * std::sin(azimuth), cosine};
}

struct Fixture {
  explicit Fixture(const Case& c) : inside(1, static_cast<float>(c.inside)), outside(1, static_cast<float>(c.outside)) {
    bsdf = findReflectionModel(c.material.model)->make(c.material, oneNode());
    at.indexHere = outside.data();
    at.indexBeyond = inside.data();
  }
  // The same interface, seen from the other side.
  [[nodiscard]] Interface turned() const { return {at.indexBeyond, at.indexHere, at.hero}; }

  std::vector<float> inside, outside;
  std::unique_ptr<Bsdf> bsdf;
  Interface at;
};

const std::vector<double> cosines = {1, 0.95, 0.8, 0.5, 0.3, 0.15, 0.05, 0.01};

// Directional albedo of basic radiance L / n^2 by sampling: the white furnace. `samples`: stratified.
core::ReplicateMean albedo(const Fixture& f, const Vec3& out, std::uint32_t samples) {
  std::vector<double> replicates;
  for (std::uint64_t r = 0; r < 16; ++r) {
    double sum = 0;
    for (std::uint32_t i = 0; i < samples; ++i) {
      core::Sampler random(r, i);
      BsdfSample chosen;
      float weight = 0;
      if (f.bsdf->sample(out, random.next2(), f.at, chosen, &weight)) sum += static_cast<double>(weight) / chosen.scale;
    }
    replicates.push_back(sum / samples);
  }
  return core::replicateMean(replicates);
}

// A case per white finish and a check that the list forgets no model.
TEST(ReflectionModels, EveryModelHasItsCasesHere) {
  std::map<std::string, int> tried;
  for (const Case& c : whiteCases()) ++tried[c.material.model];
  for (const ReflectionModel& model : reflectionModels()) EXPECT_GT(tried[model.name], 0) << model.name;
}

TEST(ReflectionModels, WhiteFurnaceGainsNothingAtAnyAngle) {
  for (const Case& c : whiteCases()) {
    if (!findReflectionModel(c.material.model)->conservesEnergy) continue;
    const Fixture f(c);
    for (const double cosine : cosines) {
      const auto mean = albedo(f, viewAt(cosine), 4096);
      EXPECT_LT(mean.mean, 1 + 1e-3 + 4 * mean.standardError) << c.name << " at cosine " << cosine;
      EXPECT_LT(mean.standardError, 8e-3) << c.name << " at cosine " << cosine;
    }
  }
}

TEST(ReflectionModels, WhiteLambertRoughDiffuseAndGlassLoseNothingEither) {
  for (const Case& c : whiteCases()) {
    const std::string& model = c.material.model;
    if (model != "lambert" && model != "oren-nayar" && model != "dielectric" && model != "mirror" &&
        model != "diffuse-transmission")
      continue;
    const Fixture f(c);
    const double allowed = model == "lambert" ? 1e-4 : 1e-3;
    for (const double cosine : cosines) {
      const auto mean = albedo(f, viewAt(cosine), 2048);
      EXPECT_NEAR(mean.mean, 1, allowed + 4 * mean.standardError) << c.name << " at cosine " << cosine;
    }
  }
}

// Facets that reflect everything: what single scattering loses comes back by the compensating lobe.
TEST(ReflectionModels, RoughMetalThatReflectsEverythingLosesNothing) {
  for (const Case& c : whiteCases()) {
    if (c.name.rfind("white metal", 0) != 0) continue;
    const Fixture f(c);
    for (const double cosine : cosines) {
      const auto mean = albedo(f, viewAt(cosine), 8192);
      EXPECT_GT(mean.mean, 0.99 - 4 * mean.standardError) << c.name << " at cosine " << cosine;
      EXPECT_LT(mean.mean, 1.001 + 4 * mean.standardError) << c.name << " at cosine " << cosine;
      EXPECT_LT(mean.standardError, 1e-3) << c.name << " at cosine " << cosine;
    }
  }
}

TEST(ReflectionModels, ReciprocalModelsAreReciprocal) {
  for (const Case& c : whiteCases()) {
    if (!findReflectionModel(c.material.model)->reciprocal) continue;
    const Fixture f(c);
    for (std::uint32_t i = 0; i < 2000; ++i) {
      core::Sampler random(7, i);
      const Vec3 out = viewAt(std::max(1e-3, random.next()), 2 * core::pi * random.next());
      Vec3 in = viewAt(std::max(1e-3, random.next()), 2 * core::pi * random.next());
      const bool through = f.bsdf->lobes().transmits && i % 2 == 1;
      float there = 0, back = 0;
      if (!through) {
        f.bsdf->evaluate(out, in, f.at, &there);
        f.bsdf->evaluate(in, out, f.at, &back);
        EXPECT_NEAR(there, back, 1e-4f * std::max(1e-3f, std::abs(there))) << c.name;
        continue;
      }
      in.z = -in.z;
      f.bsdf->evaluate(out, in, f.at, &there);
      // Seen from the other side: the frame is turned over (y and z change sign).
      const auto turned = [](const Vec3& v) { return Vec3(v.x, -v.y, -v.z); };
      f.bsdf->evaluate(turned(in), turned(out), f.turned(), &back);
      const double a = static_cast<double>(there) / (c.outside * c.outside),
                   b = static_cast<double>(back) / (c.inside * c.inside);
      EXPECT_NEAR(a, b, 1e-4 * std::max(1e-3, std::abs(a))) << c.name;
    }
  }
}

// Histogram of sampled directions against the integral of density(), over cosine and azimuth, chi-square at 1e-4.
struct ChiSquare {
  double statistic = 0;
  int freedom = 0;
  // Wilson and Hilferty: (X/k)^(1/3) is nearly normal.
  [[nodiscard]] double z() const {
    const double k = freedom;
    return (std::cbrt(statistic / k) - (1 - 2 / (9 * k))) / std::sqrt(2 / (9 * k));
  }
};

// `fine`: steps of the density's integral across a cell; narrow lobes need more.
ChiSquare chiSquare(const Fixture& f, const Vec3& out, int fine = 16, double bias = 0) {
  constexpr int rows = 16, columns = 16, samples = 100000;
  std::vector<double> found(rows * columns, 0), expected(rows * columns, 0);
  double single = 0;
  for (std::uint32_t i = 0; i < samples; ++i) {
    // Independent numbers: the test's variance is that of a multinomial distribution.
    const std::uint64_t a = core::combine(99, i), b = core::mix(a);
    const core::Vec2 u(static_cast<double>(a >> 11) * 0x1p-53, static_cast<double>(b >> 11) * 0x1p-53);
    BsdfSample chosen;
    float weight = 0;
    if (!f.bsdf->sample(out, u, f.at, chosen, &weight)) continue;
    if (chosen.specular) {
      ++single;
      continue;
    }
    Vec3 d = chosen.direction;
    if (bias != 0) d = glm::normalize(d + Vec3(bias, 0, 0));
    const int row = std::clamp(static_cast<int>((d.z + 1) / 2 * rows), 0, rows - 1);
    const int column =
        std::clamp(static_cast<int>((std::atan2(d.y, d.x) / (2 * core::pi) + 0.5) * columns), 0, columns - 1);
    ++found[static_cast<std::size_t>(row * columns + column)];
  }
  for (int row = 0; row < rows * fine; ++row)
    for (int column = 0; column < columns * fine; ++column) {
      const double z = 2 * (row + 0.5) / (rows * fine) - 1,
                   angle = 2 * core::pi * ((column + 0.5) / (columns * fine) - 0.5);
      const double r = std::sqrt(1 - z * z);
      const double area = 4 * core::pi / (rows * fine * columns * fine);
      expected[static_cast<std::size_t>(row / fine * columns + column / fine)] +=
          samples * area * f.bsdf->density(out, {r * std::cos(angle), r * std::sin(angle), z}, f.at);
    }
  ChiSquare result;
  double pooledFound = 0, pooledExpected = 0;
  const auto cell = [&](double o, double e) {
    result.statistic += (o - e) * (o - e) / e;
    ++result.freedom;
  };
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (expected[i] >= 20) {
      cell(found[i], expected[i]);
    } else {
      pooledFound += found[i];
      pooledExpected += expected[i];
    }
  }
  if (pooledExpected >= 20)
    cell(pooledFound, pooledExpected);
  else
    EXPECT_LT(pooledFound, 60) << "directions where the density is 0";
  return result;
}

TEST(ReflectionModels, SamplingAgreesWithItsDensity) {
  for (const Case& c : whiteCases()) {
    const Fixture f(c);
    if (!f.bsdf->lobes().spread) continue;
    for (const double cosine : {0.95, 0.5, 0.2}) {
      const ChiSquare chi = chiSquare(f, viewAt(cosine), c.name.find("0.03") != std::string::npos ? 96 : 16);
      EXPECT_LT(chi.z(), 4.5) << c.name << " at cosine " << cosine << ": chi-square " << chi.statistic << " with "
                              << chi.freedom << " cells";
    }
  }
}

TEST(ReflectionModels, ChiSquareFindsABiasedSampler) {
  const Fixture f(whiteCases().front());
  EXPECT_GT(chiSquare(f, viewAt(0.5), 16, 0.03).z(), 4.5);
}

// The weights are evaluate() |cos| / density.
TEST(ReflectionModels, WeightsAreValueByDensity) {
  for (const Case& c : whiteCases()) {
    const Fixture f(c);
    for (std::uint32_t i = 0; i < 500; ++i) {
      core::Sampler random(17, i);
      const Vec3 out = viewAt(std::max(0.02, random.next()), 6 * random.next());
      BsdfSample chosen;
      float weight = 0, value = 0;
      if (!f.bsdf->sample(out, random.next2(), f.at, chosen, &weight) || chosen.specular) continue;
      f.bsdf->evaluate(out, chosen.direction, f.at, &value);
      const double density = f.bsdf->density(out, chosen.direction, f.at);
      EXPECT_NEAR(density, chosen.density, 1e-6 * density + 1e-12) << c.name;
      const double expected = static_cast<double>(value) * std::abs(chosen.direction.z) / density;
      EXPECT_NEAR(static_cast<double>(weight), expected, 1e-4 * expected + 1e-7) << c.name;
    }
  }
}

TEST(ReflectionModels, GrazingAndNormalDirectionsGiveFiniteNumbers) {
  for (const Case& c : whiteCases()) {
    const Fixture f(c);
    for (const double cosine : {1.0, 1e-3, 1e-6, 1e-9, 0.0}) {
      const Vec3 out = viewAt(cosine);
      for (std::uint32_t i = 0; i < 200; ++i) {
        core::Sampler random(23, i);
        BsdfSample chosen;
        float weight = 0, value = 0;
        if (f.bsdf->sample(out, random.next2(), f.at, chosen, &weight)) {
          ASSERT_TRUE(std::isfinite(weight)) << c.name << " at cosine " << cosine;
          ASSERT_TRUE(std::isfinite(glm::length(chosen.direction))) << c.name;
        }
        f.bsdf->evaluate(out, viewAt(random.next() < 0.5 ? 1e-9 : random.next()), f.at, &value);
        ASSERT_TRUE(std::isfinite(value)) << c.name << " at cosine " << cosine;
      }
    }
  }
}

}  // namespace
}  // namespace goniolux::reflection
