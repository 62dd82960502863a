// Light of small luminaires by curved mirrors and through solid glass: all of it arrives. Closed forms of single places
// are cases 13, 14 and 15 of tests/stability.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>

#include "geometry/objects.h"
#include "geometry/tessellate.h"
#include "scene/world.h"
#include "solver/solver.h"
#include "support/mirror_scenes.h"
#include "tracer/tracer.h"

namespace goniolux::solver {
namespace {

using core::Vec3;

constexpr double side = 2, flux = 1000, ballRadius = 0.3;

material::Material glass() {
  material::Material material;
  material.name = "glass";
  material.model = "dielectric";
  material.spectra["ior"] = spectrum::SpectralDistribution::flat(1.5);
  return material;
}

/// A room of 2 m with a lamp in it and, between lamp and floor, a ball of radius 0.3 m that meets 2.6 % of the light.
struct Room {
  /// `facetsAround`: 0 for an exact ball.
  Room(double reflectance, std::optional<material::Material> ofBall, double lampDiameter, int facetsAround = 0)
      : rho(reflectance) {
    scene::Environment environment;
    environment.sourceSpectra = {spectrum::SpectralDistribution::flat(1)};
    environment.materials = {test::flatFinish("lambert", "diffuse", rho)};
    scene::Object room;
    room.shape = geometry::findObjectType("box")->make({{"min", Vec3(0)}, {"max", Vec3(side)}});
    room.materials.assign(room.shape.partNames.size(), 0);
    environment.objects = {room};
    if (ofBall) {
      environment.materials.push_back(*ofBall);
      scene::Object ball;
      ball.shape = geometry::findObjectType("sphere")->make({{"center", Vec3(1.1, 0.9, 0.8)}, {"radius", ballRadius}});
      if (facetsAround > 0) {
        ball.shape.mesh = geometry::tessellate(ball.shape, facetsAround);
        ball.shape.patches.clear();
      }
      ball.materials.assign(ball.shape.partNames.size(), 1);
      environment.objects.push_back(ball);
    }
    scene::Luminaire lamp;
    lamp.name = lamp.type = "lamp";
    lamp.center = {0.6, 0.8, 1.6};
    if (lampDiameter > 0) lamp.opening = {.shape = emitter::Opening::Shape::sphere, .diameter = lampDiameter};
    lamp.flux_lm = flux;
    environment.luminaires.push_back(lamp);
    world = std::make_unique<scene::World>(scene::buildWorld(environment));
    tracer = std::make_unique<tracer::Tracer>(*world);
    quadrature = spectrum::flatQuadrature(world->sourceSpectra);
    solver = findSolverType("path")->make({*world, *tracer, quadrature});
  }

  /// What the walls absorb, lm, by n x n points on each.
  [[nodiscard]] double absorbed(int n, std::uint32_t samples) const {
    double sum = 0;
    for (int axis = 0; axis < 3; ++axis)
      for (const double wall : {0.0, side})
        for (int i = 0; i < n * n; ++i) {
          Vec3 point, normal(0);
          point[axis] = wall == 0 ? 1e-3 : side - 1e-3;
          point[(axis + 1) % 3] = side * (i % n + 0.5) / n;
          point[(axis + 2) % 3] = side * (i / n + 0.5) / n;
          normal[axis] = wall == 0 ? 1 : -1;
          const Receiver receiver{point - world->origin, normal};
          const auto place = static_cast<std::uint64_t>((axis * 2 + (wall > 0)) * n * n + i);
          const auto plan = solver->plan(receiver, core::combine(1, place));
          sum += solver->illuminance(receiver, *plan, core::combine(2, place), samples)[1];
        }
    return sum * (1 - rho) * side * side / (n * n);
  }

  double rho;
  spectrum::SpectralQuadrature quadrature;
  std::unique_ptr<scene::World> world;
  std::unique_ptr<tracer::Tracer> tracer;
  std::unique_ptr<Solver> solver;
};

const material::Material mirror = test::flatFinish("mirror", "reflectance", 1);

void expectNothingLost(std::optional<material::Material> ofBall, double lampDiameter, double reflectance, int n,
                       std::uint32_t samples, double tolerance) {
  const double without = Room(reflectance, {}, lampDiameter).absorbed(n, samples);
  const double with = Room(reflectance, ofBall, lampDiameter).absorbed(n, samples);
  std::printf("the walls absorb %.2f lm with the ball, %.2f lm without\n", with, without);
  EXPECT_NEAR(with, without, tolerance * without);
}

TEST(Caustics, AMirrorBallTurnsThePointsLightAsideAndLosesNone) {
  expectNothingLost(mirror, 0, 0, 16, 1, 3e-3);
}

// Its caustic is infinitely bright at the edges, and points are few.
TEST(Caustics, AGlassBallGathersThePointsLightAndLosesNone) {
  expectNothingLost(glass(), 0, 0, 20, 1, 5e-3);
}

TEST(Caustics, ALampOf12CentimetresIsServedLikeAPoint) {
  expectNothingLost(mirror, 0.12, 0, 8, 1, 5e-3);
}

// A ball of 20000 facets has as many small images; rays that are farther apart than those would miss some.
TEST(Caustics, AMeshOfManyFacetsIsLeftToPathsAndSaidToBe) {
  const Room fine(0.5, glass(), 0, 100), coarse(0.5, glass(), 0, 8);
  const std::vector<std::string> sentences = fine.solver->leftOut();
  EXPECT_TRUE(std::any_of(sentences.begin(), sentences.end(),
                          [](const std::string& s) { return s.find("facets") != std::string::npos; }));
  EXPECT_TRUE(coarse.solver->leftOut().empty());
  EXPECT_TRUE(Room(0.5, glass(), 0.12, 100).solver->leftOut().empty());
}

TEST(Caustics, WhatTheWallsReflectOnHasTheBallsLightInIt) {
  expectNothingLost(mirror, 0, 0.8, 8, 128, 1e-2);
}

}  // namespace
}  // namespace goniolux::solver
