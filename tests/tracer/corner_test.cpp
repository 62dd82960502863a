// Starts of rays in corners, where single precision cannot tell the sides of a wall apart.
#include <gtest/gtest.h>

#include "geometry/objects.h"
#include "scene/world.h"
#include "tracer/tracer.h"

namespace goniolux::tracer {
namespace {

using core::Vec3;

TEST(Corner, PointsAreMovedClearOfOtherWallsAndOthersStay) {
  scene::Environment environment;
  material::Material grey;
  grey.name = "grey", grey.model = "lambert";
  grey.spectra["diffuse"] = spectrum::SpectralDistribution::flat(0.5);
  environment.materials = {grey};
  scene::Object room;
  room.name = "room";
  room.shape = geometry::findObjectType("box")->make({{"min", Vec3(0)}, {"max", Vec3(10)}});
  room.materials.assign(room.shape.partNames.size(), 0);
  room.facesInward = true;
  environment.objects = {room};
  const scene::World world = scene::buildWorld(environment);
  const Tracer tracer(world);
  const double offset = 0.5 * tracer.slack();

  const Vec3 up(0, 0, 1), corner = Vec3(10 - 1e-6, 10 - 1e-6, 1e-6) - world.origin;
  const Vec3 moved = tracer.clearOfCorners(corner, up);
  EXPECT_LT(moved.x, 5 - 1.9 * offset);
  EXPECT_LT(moved.y, 5 - 1.9 * offset);
  EXPECT_GT(moved.x, 5 - 5 * offset);
  EXPECT_DOUBLE_EQ(moved.z, corner.z);
  // Whatever the wall and the corner, the point stays inside.
  for (int face = 0; face < 6; ++face)
    for (int where = 0; where < 4; ++where) {
      const int axis = face / 2;
      Vec3 point(0), normal(0);
      point[axis] = face % 2 == 0 ? -5 + 1e-6 : 5 - 1e-6;
      normal[axis] = face % 2 == 0 ? 1 : -1;
      point[(axis + 1) % 3] = where % 2 == 0 ? -5 + 1e-6 : 5 - 1e-6;
      point[(axis + 2) % 3] = where / 2 == 0 ? -5 + 1e-6 : 5 - 1e-6;
      const Vec3 clear = glm::abs(tracer.clearOfCorners(point, normal));
      for (const int other : {(axis + 1) % 3, (axis + 2) % 3}) {
        EXPECT_LT(clear[other], 5 - 1.9 * offset) << face << " " << where;
        EXPECT_GT(clear[other], 5 - 5 * offset) << face << " " << where;
      }
    }
  const Vec3 open = Vec3(5, 3, 1e-6) - world.origin;
  EXPECT_EQ(tracer.clearOfCorners(open, up), open);
}

}  // namespace
}  // namespace goniolux::tracer
