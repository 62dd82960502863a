// Known answers of diffuse interreflection: in a closed room of uniform reflectance the area mean of the illuminance is
// Phi / (S (1 - rho)), exactly (energy balance).
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>

#include "core/random.h"
#include "core/statistics.h"
#include "geometry/objects.h"
#include "scene/environment.h"
#include "scene/world.h"
#include "solver/solver.h"
#include "tracer/tracer.h"

namespace goniolux::solver {
namespace {

using core::Vec3;

constexpr double roomX = 4, roomY = 3, roomZ = 2.5, flux = 1000;

scene::Environment closedRoom(double rho, emitter::Opening opening) {
  scene::Environment environment;
  material::Material paint;
  paint.name = "paint";
  paint.model = "lambert";
  paint.spectra["diffuse"] = spectrum::SpectralDistribution::flat(rho);
  environment.materials = {paint};
  scene::Object room;
  room.name = "room";
  room.shape = geometry::findObjectType("box")->make({{"min", Vec3(0)}, {"max", Vec3(roomX, roomY, roomZ)}});
  room.materials.assign(room.shape.partNames.size(), 0);
  environment.objects = {room};
  environment.sourceSpectra = {spectrum::SpectralDistribution::flat(1)};
  scene::Luminaire lamp;
  lamp.name = lamp.type = "lamp";
  lamp.center = {1.5, 1.0, 1.6};
  lamp.opening = opening;
  lamp.flux_lm = flux;
  lamp.reflectance = rho;  // the lamp's own body takes part as the walls do
  environment.luminaires = {lamp};
  return environment;
}

// Area mean of the illuminance on the room's six faces by one sample per random point.
// What a solver with a light solution misses is added, path by path: the sum must be unbiased.
core::ReplicateMean meanIlluminance(const scene::Environment& environment, std::uint32_t pointsPerReplicate,
                                    const std::string& solverName = "path") {
  const scene::World world = scene::buildWorld(environment);
  const tracer::Tracer tracer(world);
  const spectrum::SpectralQuadrature quadrature = spectrum::flatQuadrature(world.sourceSpectra);
  const auto solver = findSolverType(solverName)->make({world, tracer, quadrature, 0.02});
  const Vec3 size(roomX, roomY, roomZ);
  const double areas[3] = {roomY * roomZ, roomX * roomZ, roomX * roomY};
  const double total = 2 * (areas[0] + areas[1] + areas[2]);
  std::vector<double> replicates;
  for (std::uint64_t r = 0; r < 16; ++r) {
    double sum = 0;
    for (std::uint32_t i = 0; i < pointsPerReplicate; ++i) {
      core::Sampler random(core::combine(r, 5), i);
      double pick = random.next() * total;
      int face = 0;
      while (face < 5 && pick >= areas[face / 2]) pick -= areas[face++ / 2];
      const core::Vec2 u = random.next2();
      const int axis = face / 2;
      Vec3 point, normal(0);
      point[axis] = face % 2 == 0 ? 1e-6 : size[axis] - 1e-6;
      point[(axis + 1) % 3] = u.x * size[(axis + 1) % 3];
      point[(axis + 2) % 3] = u.y * size[(axis + 2) % 3];
      normal[axis] = face % 2 == 0 ? 1 : -1;
      const Receiver receiver{point - world.origin, normal};
      const auto plan = solver->plan(receiver, core::combine(r * 1000003 + i, 1));
      sum += solver->illuminance(receiver, *plan, core::combine(r * 1000003 + i, 2), 4)[1];
      for (std::uint32_t path = 0; path < 8; ++path)
        sum += solver->missed(receiver, core::combine(r, 3), 8 * i + path)[1] / 8;
    }
    replicates.push_back(sum / pointsPerReplicate);
  }
  return core::replicateMean(replicates);
}

class ClosedRoom : public testing::TestWithParam<double> {};

// |mean - closed form| < 4 standard errors and a standard error below 0.25 % (the catalogue's class T1).
TEST_P(ClosedRoom, PointSourceMeanIsFluxOverAbsorbingArea) {
  const double rho = GetParam();
  const double area = 2 * (roomX * roomY + roomX * roomZ + roomY * roomZ);
  const auto mean = meanIlluminance(closedRoom(rho, {}), 1024);
  const double expected = flux / (area * (1 - rho));
  EXPECT_LT(std::abs(mean.mean - expected), 4 * mean.standardError + 1e-9) << mean.mean << " expected " << expected;
  EXPECT_LT(mean.standardError, 0.0025 * expected * (rho > 0.85 ? 2 : 1));
}

// The solution's cells are coarse (some 400 in this room) and yet nothing is lost: what they miss is in the remainder.
TEST_P(ClosedRoom, GatheringPlusItsRemainderKeepsTheEnergyBalance) {
  const double rho = GetParam();
  const double area = 2 * (roomX * roomY + roomX * roomZ + roomY * roomZ);
  const auto mean = meanIlluminance(closedRoom(rho, {}), 1024, "gather");
  const double expected = flux / (area * (1 - rho));
  EXPECT_LT(std::abs(mean.mean - expected), 4 * mean.standardError + 1e-9) << mean.mean << " expected " << expected;
  EXPECT_LT(mean.standardError, 0.0025 * expected * (rho > 0.85 ? 2 : 1));
}

INSTANTIATE_TEST_SUITE_P(Reflectances, ClosedRoom, testing::Values(0.0, 0.2, 0.5, 0.8, 0.9));

// An opening with a body: its surface reflects like the walls and adds to the absorbing area.
TEST(ClosedRoomWithBodies, SphereTubeAndBoxOpeningsKeepTheEnergyBalance) {
  const double rho = 0.5;
  const double walls = 2 * (roomX * roomY + roomX * roomZ + roomY * roomZ);
  const struct {
    emitter::Opening opening;
    double area;
  } cases[] = {
      {{.shape = emitter::Opening::Shape::sphere, .diameter = 0.3}, core::pi * 0.09},
      {{.shape = emitter::Opening::Shape::box, .length = 0.6, .width = 0.3, .height = 0.2}, 2 * (0.18 + 0.12 + 0.06)},
      {{.shape = emitter::Opening::Shape::tube, .length = 1.2, .diameter = 0.1, .axis = {1, 0, 0}},
       core::pi * 0.1 * 1.2 + 2 * core::pi * 0.0025}};
  for (const auto& c : cases) {
    const auto mean = meanIlluminance(closedRoom(rho, c.opening), 1024);
    // Energy balance: absorbed = (1 - rho) (E_walls S_walls + E_body S_body). E_body differs a little from the mean:
    // within the body's share of the area the answer is bracketed by E_body in [0.5, 1.5] of the indirect mean.
    const double low = flux / ((1 - rho) * (walls + 1.5 * c.area)), high = flux / ((1 - rho) * walls);
    EXPECT_GT(mean.mean, low - 4 * mean.standardError);
    EXPECT_LT(mean.mean, high + 4 * mean.standardError);
    EXPECT_LT(mean.standardError, 0.005 * high);
  }
}

}  // namespace
}  // namespace goniolux::solver
