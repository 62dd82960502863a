// Light by plane mirrors against the unfolded closed form (the catalogue of validation cases, 4.10).
#include <gtest/gtest.h>

#include <memory>

#include "geometry/objects.h"
#include "scene/world.h"
#include "solver/solver.h"
#include "tracer/tracer.h"

namespace goniolux::solver {
namespace {

using core::Vec3;

class MirrorScene {
 public:
  explicit MirrorScene(double rho) {
    material::Material mirror;
    mirror.name = "mirror";
    mirror.model = "mirror";
    mirror.spectra["reflectance"] = spectrum::SpectralDistribution::flat(rho);
    environment_.materials = {mirror};
    environment_.sourceSpectra = {spectrum::SpectralDistribution::flat(1)};
  }
  void addMirror(const Vec3& origin, const Vec3& u, const Vec3& v) {
    scene::Object wall;
    wall.shape.partNames = {"surface"};
    wall.shape.mesh.vertices = {origin, origin + u, origin + u + v, origin + v};
    wall.shape.mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    wall.shape.mesh.parts = {0, 0};
    wall.materials = {0};
    environment_.objects.push_back(wall);
  }
  void addPoint(const Vec3& center, double candela) {
    scene::Luminaire lamp;
    lamp.name = lamp.type = "lamp";
    lamp.center = center;
    lamp.flux_lm = 4 * core::pi * candela;
    environment_.luminaires.push_back(lamp);
  }
  double floorIlluminance(double x) const {
    const scene::World world = scene::buildWorld(environment_);
    const tracer::Tracer tracer(world);
    const auto quadrature = spectrum::flatQuadrature(world.sourceSpectra);
    const auto solver = findSolverType("path")->make({world, tracer, quadrature});
    const Receiver receiver{Vec3(x, 0, 0) - world.origin, {0, 0, 1}};
    const auto plan = solver->plan(receiver, 1);
    return solver->illuminance(receiver, *plan, 2, 16)[1];
  }

 private:
  scene::Environment environment_;
};

TEST(PlaneMirror, AddsTheImageSourceWhereTheMirrorShowsIt) {
  // Mirror x = 0, 0.5 to 1.5 m high; 1000 cd at (1, 2 m high); rho 0.9.
  MirrorScene scene(0.9);
  scene.addMirror({0, -50, 0.5}, {0, 100, 0}, {0, 0, 1});
  scene.addPoint({1, 0, 2}, 1000);
  const struct {
    double x, lx;
  } cases[] = {{.5, 343.469}, {1, 329.550}, {2, 217.288}, {4, 42.669}};
  for (const auto& c : cases) EXPECT_NEAR(scene.floorIlluminance(c.x), c.lx, 2e-5 * c.lx) << c.x;
}

TEST(PlaneMirror, TwoFacingMirrorsAddTheirSeriesOfImages) {
  // Mirrors 2 m apart, source 0.7 m from one at height 2, receiver at 1.2; rho 0.88: 439.649 lx with 7 reflections,
  // 440.657 with all.
  MirrorScene scene(0.88);
  scene.addMirror({0, -200, -1}, {0, 400, 0}, {0, 0, 400});
  scene.addMirror({2, -200, -1}, {0, 400, 0}, {0, 0, 400});
  scene.addPoint({0.7, 0, 2}, 1000);
  const double e = scene.floorIlluminance(1.2);
  EXPECT_GT(e, 439.649);
  EXPECT_LT(e, 440.657);
}

// An area source shows itself to paths as well: what images find must not be counted twice.
TEST(PlaneMirror, CountsAnAreaSourceOnce) {
  scene::Environment environment;
  material::Material mirror, black;
  mirror.name = "mirror", mirror.model = "mirror";
  mirror.spectra["reflectance"] = spectrum::SpectralDistribution::flat(1.0);
  environment.materials = {mirror};
  environment.sourceSpectra = {spectrum::SpectralDistribution::flat(1)};
  scene::Object wall;
  wall.shape.partNames = {"surface"};
  wall.shape.mesh.vertices = {{0, -50, -50}, {0, 50, -50}, {0, 50, 50}, {0, -50, 50}};
  wall.shape.mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  wall.shape.mesh.parts = {0, 0};
  wall.materials = {0};
  environment.objects = {wall};
  scene::Luminaire panel;
  panel.name = panel.type = "panel";
  panel.center = {1, 0, 3};
  panel.opening = {.shape = emitter::Opening::Shape::rectangle, .length = 0.6, .width = 0.6};
  panel.distribution = std::make_shared<photometry::CosinePowerDistribution>(1.0, 1.0);
  panel.scale = 1000;
  environment.luminaires = {panel};
  const scene::World world = scene::buildWorld(environment);
  const tracer::Tracer tracer(world);
  const auto quadrature = spectrum::flatQuadrature(world.sourceSpectra);
  const auto solver = findSolverType("path")->make({world, tracer, quadrature});
  // A perfect mirror at x = 0: the panel at x = 1 and its image at x = -1, both seen from (0.5, 0, 0).
  const Receiver receiver{Vec3(0.5, 0, 0) - world.origin, {0, 0, 1}};
  emitter::Output output;
  output.distribution = panel.distribution;
  output.scale = 1000;
  const auto real = emitter::makeEmitter(panel.opening, {1, 0, 3}, output),
             image = emitter::makeEmitter(panel.opening, {-1, 0, 3}, output);
  const double expected =
      real->illuminance({0.5, 0, 0}, {0, 0, 1}, 1e-6).value + image->illuminance({0.5, 0, 0}, {0, 0, 1}, 1e-6).value;
  const auto plan = solver->plan(receiver, 1);
  EXPECT_NEAR(solver->illuminance(receiver, *plan, 2, 64)[1], expected, 1e-5 * expected);
}

}  // namespace
}  // namespace goniolux::solver
