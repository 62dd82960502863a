// Elliptical and upright openings: flux kept, sampling and quadrature of one mind, and the round case as the limit.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "core/random.h"
#include "emitter/emitter.h"
#include "emitter/near_field.h"

namespace goniolux::emitter {
namespace {

using core::Vec3;
using Shape = Opening::Shape;
using Along = Opening::Along;

const photometry::LuminaireFrame frame{{1, 0, 0}, {0, 1, 0}, {0, 0, -1}};

Output output(bool uniform) {
  Output out;
  out.frame = frame;
  if (uniform) {
    out.flux_lm = 1000;
  } else {
    out.distribution = std::make_shared<photometry::CosinePowerDistribution>(1.0, 2.0);
    out.scale = 1000 / out.distribution->flux();
  }
  return out;
}

std::vector<Opening> openings() {
  std::vector<Opening> list;
  for (const Along along : {Along::aim, Along::c0, Along::c90}) {
    list.push_back({.shape = Shape::rectangle, .length = 0.6, .width = 0.3, .along = along});
    list.push_back({.shape = Shape::disc, .length = 0.6, .width = 0.3, .along = along});
    list.push_back({.shape = Shape::cylinder, .length = 0.3, .width = 0.2, .height = 0.7, .along = along});
    list.push_back({.shape = Shape::cylinder, .height = 0.7, .diameter = 0.2, .along = along});
  }
  list.push_back({.shape = Shape::box, .length = 0.6, .width = 0.3, .height = 0.2});
  // With its back, or a side and an end, against surfaces.
  list.push_back({.shape = Shape::box, .length = 0.6, .width = 0.3, .height = 0.2, .covered = 1u << 5});
  list.push_back({.shape = Shape::box, .length = 0.6, .width = 0.3, .height = 0.2, .covered = 1u << 0 | 1u << 3});
  list.push_back({.shape = Shape::cylinder, .height = 0.2, .diameter = 0.6, .covered = 1u << 5});
  list.push_back({.shape = Shape::sphere, .length = 0.6, .width = 0.3, .height = 0.2});
  // A drop, and a cylinder with its caps.
  list.push_back(
      {.shape = Shape::revolution, .profile = convexProfile({{0, -0.2}, {0.15, -0.1}, {0.2, 0.05}, {0, 0.3}})});
  list.push_back(
      {.shape = Shape::revolution, .profile = convexProfile({{0, -0.1}, {0.1, -0.1}, {0.1, 0.1}, {0, 0.1}})});
  return list;
}

double sampled(const Emitter& emitter, const Vec3& point, const Vec3& normal) {
  constexpr std::uint32_t samples = 1u << 15;
  double sum = 0;
  for (std::uint32_t i = 0; i < samples; ++i) {
    core::Sampler random(7, i);
    const IncidentLight light = emitter.sample(point, random.next2());
    if (light.normalIlluminance > 0) sum += light.normalIlluminance * std::max(0.0, glm::dot(light.direction, normal));
  }
  return sum / samples;
}

TEST(EveryStatedOpening, KeepsItsFluxAndSamplesAsItIntegrates) {
  for (const Opening& opening : openings())
    for (const bool uniform : {true, false}) {
      SCOPED_TRACE(testing::Message() << "shape " << static_cast<int>(opening.shape) << " along "
                                      << static_cast<int>(opening.along) << " uniform " << uniform);
      const auto emitter = makeEmitter(opening, {0.1, 0.2, 0.3}, output(uniform));
      constexpr int rows = 32, columns = 32;
      const double radius = 2;
      double flux = 0;
      for (int i = 0; i < rows; ++i)
        for (int j = 0; j < columns; ++j) {
          const double z = 1 - 2 * (i + 0.5) / rows, phi = 2 * core::pi * (j + 0.5) / columns;
          const Vec3 out(std::sqrt(1 - z * z) * std::cos(phi), std::sqrt(1 - z * z) * std::sin(phi), z);
          flux += emitter->illuminance(Vec3(0.1, 0.2, 0.3) + out * radius, -out, 1e-3).value;
        }
      flux *= 4 * core::pi * radius * radius / (rows * columns);
      EXPECT_NEAR(flux, 1000, 6);
      for (const Vec3& at : {Vec3(0.3, 0.3, -0.6), Vec3(1.2, 0.9, -1.5), Vec3(0.9, 0.1, 0.9)})
        for (const Vec3& normal : {Vec3(0, 0, 1), Vec3(-0.6, -0.8, 0)}) {
          const Illuminance e = emitter->illuminance(at, normal, 1e-4);
          EXPECT_NEAR(sampled(*emitter, at, normal), e.value, 8e-3 * e.value + 0.2) << at.x << " " << at.z;
        }
    }
}

// From anywhere: within rounding of the opening, in its plane and on its axes too.
TEST(EveryStatedOpening, IsSampledInFiniteNumbersFromEverywhere) {
  for (const Opening& opening : openings()) {
    SCOPED_TRACE(testing::Message() << "shape " << static_cast<int>(opening.shape) << " along "
                                    << static_cast<int>(opening.along));
    const Vec3 center(0.1, 0.2, 0.3);
    const auto emitter = makeEmitter(opening, center, output(false));
    for (std::uint32_t i = 0; i < 20000; ++i) {
      core::Sampler random(13, i);
      const core::Vec2 a = random.next2(), b = random.next2(), c = random.next2();
      // A place of the opening's box, often a round one, moved away by 1e-16 to 1 m.
      Vec3 place = 0.7 * Vec3(a.x, a.y, b.x) - Vec3(0.35);
      if (i % 2 == 0) place = glm::round(place * 20.0) / 20.0;
      const double z = 2 * b.y - 1, phi = 2 * core::pi * c.x, distance = std::pow(10.0, -16 * c.y);
      Vec3 away(std::sqrt(1 - z * z) * std::cos(phi), std::sqrt(1 - z * z) * std::sin(phi), z);
      if (i % 3 == 0) away = Vec3(0), away[static_cast<int>(i / 3 % 3)] = 1;
      const Vec3 point = center + place + away * distance;
      const IncidentLight light = emitter->sample(point, random.next2());
      ASSERT_TRUE(std::isfinite(light.normalIlluminance))
          << place.x << ' ' << place.y << ' ' << place.z << " + " << distance;
      ASSERT_TRUE(std::isfinite(emitter->importance(point, away)));
      if (light.normalIlluminance > 0) {
        ASSERT_NEAR(glm::length(light.direction), 1, 1e-9);
      }
    }
  }
}

// On a ceiling beside a batten a few samples must not carry all of the light.
TEST(LongOpenings, AreSampledEvenlyFromMillimetresAway) {
  const std::vector<Opening> battens{{.shape = Shape::box, .length = 1.2, .width = 0.06, .height = 0.05},
                                     {.shape = Shape::rectangle, .length = 1.2, .width = 0.06},
                                     {.shape = Shape::tube, .length = 1.2, .diameter = 0.026, .axis = {1, 0, 0}}};
  for (const Opening& opening : battens) {
    const auto emitter = makeEmitter(opening, Vec3(0), output(true));
    for (const Vec3& point : {Vec3(0.1, 0, 0.03), Vec3(0.59, 0, 0.03), Vec3(0.3, 0.035, 0.001),
                              Vec3(0.603, 0.002, 0.02), Vec3(0.5, 0.2, 0.03), Vec3(0.62, 0.04, 0.03)}) {
      constexpr std::uint32_t samples = 4096;
      double sum = 0, squares = 0;
      for (std::uint32_t i = 0; i < samples; ++i) {
        core::Sampler random(11, i);
        const double light = emitter->sample(point, random.next2()).normalIlluminance;
        sum += light;
        squares += light * light;
      }
      const double mean = sum / samples;
      EXPECT_LT(squares / samples, 2.5 * mean * mean)
          << "shape " << static_cast<int>(opening.shape) << " from " << point.x << ' ' << point.y << ' ' << point.z;
    }
  }
}

TEST(EllipticalOpenings, OfEqualDiametersAreTheRoundOnes) {
  // The last bit of inequality selects the elliptical code.
  const double almost = 0.4 * (1 + 1e-12);
  for (const bool uniform : {true, false}) {
    const auto check = [&](const Opening& round, const Opening& elliptic) {
      const auto a = makeEmitter(round, Vec3(0), output(uniform)), b = makeEmitter(elliptic, Vec3(0), output(uniform));
      for (const Vec3& at : {Vec3(0.1, 0.3, -0.5), Vec3(1, -0.4, -2)})
        EXPECT_NEAR(b->illuminance(at, {0, 0, 1}, 1e-5).value / a->illuminance(at, {0, 0, 1}, 1e-5).value, 1, 3e-4);
    };
    check({.shape = Shape::disc, .diameter = 0.4}, {.shape = Shape::disc, .length = almost, .width = 0.4});
    check({.shape = Shape::sphere, .diameter = 0.4},
          {.shape = Shape::sphere, .length = almost, .width = 0.4, .height = 0.4});
    check({.shape = Shape::cylinder, .height = 0.3, .diameter = 0.4},
          {.shape = Shape::cylinder, .length = almost, .width = 0.4, .height = 0.3});
  }
}

TEST(SurfaceOfRevolution, OfACirclesProfileIsTheSphere) {
  std::vector<core::Vec2> circle;
  constexpr int segments = 180;
  for (int i = 0; i <= segments; ++i) {
    const double angle = core::pi * i / segments;
    circle.emplace_back(i == 0 || i == segments ? 0 : 0.2 * std::sin(angle), -0.2 * std::cos(angle));
  }
  const Opening turned{.shape = Shape::revolution, .profile = convexProfile(circle)};
  ASSERT_FALSE(turned.profile.empty());
  const Opening sphere{.shape = Shape::sphere, .diameter = 0.4};
  for (const bool uniform : {true, false}) {
    const auto a = makeEmitter(sphere, {0, 0, 1}, output(uniform)), b = makeEmitter(turned, {0, 0, 1}, output(uniform));
    for (const Vec3& at : {Vec3(0.1, 0.3, 0.5), Vec3(1, -0.4, -2), Vec3(0.5, 0.1, 1.05)})
      for (const Vec3& normal : {Vec3(0, 0, 1), Vec3(-0.6, -0.8, 0)}) {
        const double exact = a->illuminance(at, normal, 1e-5).value;
        EXPECT_NEAR(b->illuminance(at, normal, 1e-5).value, exact, 1e-3 * exact + 1e-3) << at.x << " " << uniform;
      }
  }
}

TEST(SurfaceOfRevolution, MustBeConvex) {
  EXPECT_TRUE(convexProfile({{1, 0}, {0.2, 0.5}, {1, 1}}).empty());         // waisted
  EXPECT_TRUE(convexProfile({{0.1, 0}, {0.3, -0.1}, {0.3, 0.2}}).empty());  // a rim turned down
  EXPECT_TRUE(convexProfile({{0.3, 0}, {0.2, 0.4}}).empty());  // open: nothing of it is seen from straight above
  const auto up = convexProfile({{0, 0}, {0.2, 0.1}, {0, 0.4}}), down = convexProfile({{0, 0.4}, {0.2, 0.1}, {0, 0}});
  ASSERT_EQ(up.size(), 3u);
  EXPECT_EQ(up, down);  // the outside is on the right of the way that is kept
}

// The five-times rule in figures (validation cases, 2.7): error of one point at q largest dimensions.
TEST(FiveTimesRule, IsAOnePerCentRuleForADiscAndMoreForBeams) {
  Output cosine = output(false);
  cosine.distribution = std::make_shared<photometry::CosinePowerDistribution>(100.0, 1.0);
  cosine.scale = 1;
  const Opening disc{.shape = Shape::disc, .diameter = 0.5},
      square{.shape = Shape::rectangle, .length = 0.5, .width = 0.5};
  const auto percent = [](const Opening& opening, const Output& out, double q, int n = 1) {
    return 100 * *cutError(opening, out, q * 0.5, n);
  };
  EXPECT_NEAR(percent(disc, cosine, 5), 1.00, 0.01);
  EXPECT_NEAR(percent(disc, cosine, 1), 25, 0.01);
  EXPECT_NEAR(percent(square, cosine, 5), 1.33, 0.01);
  EXPECT_NEAR(percent(square, cosine, 2, 2), 1.84, 0.01);
  EXPECT_NEAR(percent(square, cosine, 1, 4), 1.21, 0.01);
  Output beam = cosine;
  beam.distribution = std::make_shared<photometry::CosinePowerDistribution>(100.0, 10.0);
  EXPECT_NEAR(percent(disc, beam, 5), 3.27, 0.02);
  beam.distribution = std::make_shared<photometry::CosinePowerDistribution>(100.0, 100.0);
  EXPECT_NEAR(percent(disc, beam, 5), 27.9, 0.1);
  EXPECT_NEAR(*pointModelFrom(disc, cosine, 0.01) / 0.5, 5.01, 0.3);
  EXPECT_FALSE(pointModelFrom({}, cosine, 0.01));
}

}  // namespace
}  // namespace goniolux::emitter
