// The unified glare rating of observers: a room calculated by another program, what stands in the way, small sources.
#include "analysis/glare.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>

#include "geometry/objects.h"
#include "scene/world.h"
#include "tracer/tracer.h"

namespace goniolux::analysis {
namespace {

using core::Vec3;

class GlareRoom {
 public:
  /// Ceiling, walls, floor.
  explicit GlareRoom(const Vec3& size, double ceiling = 0.7, double walls = 0.5, double floor = 0.2) {
    for (const double rho : {floor, walls, ceiling}) {
      material::Material paint;
      paint.name = "paint";
      paint.model = "lambert";
      paint.spectra["diffuse"] = spectrum::SpectralDistribution::flat(rho);
      environment_.materials.push_back(paint);
    }
    environment_.sourceSpectra = {spectrum::SpectralDistribution::flat(1)};
    scene::Object room;
    room.name = "room";
    room.shape = geometry::findObjectType("box")->make({{"min", Vec3(0)}, {"max", size}});
    for (const std::string& part : room.shape.partNames)
      room.materials.push_back(part == "floor" ? 0 : part == "ceiling" ? 2 : 1);
    room.facesInward = true;
    environment_.objects = {room};
  }
  void addPanel(const Vec3& center, double lumens, double side = 0.6) {
    scene::Luminaire panel;
    panel.name = panel.type = "panel";
    panel.center = center;
    if (side > 0) panel.opening = {.shape = emitter::Opening::Shape::rectangle, .length = side, .width = side};
    panel.distribution = std::make_shared<photometry::CosinePowerDistribution>(1.0, 1.0);
    panel.scale = lumens / core::pi;
    panel.reflectance = 0.7;
    environment_.luminaires.push_back(panel);
  }
  void addBox(const Vec3& min, const Vec3& max) {
    scene::Object box;
    box.name = "box";
    box.shape = geometry::findObjectType("box")->make({{"min", min}, {"max", max}});
    box.materials.assign(box.shape.partNames.size(), 1);
    environment_.objects.push_back(box);
  }
  [[nodiscard]] GlareEstimate rate(const Vec3& eye, const Vec3& direction, double accuracy = 0.05,
                                   const char* solverName = "gather") const {
    const scene::World world = scene::buildWorld(environment_);
    const tracer::Tracer tracer(world);
    const auto quadrature = spectrum::flatQuadrature(world.sourceSpectra);
    const solver::Problem problem{world, tracer, quadrature, 0.02};
    const auto solver = solver::findSolverType(solverName)->make(problem);
    core::SilentProgress silent;
    return estimateGlare(*solver, solver::SeenLights(problem), eye - world.origin, direction, 11, accuracy, 0.95,
                         std::numeric_limits<double>::infinity(), silent);
  }

 private:
  scene::Environment environment_;
};

// 8 x 16 x 3.2 m, 0.7/0.5/0.2, 32 panels of 1000 lm in the ceiling, the eye 1.2 m high at the middle of a wall: E_ind
// 44.652 lx and UGR 17.32 along the room, 45.121 lx and 16.49 across (within the field of the table).
TEST(Glare, MeetsTheRoomOfAnotherProgram) {
  GlareRoom room({8, 16, 3.2});
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 8; ++j) room.addPanel({1 + 2 * i, 1 + 2 * j, 3.2}, 1000);
  const GlareEstimate along = room.rate({4, 1e-3, 1.2}, {0, 1, 0});
  EXPECT_NEAR(along.ugr.value, 17.32, 0.02 + along.ugr.halfWidth());
  EXPECT_NEAR(core::pi * along.background.value, 44.652, 0.005 * 44.652 + core::pi * along.background.halfWidth());
  EXPECT_TRUE(along.reached);
  const GlareEstimate across = room.rate({1e-3, 8, 1.2}, {1, 0, 0});
  EXPECT_NEAR(across.ugr.value, 16.49, 0.02 + across.ugr.halfWidth());
  // The path solver agrees, light solution or not.
  const GlareEstimate paths = room.rate({4, 1e-3, 1.2}, {0, 1, 0}, 0.1, "path");
  EXPECT_NEAR(paths.ugr.value, along.ugr.value, paths.ugr.halfWidth() + along.ugr.halfWidth());
}

TEST(Glare, CountsWhatTheEyeSeesOnly) {
  GlareRoom room({6, 8, 3});
  room.addPanel({3, 5, 3}, 4000);
  const GlareEstimate open = room.rate({3, 1, 1.2}, {0, 1, 0});
  ASSERT_EQ(open.sources.size(), 1u);
  // A shelf that hides half of the panel takes away half of its solid angle; the luminance stays.
  GlareRoom half = room;
  half.addBox({2.0, 2.9, 1.85}, {3.0, 3.0, 2.4});
  const GlareEstimate behind = half.rate({3, 1, 1.2}, {0, 1, 0});
  ASSERT_EQ(behind.sources.size(), 1u);
  EXPECT_NEAR(behind.sources[0].solidAngle / open.sources[0].solidAngle, 0.5, 0.03);
  EXPECT_NEAR(behind.sources[0].luminance / open.sources[0].luminance, 1, 0.01);
  EXPECT_NEAR(open.sources[0].luminance, 4000 / core::pi / 0.36, 1);
  // Nothing in view: no glare, and that is certain.
  const GlareEstimate away = room.rate({3, 6, 1.2}, {0, 1, 0});
  EXPECT_EQ(away.ugr.value, 0);
  EXPECT_TRUE(away.reached);
}

// A point has no luminance; CIE 147 takes 0.005 m2: UGR = 8 log10(0.25 / L_b * 200 I^2 / (r^2 p^2)).
TEST(Glare, TakesAPointForASmallSource) {
  GlareRoom room({6, 8, 3});
  room.addPanel({3, 5, 2.9}, 1000, 0);
  const Vec3 eye(3, 1, 1.2);
  const GlareEstimate estimate = room.rate(eye, {0, 1, 0});
  ASSERT_EQ(estimate.sources.size(), 1u);
  const Vec3 to = Vec3(3, 5, 2.9) - eye;
  const double r = glm::length(to), intensity = 1000 / core::pi * to.z / r, p = estimate.sources[0].positionIndex;
  const double expected =
      8 * std::log10(0.25 / estimate.background.value * 200 * intensity * intensity / (r * r * p * p));
  EXPECT_NEAR(estimate.ugr.value, expected, 1e-3);
}

TEST(Glare, HasNoValueInABlackRoom) {
  GlareRoom room({6, 8, 3}, 0, 0, 0);
  room.addPanel({3, 5, 3}, 4000);
  const GlareEstimate estimate = room.rate({3, 1, 1.2}, {0, 1, 0});
  EXPECT_TRUE(std::isnan(estimate.ugr.value));
  EXPECT_FALSE(estimate.reached);
}

}  // namespace
}  // namespace goniolux::analysis
