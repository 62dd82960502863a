// The quantities of the registry against closed forms (the catalogue of validation cases, 2.8): a point source at an
// elevation and an azimuth, a uniform surround, and a lamp's melanopic ratio.
#include "analysis/quantity.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "analysis/grid_estimate.h"
#include "core/statistics.h"
#include "geometry/objects.h"
#include "scene/world.h"
#include "solver/solver.h"
#include "spectrum/cie_data.h"
#include "tracer/tracer.h"

namespace goniolux::analysis {
namespace {

using core::Vec3;

material::Material paint(double rho) {
  material::Material material;
  material.name = "paint";
  material.model = "lambert";
  material.spectra["diffuse"] = spectrum::SpectralDistribution::flat(rho);
  return material;
}

scene::Object boxRoom(const Vec3& size) {
  scene::Object room;
  room.name = "room";
  room.shape = geometry::findObjectType("box")->make({{"min", Vec3(0)}, {"max", size}});
  room.materials.assign(room.shape.partNames.size(), 0);
  room.facesInward = true;
  return room;
}

class Meter {
 public:
  explicit Meter(const scene::Environment& environment, const char* solver = "path")
      : world_(scene::buildWorld(environment)),
        tracer_(world_),
        quadrature_(spectrum::flatQuadrature(world_.sourceSpectra)),
        solver_(solver::findSolverType(solver)->make({world_, tracer_, quadrature_, 0.01})) {}

  [[nodiscard]] double measured(const std::string& name, const Vec3& point, const Vec3& normal,
                                std::uint32_t samples = 1024, std::uint64_t key = 2) const {
    const Quantity& quantity = *findQuantity(name);
    const solver::Receiver receiver{point - world_.origin, normal, quantity.body};
    const auto plan = solver_->plan(receiver, 1);
    return quantity.factor * solver_->wholeIlluminance(receiver, *plan, key, samples)[quantity.channel];
  }

 private:
  scene::World world_;
  tracer::Tracer tracer_;
  spectrum::SpectralQuadrature quadrature_;
  std::unique_ptr<solver::Solver> solver_;
};

// 250 lx on a plane that faces the source, from elevation e and azimuth a off the direction that a half cylinder faces.
double fromPointSource(const std::string& name, double elevation, double azimuth, const Vec3& normal) {
  scene::Environment environment;
  environment.materials = {paint(0)};
  environment.sourceSpectra = {spectrum::SpectralDistribution::flat(1)};
  environment.objects = {boxRoom({20, 20, 20})};
  const double e = elevation * core::degree, a = azimuth * core::degree;
  const Vec3 eye(10, 10, 10);
  scene::Luminaire lamp;
  lamp.name = lamp.type = "lamp";
  lamp.center = eye + 2.0 * Vec3(std::cos(e) * std::cos(a), std::cos(e) * std::sin(a), std::sin(e));
  lamp.flux_lm = 4 * core::pi * 1000;
  environment.luminaires = {lamp};
  return Meter(environment).measured(name, eye, normal);
}

TEST(Quantity, FollowsItsClosedFormUnderAPointSource) {
  const Vec3 up(0, 0, 1), ahead(1, 0, 0);
  EXPECT_NEAR(fromPointSource("cylindrical", 0, 20, up), 79.577, 1e-3);
  EXPECT_NEAR(fromPointSource("cylindrical", 30, 200, up), 68.916, 1e-3);
  EXPECT_NEAR(fromPointSource("cylindrical", -60, 77, up), 39.789, 1e-3);
  EXPECT_NEAR(fromPointSource("semi-cylindrical", 30, 60, ahead), 103.374, 1e-3);
  EXPECT_NEAR(fromPointSource("semi-cylindrical", 30, 180, ahead), 0, 1e-3);
  EXPECT_NEAR(fromPointSource("hemispherical", 30, 45, up), 250 * 1.5 / 4, 1e-3);
  EXPECT_NEAR(fromPointSource("hemispherical", -30, 45, up), 250 * 0.5 / 4, 1e-3);
  EXPECT_NEAR(fromPointSource("spherical", -75, 10, up), 62.5, 1e-3);
}

// In a room whose walls all have the same luminance L every quantity is pi L, whatever the body.
TEST(Quantity, IsPiTimesTheLuminanceOfAUniformSurround) {
  scene::Environment environment;
  environment.sourceSpectra = {spectrum::SpectralDistribution::flat(1)};
  environment.materials = {paint(0.5)};
  environment.materials[0].emission = material::Emission{100, spectrum::SpectralDistribution::flat(1)};
  environment.objects = {boxRoom({3, 4, 2.5})};
  // Emitted 100 and reflected on: exitance 100 / (1 - 0.5), which is the illuminance as well.
  for (const char* solver : {"path", "gather"}) {
    const Meter meter(environment, solver);
    for (const Quantity& quantity : quantities()) {
      if (quantity.channel != 1) continue;
      std::vector<double> replicates;
      for (std::uint64_t key = 1; key <= 16; ++key)
        replicates.push_back(meter.measured(quantity.name, {1, 1.5, 1}, {1, 0, 0}, 256, key));
      const core::ReplicateMean mean = core::replicateMean(replicates);
      EXPECT_NEAR(mean.mean, 200, 3.5 * mean.standardError) << quantity.name << " by " << solver;
      EXPECT_LT(mean.standardError, 2) << quantity.name << " by " << solver;
    }
  }
}

TEST(Quantity, MelanopicEquivalentDaylightIlluminanceIsTheIlluminanceUnderDaylight) {
  scene::Environment environment;
  environment.materials = {paint(0.5)};
  environment.sourceSpectra = {*spectrum::illuminant("CIE D65")};
  environment.objects = {boxRoom({3, 4, 2.5})};
  scene::Luminaire lamp;
  lamp.name = lamp.type = "lamp";
  lamp.center = {1, 1, 2};
  lamp.flux_lm = 1000;
  environment.luminaires = {lamp};
  const Meter meter(environment);
  const double lx = meter.measured("illuminance", {2, 3, 1}, {0, 0, 1});
  EXPECT_NEAR(meter.measured("melanopic-edi", {2, 3, 1}, {0, 0, 1}) / lx, 1, 2e-3);
}

// A normal chosen evenly over the body makes the planar answer the body's: the two ways in which light is counted.
TEST(Quantity, BodysNormalsGiveItsResponse) {
  constexpr std::uint32_t count = 1u << 14;
  for (const auto body : {solver::ReceiverBody::cylinder, solver::ReceiverBody::halfCylinder,
                          solver::ReceiverBody::hemisphere, solver::ReceiverBody::sphere}) {
    solver::Receiver receiver{Vec3(0), {1, 0, 0}, body};
    for (const Vec3 light : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(-1, 0, 0), Vec3(0, 0, 1), Vec3(0.6, 0.64, -0.48)}) {
      double sum = 0;
      for (std::uint32_t i = 0; i < count; ++i) {
        core::Sampler random(7, i);
        sum += std::max(0.0, glm::dot(receiver.surfaceNormal(random.next2()), light)) / count;
      }
      EXPECT_NEAR(sum, receiver.response(light), 2e-4) << static_cast<int>(body) << " " << light.x << " " << light.y;
    }
  }
}

}  // namespace
}  // namespace goniolux::analysis
