// Illuminance from each opening against closed forms and tables computed by another program (the catalogue of
// validation cases, section 2: point, disc, rectangle, sphere, line, tube).
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "core/random.h"
#include "emitter/emitter.h"
#include "emitter/lambertian_forms.h"

namespace goniolux::emitter {
namespace {

using core::Vec2;
using core::Vec3;
using photometry::CosinePowerDistribution;

constexpr Vec3 down{0, 0, -1}, up{0, 0, 1};

Output lambertian(double flux) {
  Output output;
  output.distribution = std::make_shared<CosinePowerDistribution>(1.0, 1.0);
  output.scale = flux / core::pi;
  return output;
}

Output diffuse(double flux) {
  Output output;
  output.flux_lm = flux;
  return output;
}

// Mean of the sampling estimate over a scrambled net.
double sampled(const Emitter& emitter, const Vec3& point, const Vec3& normal, std::uint32_t samples = 1u << 14) {
  double sum = 0;
  for (std::uint32_t i = 0; i < samples; ++i) {
    core::Sampler random(99, i);
    const IncidentLight light = emitter.sample(point, random.next2());
    if (light.normalIlluminance > 0) sum += light.normalIlluminance * std::max(0.0, glm::dot(light.direction, normal));
  }
  return sum / samples;
}

TEST(PointEmitter, FollowsInverseSquareAndCosineLaws) {
  // I0 cos^m, h = 3 m, I0 = 1000 cd: E = I0 cos^(m+3) / h^2
  for (double m : {1.0, 10.0}) {
    Output output;
    output.distribution = std::make_shared<CosinePowerDistribution>(1000.0, m);
    const auto emitter = makeEmitter({}, {0, 0, 3}, output);
    for (double r : {0.0, 1.0, 2.0, 4.0}) {
      const double cosine = 3 / std::hypot(3, r);
      EXPECT_NEAR(emitter->illuminance({r, 0, 0}, up, 0).value, 1000 * std::pow(cosine, m + 3) / 9, 1e-9);
    }
  }
  const auto isotropic = makeEmitter({}, {0, 0, 3}, diffuse(4 * core::pi * 1000));
  EXPECT_NEAR(isotropic->illuminance({4, 0, 0}, up, 0).value, 24.000, 1e-9);
  EXPECT_EQ(isotropic->illuminance({0, 0, 0}, down, 0).value, 0);
}

TEST(RectangleEmitter, MeetsTheClosedFormOverTheWholeFloor) {
  // 1.2 x 0.3 m at 2.2 m, L = 5000 cd/m2
  Opening opening{.shape = Opening::Shape::rectangle, .length = 1.2, .width = 0.3};
  const auto emitter = makeEmitter(opening, {0, 0, 2.2}, lambertian(5000 * core::pi * 0.36));
  const struct {
    double x, y, lx;
  } floor[] = {{0, 0, 353.543}, {.6, 0, 312.647}, {1, 0, 254.546}, {2, 0, 116.373},
               {0, 1, 245.497}, {0, 2, 108.869},  {2, 2, 53.727},  {5, 0, 10.101}};
  for (const auto& c : floor) {
    EXPECT_NEAR(emitter->illuminance({c.x, c.y, 0}, up, 1e-4).value, c.lx, 6e-4);
    EXPECT_NEAR(sampled(*emitter, {c.x, c.y, 0}, up) / c.lx, 1, 1e-3);
  }
  const struct {
    double x, lx;
  } wall[] = {{.3, 48.734}, {.6, 77.957}, {1, 106.759}, {2, 100.230}, {5, 22.590}};
  for (const auto& c : wall) {
    EXPECT_NEAR(emitter->illuminance({c.x, 0, 0}, {-1, 0, 0}, 1e-4).value, c.lx, 6e-4);
    EXPECT_NEAR(sampled(*emitter, {c.x, 0, 0}, {-1, 0, 0}) / c.lx, 1, 2e-3);
  }
}

TEST(TriangleEmitter, SamplesAgreeWithTheClosedFormNearAndFar) {
  const auto triangle = makeTriangleEmitter({0, 0, 1}, {0.7, 0.1, 1.2}, {0.1, 0.5, 0.9}, 1000);
  for (const Vec3& point :
       {Vec3(0.2, 0.2, 0), Vec3(0.25, 0.2, 0.95), Vec3(3, -2, -6), Vec3(0.01, 0.01, 0.9), Vec3(0.3, 0.2, 2)})
    for (const Vec3& normal : {up, Vec3(0.6, 0.8, 0), down}) {
      const double exact = triangle->illuminance(point, normal, 0).value;
      EXPECT_NEAR(sampled(*triangle, point, normal), exact, 3e-3 * exact + 0.2) << point.x << " " << point.z;
    }
}

TEST(DiscEmitter, MeetsTheClosedFormNearAndFar) {
  // radius 0.5, L = 1000; E = (pi L/2)[1 - (r2+d2-a2)/s]
  Opening opening{.shape = Opening::Shape::disc, .diameter = 1.0};
  const auto emitter = makeEmitter(opening, {0, 0, 0}, lambertian(1000 * core::pi * core::pi * 0.25));
  const struct {
    double d, r, lx;
  } facing[] = {{.01, 0, 3140.34}, {.01, .25, 3139.36}, {.01, .5, 1555.09}, {.5, 0, 1570.80}, {.5, .5, 868.315},
                {.5, 2, 12.130},   {1, 1, 206.963},     {5, 0, 31.105},     {5, 2, 23.229}};
  for (const auto& c : facing) {
    EXPECT_NEAR(emitter->illuminance({c.r, 0, -c.d}, up, 1e-5).value / c.lx, 1, 2e-5);
    if (c.d >= 0.5) {
      EXPECT_NEAR(sampled(*emitter, {c.r, 0, -c.d}, up) / c.lx, 1, 3e-3);
    }
  }
  const struct {
    double d, r, lx;
  } sideways[] = {{.01, .5, 1539.62}, {.5, .5, 536.648}, {.5, 1, 268.324}, {1, 2, 64.053}, {5, 2, 9.2122}};
  for (const auto& c : sideways)
    EXPECT_NEAR(emitter->illuminance({c.r, 0, -c.d}, {-1, 0, 0}, 1e-5).value / c.lx, 1, 2e-5) << c.d << " " << c.r;
  // Tilted and cut by the horizon: quadrature against the polygon of 4096 corners would be the same; here against
  // sampling.
  const Vec3 tilted = glm::normalize(Vec3(-1, 0, 0.2));
  EXPECT_NEAR(emitter->illuminance({0.3, 0.1, -0.4}, tilted, 1e-5).value,
              sampled(*emitter, {0.3, 0.1, -0.4}, tilted, 1u << 16), 0.3);
}

TEST(SphereEmitter, IsRightAcrossTheHorizon) {
  // R 0.1, D 1, L 1e4, angle between normal and centre
  Opening opening{.shape = Opening::Shape::sphere, .diameter = 0.2};
  const auto emitter = makeEmitter(opening, {0, 0, 1}, diffuse(1e4 * core::pi * 4 * core::pi * 0.01));
  const struct {
    double deg, lx, tolerance;
  } cases[] = {{0, 314.159, 1e-3}, {60, 157.080, 1e-3}, {84.26, 31.421, 5e-3}, {87, 17.571, 1e-3},
               {90, 6.6868, 1e-4}, {93, 1.1295, 1e-4},  {96, 0, 1e-12}};
  for (const auto& c : cases) {
    const Vec3 normal(std::sin(c.deg * core::degree), 0, std::cos(c.deg * core::degree));
    EXPECT_NEAR(emitter->illuminance({0, 0, 0}, normal, 1e-5).value, c.lx, c.tolerance) << c.deg;
    EXPECT_NEAR(sampled(*emitter, {0, 0, 0}, normal), c.lx, 2e-3 * c.lx + 1e-2);
  }
}

TEST(LineEmitter, MeetsTheClosedForm) {
  // 1.2 m, I' = 1000 cd/m across; plane facing the line at its centre: E = (I'/2d)[a + sin a cos a], tan a = l/2d ...
  // end likewise
  Opening opening{.shape = Opening::Shape::line, .length = 1.2, .axis = {1, 0, 0}};
  const auto emitter = makeEmitter(opening, {0, 0, 0}, diffuse(core::pi * core::pi * 1200));
  const struct {
    double d, lx;
  } centre[] = {{.1, 15678.1}, {.3, 5023.83}, {.6, 2142.33}, {1.2, 719.706}, {2.4, 200.114}, {6, 33.113}};
  for (const auto& c : centre) EXPECT_NEAR(emitter->illuminance({0, 0, -c.d}, up, 1e-5).value / c.lx, 1, 2e-5);
  EXPECT_NEAR(emitter->illuminance({.6, 0, -.1}, up, 1e-5).value, 7852.07, 0.1);
  EXPECT_NEAR(emitter->illuminance({.6, 0, -1.2}, up, 1e-5).value, 535.583, 0.01);
  EXPECT_NEAR(emitter->illuminance({.6, 0, -1.2}, {-1, 0, 0}, 1e-5).value, 208.333, 0.01);
}

TEST(TubeEmitter, MeetsTheTableUnderItsEnd) {
  // T8: R 13 mm, 1.2 m, L 10 000, receiver under one end, h from the axis
  Opening opening{.shape = Opening::Shape::tube, .length = 1.2, .diameter = 0.026, .axis = {1, 0, 0}};
  const auto emitter = makeEmitter(opening, {0, 0, 0}, diffuse(1e4 * core::pi * core::pi * 0.026 * 1.2));
  const struct {
    double h, lx;
  } cases[] = {{.02, 10210.2}, {.05, 4084.01}, {.1, 2041.68}, {.3, 676.880}, {1, 178.357}, {3, 31.519}};
  for (const auto& c : cases) {
    const Illuminance e = emitter->illuminance({.6, 0, -c.h}, up, 1e-5);
    EXPECT_NEAR(e.value / c.lx, 1, 1e-4) << c.h;
    EXPECT_NEAR(sampled(*emitter, {.6, 0, -c.h}, up) / c.lx, 1, 5e-3) << c.h;
  }
}

TEST(EveryOpening, KeepsItsFluxAtAnyDistance) {
  // Flux through a closed sphere about the opening = flux that leaves it. Cosine-weighted illuminance over 40 x 80
  // facing patches.
  const Opening openings[] = {{.shape = Opening::Shape::rectangle, .length = 0.6, .width = 0.3},
                              {.shape = Opening::Shape::disc, .diameter = 0.4},
                              {.shape = Opening::Shape::box, .length = 0.6, .width = 0.3, .height = 0.2},
                              {.shape = Opening::Shape::sphere, .diameter = 0.5},
                              {.shape = Opening::Shape::cylinder, .height = 0.5, .diameter = 0.2},
                              {.shape = Opening::Shape::tube, .length = 0.8, .diameter = 0.026, .axis = {0, 1, 0}},
                              {.shape = Opening::Shape::line, .length = 0.8, .axis = {0, 1, 0}},
                              {.shape = Opening::Shape::point}};
  for (const Opening& opening : openings) {
    for (const bool uniform : {true, false}) {
      Output output = diffuse(1000);
      if (!uniform) {
        output.distribution = std::make_shared<CosinePowerDistribution>(1.0, 3.0);
        output.scale = 1000 / output.distribution->flux();
      }
      const auto emitter = makeEmitter(opening, {0.1, 0.2, 0.3}, output);
      EXPECT_NEAR(emitter->flux(), 1000, 1e-9);
      constexpr int rows = 40, columns = 40;
      const double radius = 1.5;
      double flux = 0;
      for (int i = 0; i < rows; ++i)
        for (int j = 0; j < columns; ++j) {
          const double z = 1 - 2 * (i + 0.5) / rows, phi = 2 * core::pi * (j + 0.5) / columns;
          const Vec3 out(std::sqrt(1 - z * z) * std::cos(phi), std::sqrt(1 - z * z) * std::sin(phi), z);
          flux += emitter->illuminance(Vec3(0.1, 0.2, 0.3) + out * radius, -out, 1e-3).value;
        }
      flux *= 4 * core::pi * radius * radius / (rows * columns);
      EXPECT_NEAR(flux, 1000, 5) << "shape " << static_cast<int>(opening.shape) << " uniform " << uniform;
    }
  }
}

TEST(EveryOpening, SamplingAgreesWithQuadrature) {
  const Opening openings[] = {{.shape = Opening::Shape::rectangle, .length = 0.6, .width = 0.3},
                              {.shape = Opening::Shape::disc, .diameter = 0.4},
                              {.shape = Opening::Shape::box, .length = 0.6, .width = 0.3, .height = 0.2},
                              {.shape = Opening::Shape::sphere, .diameter = 0.5},
                              {.shape = Opening::Shape::cylinder, .height = 0.5, .diameter = 0.2},
                              {.shape = Opening::Shape::tube, .length = 0.8, .diameter = 0.026, .axis = {0, 1, 0}},
                              {.shape = Opening::Shape::line, .length = 0.8, .axis = {0, 1, 0}}};
  for (const Opening& opening : openings)
    for (const Vec3& point : {Vec3(0.2, 0.1, -0.5), Vec3(1, 1, -2), Vec3(0.9, 0, 0.05), Vec3(0.3, 0.7, 0.6)})
      for (const Vec3& normal : {up, Vec3(-1, 0, 0), Vec3(0.6, -0.8, 0)}) {
        Output output;
        output.distribution = std::make_shared<CosinePowerDistribution>(500.0, 2.0);
        output.frame = {{1, 0, 0}, {0, 1, 0}, down};
        const auto emitter = makeEmitter(opening, {0, 0, 0}, output);
        const Illuminance e = emitter->illuminance(point, normal, 1e-4);
        EXPECT_NEAR(sampled(*emitter, point, normal, 1u << 15), e.value, 4e-3 * e.value + 0.05)
            << "shape " << static_cast<int>(opening.shape) << " at " << point.x << "," << point.y << "," << point.z;
        EXPECT_LE(e.bound, 1e-2 * e.value + 1e-6);
        if (e.value > 0) {
          EXPECT_GT(emitter->importance(point, normal), 0);
        }
      }
}

}  // namespace
}  // namespace goniolux::emitter
