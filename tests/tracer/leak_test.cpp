// No ray leaves a closed room, near the project's origin or far from it, in millimetres or in hundreds of metres.
#include <gtest/gtest.h>

#include <cmath>

#include "core/random.h"
#include "geometry/objects.h"
#include "scene/world.h"
#include "tracer/tracer.h"

namespace goniolux::tracer {
namespace {

using core::Vec3;

scene::Environment furnishedRoom(double scale, const Vec3& shift) {
  scene::Environment environment;
  material::Material paint;
  paint.name = "paint";
  paint.model = "lambert";
  paint.spectra["diffuse"] = spectrum::SpectralDistribution::flat(0.5);
  environment.materials = {paint};
  const auto box = [&](const Vec3& low, const Vec3& high) {
    scene::Object object;
    object.shape = geometry::findObjectType("box")->make({{"min", low * scale + shift}, {"max", high * scale + shift}});
    object.materials.assign(object.shape.partNames.size(), 0);
    environment.objects.push_back(object);
  };
  box({0, 0, 0}, {6, 4, 3});
  box({3.7, 0.9, 0.72}, {5.3, 1.7, 0.75});
  box({0, 0.6, 0}, {0.4, 1.8, 1.8});
  return environment;
}

struct Place {
  double scale;
  Vec3 shift;
};

class ClosedRoomLeaks : public testing::TestWithParam<Place> {};

TEST_P(ClosedRoomLeaks, NoRayEscapesInAMillionBounces) {
  const auto [scale, shift] = GetParam();
  const scene::World world = scene::buildWorld(furnishedRoom(scale, shift));
  const Tracer tracer(world);
  int escaped = 0;
  for (std::uint32_t path = 0; path < 50000; ++path) {
    core::Sampler random(7, path);
    Vec3 origin = Vec3(3, 3, 2) * scale + shift - world.origin;
    Vec3 normal(0, 0, 1);
    for (int bounce = 0; bounce < 20; ++bounce) {
      const core::Vec2 u = random.next2();
      const double z = 1 - 2 * u.x, r = std::sqrt(std::max(0.0, 1 - z * z)), angle = 2 * core::pi * u.y;
      Vec3 direction(r * std::cos(angle), r * std::sin(angle), z);
      if (bounce > 0 && glm::dot(direction, normal) < 0) direction = -direction;
      Hit hit;
      if (!tracer.intersect(origin, direction, hit)) {
        ++escaped;
        break;
      }
      normal = glm::dot(hit.normal, direction) < 0 ? hit.normal : -hit.normal;
      origin = tracer.leave(hit.position, normal);
    }
  }
  EXPECT_EQ(escaped, 0);
}

INSTANTIATE_TEST_SUITE_P(Scales, ClosedRoomLeaks,
                         testing::Values(Place{1, Vec3(0)}, Place{1, Vec3(1e5, -2e5, 300)}, Place{1e-3, Vec3(0)},
                                         Place{1e3, Vec3(0)}));

TEST(Tracer, SeesWhatIsBetweenTwoPointsAndNothingElse) {
  const scene::World world = scene::buildWorld(furnishedRoom(1, Vec3(0)));
  const Tracer tracer(world);
  const Vec3 underTable = Vec3(4.5, 1.3, 0.4) - world.origin, up(0, 0, 1);
  EXPECT_TRUE(tracer.occluded(underTable, up, 1.0));
  EXPECT_FALSE(tracer.occluded(underTable, up, 0.3));
  EXPECT_FALSE(tracer.occluded(Vec3(2, 3, 0.4) - world.origin, up, 2.5));
  Hit hit;
  ASSERT_TRUE(tracer.intersect(underTable, up, hit));
  EXPECT_NEAR(hit.distance, 0.32, 1e-6);
  EXPECT_NEAR(std::abs(hit.normal.z), 1, 1e-12);
}

}  // namespace
}  // namespace goniolux::tracer
