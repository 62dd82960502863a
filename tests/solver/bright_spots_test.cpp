// Bright spots: found where light concentrates, chosen with the density that is said, and of no influence on what is
// expected.
#include "solver/bright_spots.h"

#include <gtest/gtest.h>

#include <cmath>

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

/// Light on a ceiling of 10 x 10 m at z = 3: half of it evenly, half within a strip of 2 x 0.1 m about (1, 2).
std::vector<LandedLight> stripOnACeiling() {
  std::vector<LandedLight> landed;
  for (std::uint32_t i = 0; i < 2048; ++i) {
    core::Sampler random(7, i);
    const core::Vec2 u = random.next2();
    const bool strip = i % 2 == 0;
    const Vec3 place = strip ? Vec3(2 * u.x, 1.95 + 0.1 * u.y, 3) : Vec3(10 * u.x - 5, 10 * u.y - 5, 3);
    landed.push_back({place, {0, 0, -1}, 5, 1.0});
  }
  return landed;
}

TEST(BrightSpots, AStripAmongEvenLightIsFoundWithItsOutline) {
  const BrightSpots spots(stripOnACeiling(), 100);
  ASSERT_FALSE(spots.empty());
  EXPECT_GT(spots.share(), 0.3);
  const BrightSpots::Choice choice = spots.from({1, 2, 0}, {0, 0, 1});
  std::size_t inside = 0;
  constexpr std::uint32_t count = 1000;
  for (std::uint32_t i = 0; i < count; ++i) {
    core::Sampler random(8, i);
    const double u = random.next();
    Vec3 direction;
    std::uint32_t surface = 0;
    ASSERT_TRUE(spots.direction(choice, u, random.next2(), direction, surface));
    EXPECT_EQ(surface, 5u);
    const Vec3 place = choice.origin + direction * (3 / direction.z);
    inside += place.x > -0.1 && place.x < 2.1 && place.y > 1.94 && place.y < 2.06;
  }
  EXPECT_GT(inside, 0.9 * count);
}

TEST(BrightSpots, EvenLightHasNone) {
  std::vector<LandedLight> landed = stripOnACeiling();
  std::erase_if(landed, [](const LandedLight& l) { return std::abs(l.position.y - 2) < 0.06; });
  EXPECT_TRUE(BrightSpots(landed, 100).empty());
  EXPECT_TRUE(BrightSpots({}, 100).empty());
}

// The mean of 1 / density over the choices is the solid angle of what can be chosen: here the whole of one rectangle,
// whose solid angle has a closed form.
TEST(BrightSpots, TheDensityIsThatOfTheChoices) {
  std::vector<LandedLight> landed;
  for (std::uint32_t i = 0; i < 64; ++i) landed.push_back({{(i % 8) / 8.0, (i / 8) / 8.0, 2}, {0, 0, -1}, 0, 1.0});
  const BrightSpots spots(landed, 1000);
  ASSERT_EQ(spots.size(), 1u);
  const Vec3 origin(0.3, -0.4, 0.2);
  const BrightSpots::Choice choice = spots.from(origin, {0, 0, 1});
  double sum = 0;
  Vec3 low(1e9), high(-1e9);
  constexpr std::uint32_t count = 4096;
  for (std::uint32_t i = 0; i < count; ++i) {
    core::Sampler random(9, i);
    Vec3 direction;
    std::uint32_t surface = 0;
    const double u = random.next();
    ASSERT_TRUE(spots.direction(choice, u, random.next2(), direction, surface));
    const double density = spots.density(choice, direction, surface);
    ASSERT_GT(density, 0);
    EXPECT_EQ(spots.density(choice, direction, 1), 0) << "another surface";
    sum += 1 / density / count;
    const Vec3 place = origin + direction * (1.8 / direction.z);
    low = glm::min(low, place);
    high = glm::max(high, place);
  }
  // Rectangle seen from above one corner: atan(ab / (h sqrt(a2 + b2 + h2))); others by sums and differences.
  const auto corner = [&](double x, double y) {
    const double a = x - origin.x, b = y - origin.y, h = 1.8;
    return std::atan(a * b / (h * std::sqrt(a * a + b * b + h * h)));
  };
  const double solidAngle =
      corner(high.x, high.y) - corner(low.x, high.y) - corner(high.x, low.y) + corner(low.x, low.y);
  EXPECT_NEAR(sum / solidAngle, 1, 5e-3);
}

// A narrow beam on the white ceiling of a black room: the pool of 2 cm is all the light there is on the floor,
// E = rho Phi h^2 / (pi (h^2 + r^2)^2). By chance a direction meets it once in 100 000 times.
TEST(BrightSpots, ThePoolOfANarrowBeamLightsTheFloor) {
  scene::Environment environment;
  material::Material white, black;
  white.name = "white", black.name = "black";
  white.model = black.model = "lambert";
  white.spectra["diffuse"] = spectrum::SpectralDistribution::flat(0.8);
  black.spectra["diffuse"] = spectrum::SpectralDistribution::flat(0);
  environment.materials = {white, black};
  const auto place = [&](const char* name, const Vec3& min, const Vec3& max, std::uint32_t material) {
    scene::Object object;
    object.name = name;
    object.shape = geometry::findObjectType("box")->make({{"min", min}, {"max", max}});
    object.materials.assign(object.shape.partNames.size(), material);
    environment.objects.push_back(object);
  };
  place("ceiling", {-6, -6, 5}, {6, 6, 5.1}, 0);
  place("floor", {-6, -6, -0.1}, {6, 6, 0}, 1);
  environment.sourceSpectra = {spectrum::SpectralDistribution::flat(1)};
  scene::Luminaire lamp;
  lamp.name = lamp.type = "spot";
  lamp.center = {0, 0, 4};
  lamp.frame = {{1, 0, 0}, {0, -1, 0}, {0, 0, 1}};
  constexpr double exponent = 10000;  // half of its light within 0.7 degrees
  lamp.distribution =
      std::make_shared<photometry::CosinePowerDistribution>(1000 * (exponent + 1) / (2 * core::pi), exponent);
  lamp.flux_lm = 1000;
  environment.luminaires = {lamp};
  const scene::World world = scene::buildWorld(environment);
  const tracer::Tracer tracer(world);
  const spectrum::SpectralQuadrature quadrature = spectrum::flatQuadrature(world.sourceSpectra);
  for (const char* name : {"path", "gather"}) {
    const auto solver = findSolverType(name)->make({world, tracer, quadrature, 0.02});
    for (const double r : {0.0, 1.0, 4.0}) {
      const Receiver receiver{Vec3(r, 0, 0.001) - world.origin, {0, 0, 1}};
      const auto plan = solver->plan(receiver, 1);
      std::vector<double> replicates;
      for (std::uint64_t k = 0; k < 16; ++k)
        replicates.push_back(solver->wholeIlluminance(receiver, *plan, core::combine(2, k), 64)[1]);
      const core::ReplicateMean mean = core::replicateMean(replicates);
      const double expected = 0.8 * 1000 * 25 / (core::pi * std::pow(25 + r * r, 2));
      EXPECT_NEAR(mean.mean, expected, 4 * mean.standardError + 2e-3 * expected) << name << ", r = " << r;
      EXPECT_LT(mean.standardError, 0.05 * expected) << name << ", r = " << r;
    }
  }
}

}  // namespace
}  // namespace goniolux::solver
