// Viewing geometry, and pictures with known answers.
#include <gtest/gtest.h>

#include <cmath>

#include "core/progress.h"
#include "geometry/objects.h"
#include "scene/view.h"
#include "scene/world.h"
#include "solver/solver.h"
#include "viewing/pixel_loop.h"

namespace goniolux::viewing {
namespace {

using core::Vec3;
using scene::View;

View looking(View::Projection projection, double fovDegrees) {
  View view;
  view.name = "test";
  view.eye = {1, 2, 3};
  view.target = {1, 7, 3};
  view.projection = projection;
  view.verticalFov = fovDegrees * core::degree;
  view.width = view.height = 100;
  return view;
}

TEST(View, CentreLooksAtTheTargetAndTheTopAtHalfTheField) {
  const View view = looking(View::Projection::perspective, 60);
  const Vec3 centre = scene::rayThrough(view, 50, 50).direction;
  EXPECT_NEAR(centre.y, 1, 1e-12);
  const Vec3 top = scene::rayThrough(view, 50, 0).direction;
  EXPECT_NEAR(std::asin(top.z) / core::degree, 30, 1e-9);
  const Vec3 right = scene::rayThrough(view, 100, 50).direction;
  EXPECT_GT(right.x, 0);  // looking along +y, right is +x
}

TEST(View, FisheyesFollowTheirProjection) {
  // Equidistant: half the radius is half the angle. Equisolid: r ~ sin(theta / 2).
  const View equidistant = looking(View::Projection::fisheyeEquidistant, 180);
  EXPECT_NEAR(std::acos(scene::rayThrough(equidistant, 75, 50).direction.y) / core::degree, 45, 1e-9);
  const View equisolid = looking(View::Projection::fisheyeEquisolid, 180);
  EXPECT_NEAR(std::acos(scene::rayThrough(equisolid, 75, 50).direction.y) / core::degree,
              2 * std::asin(0.5 * std::sin(45 * core::degree)) / core::degree, 1e-9);
  EXPECT_FALSE(scene::rayThrough(equidistant, 1, 1).inside);
}

// A closed room that emits M and reflects rho everywhere is a furnace: every pixel has luminance M / (pi (1 - rho)).
scene::World furnace() {
  scene::Environment environment;
  material::Material glow;
  glow.name = "glow", glow.model = "lambert";
  glow.spectra["diffuse"] = spectrum::SpectralDistribution::flat(0.5);
  glow.emission = material::Emission{100, spectrum::SpectralDistribution::flat(1)};
  environment.materials = {glow};
  scene::Object room;
  room.shape = geometry::findObjectType("box")->make({{"min", Vec3(0)}, {"max", Vec3(4, 3, 2.5)}});
  room.materials.assign(room.shape.partNames.size(), 0);
  environment.objects = {room};
  return scene::buildWorld(environment);
}

View inTheFurnace() {
  View view;
  view.name = "furnace";
  view.eye = {1, 1, 1};
  view.target = {3, 2, 1.2};
  view.width = 24, view.height = 16;
  return view;
}

TEST(PixelLoop, FurnaceHasTheSameLuminanceEverywhere) {
  const scene::World world = furnace();
  const tracer::Tracer tracer(world);
  const auto quadrature = spectrum::flatQuadrature(world.sourceSpectra);
  const auto solver = solver::findSolverType("path")->make({world, tracer, quadrature});
  const View view = inTheFurnace();
  core::SilentProgress silent;
  const ImageEstimate e = renderView(*solver, view, world.origin, 3, {0.03, 0.95, 0.01, 512}, 1e9, silent);
  const double expected = 100 / (core::pi * 0.5);
  double sum = 0, variance = 0;
  int inside = 0;
  for (std::size_t i = 0; i < e.image.y.size(); ++i) {
    const double y = static_cast<double>(e.image.y[i]), h = static_cast<double>(e.image.halfWidth[i]);
    sum += y / static_cast<double>(e.image.y.size());
    variance += h * h;
    inside += std::abs(y - expected) <= h;
  }
  const double meanHalfWidth = std::sqrt(variance) / static_cast<double>(e.image.y.size());
  EXPECT_NEAR(sum, expected, 2 * meanHalfWidth);
  EXPECT_LT(meanHalfWidth, 0.01 * expected);
  EXPECT_GE(inside, 345);  // of 384 pixels, 95 % = 365 expected; 90 % is 4 standard deviations off
}

// Direct light of the furnace: M / pi by itself and rho M / pi by one reflection; the rest of M / (pi (1 - rho)) by
// more.
TEST(PixelLoop, DirectAndIndirectLightOfAFurnaceAreParted) {
  const scene::World world = furnace();
  const tracer::Tracer tracer(world);
  const auto quadrature = spectrum::flatQuadrature(world.sourceSpectra);
  for (const char* name : {"path", "gather"}) {
    const auto solver = solver::findSolverType(name)->make({world, tracer, quadrature});
    ASSERT_TRUE(solver->partsLight());
    PixelAccuracy accuracy;
    accuracy.relative = 0.03;
    accuracy.parts = true;
    core::SilentProgress silent;
    const ImageEstimate e = renderView(*solver, inTheFurnace(), world.origin, 3, accuracy, 1e9, silent);
    ASSERT_EQ(e.image.layers.size(), 2U);
    const double once = 100 / core::pi;
    const double expected[] = {once * 1.5, once * 0.5};
    for (std::size_t k = 0; k < 2; ++k) {
      const image::Layer& layer = e.image.layers[k];
      double sum = 0, variance = 0;
      const auto count = static_cast<double>(layer.y.size());
      for (std::size_t i = 0; i < layer.y.size(); ++i) {
        sum += static_cast<double>(layer.y[i]) / count;
        variance += std::pow(static_cast<double>(layer.halfWidth[i]), 2);
      }
      const double missed = e.missed * expected[0] * 2;
      EXPECT_NEAR(sum, expected[k], 2 * std::sqrt(variance) / count + missed + 1e-4) << name << " " << layer.name;
    }
    for (std::size_t i = 0; i < e.image.y.size(); ++i)
      EXPECT_NEAR(e.image.layers[0].y[i] + e.image.layers[1].y[i], e.image.y[i], 1e-4F * e.image.y[i]);
  }
}

}  // namespace
}  // namespace goniolux::viewing
