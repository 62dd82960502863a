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

// A panel in front of a perfect mirror in the plane x = 0.
class PanelByMirror {
 public:
  PanelByMirror(const Vec3& center, double slope) : center_(center) {
    material::Material mirror;
    mirror.name = "mirror", mirror.model = "mirror";
    mirror.spectra["reflectance"] = spectrum::SpectralDistribution::flat(1.0);
    environment_.materials = {mirror};
    environment_.sourceSpectra = {spectrum::SpectralDistribution::flat(1)};
    scene::Object wall;
    wall.shape.partNames = {"surface"};
    wall.shape.mesh.vertices = {{0, -slope, -50}, {0, slope, -50}, {0, slope, 50}, {0, -slope, 50}};
    wall.shape.mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    wall.shape.mesh.parts = {0, 0};
    wall.materials = {0};
    environment_.objects = {wall};
    panel_.name = panel_.type = "panel";
    panel_.center = center;
    panel_.opening = {.shape = emitter::Opening::Shape::rectangle, .length = 0.6, .width = 0.6};
    panel_.distribution = std::make_shared<photometry::CosinePowerDistribution>(1.0, 1.0);
    panel_.scale = 1000;
    environment_.luminaires = {panel_};
  }
  [[nodiscard]] double solved(const Vec3& point, std::uint32_t samples) const {
    const scene::World world = scene::buildWorld(environment_);
    const tracer::Tracer tracer(world);
    const auto quadrature = spectrum::flatQuadrature(world.sourceSpectra);
    const auto solver = findSolverType("path")->make({world, tracer, quadrature});
    const Receiver receiver{point - world.origin, {0, 0, 1}};
    return solver->illuminance(receiver, *solver->plan(receiver, 1), 2, samples)[1];
  }
  /// The panel and its image, nothing between.
  [[nodiscard]] double closedForm(const Vec3& point) const {
    emitter::Output output;
    output.distribution = panel_.distribution;
    output.scale = 1000;
    double sum = 0;
    for (const Vec3& place : {center_, Vec3(-center_.x, center_.y, center_.z)})
      sum += emitter::makeEmitter(panel_.opening, place, output)->illuminance(point, {0, 0, 1}, 1e-6).value;
    return sum;
  }

 private:
  Vec3 center_;
  scene::Environment environment_;
  scene::Luminaire panel_;
};

// An area source shows itself to paths as well: what images find must not be counted twice.
TEST(PlaneMirror, CountsAnAreaSourceOnce) {
  const PanelByMirror scene({1, 0, 3}, 50);
  const double expected = scene.closedForm({0.5, 0, 0});
  EXPECT_NEAR(scene.solved({0.5, 0, 0}, 64), expected, 1e-5 * expected);
}

// Light that comes to the mirror and from it at a grazing angle to the panel is not lost: a target that is missed by
// the offset of the ray's start lies behind the panel.
TEST(PlaneMirror, LosesNothingOfAPanelSeenAtAGrazingAngle) {
  for (const double distance : {2.0, 5.9, 20.0, 200.0}) {
    const PanelByMirror scene({1, 0, 2.199}, 50 + distance);
    const double expected = scene.closedForm({distance, 0.9, 0});
    EXPECT_NEAR(scene.solved({distance, 0.9, 0}, 64), expected, 1e-5 * expected) << distance;
  }
}

}  // namespace
}  // namespace goniolux::solver
