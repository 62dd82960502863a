// Groups: objects placed together, in arrays and in groups of groups.
#include "geometry/bounds.h"
#include "geometry/queries.h"
#include "project/project_fixture.h"

namespace goniolux::project {
namespace {

using core::Vec3;

class Groups : public test::ProjectFixture {
 protected:
  static std::string room(const std::string& objects) {
    const std::string after = "\"material\": \"grey\" }";
    return changed(after, after + ", " + objects);
  }
};

const std::string chair =
    "{ \"name\": \"chair\", \"shape\": \"group\", \"objects\": [ { \"name\": \"seat\", \"shape\": \"box\", \"min\": "
    "[0,0,0.4], "
    "\"max\": [0.4,0.4,0.45], \"material\": \"grey\" }, { \"name\": \"leg\", \"shape\": \"cylinder\", \"base\": "
    "[0.05,0.05,0], \"height\": 0.4, \"radius\": 0.02, \"material\": \"grey\", \"array\": { \"counts\": [2,2], \"u\": "
    "[0.3,0,0], \"v\": [0,0.3,0] } } ]";

TEST_F(Groups, PlaceTheirObjectsAfterTheirOwnTransforms) {
  const Project project =
      read(room(chair + ", \"transform\": [ { \"rotate\": { \"axis\": [0,0,1], \"degrees\": 90 } }, { "
                        "\"translate\": [2,1,0] } ] }"));
  const auto& objects = project.environment.objects;
  ASSERT_EQ(objects.size(), 1U + 1 + 4);
  EXPECT_EQ(objects[1].name, "chair/seat");
  EXPECT_EQ(objects[3].name, "chair/leg[1,0]");
  const geometry::Bounds seat = geometry::bounds(objects[1].shape, objects[1].transform);
  EXPECT_NEAR(seat.min.x, 1.6, 1e-12) << "turned, then moved";
  EXPECT_NEAR(seat.max.y, 1.4, 1e-12);
  const geometry::Bounds leg = geometry::bounds(objects[3].shape, objects[3].transform);
  EXPECT_NEAR(leg.center().x, 2 - 0.05, 1e-9);
  EXPECT_NEAR(leg.center().y, 1 + 0.35, 1e-9);
}

TEST_F(Groups, InArraysAndInGroupsAreNamedByTheWayToThem) {
  const Project project =
      read(room("{ \"name\": \"row\", \"shape\": \"group\", \"array\": { \"counts\": [3,1], \"u\": [1,0,0] }, "
                "\"objects\": [ " +
                chair + " } ] }"));
  const auto& objects = project.environment.objects;
  ASSERT_EQ(objects.size(), 1U + 3 * 5);
  EXPECT_EQ(objects[1].name, "row[0,0]/chair/seat");
  EXPECT_EQ(objects.back().name, "row[2,0]/chair/leg[1,1]");
  const geometry::Bounds last = geometry::bounds(objects.back().shape, objects.back().transform);
  EXPECT_NEAR(last.center().x, 2.35, 1e-9);
}

TEST_F(Groups, HoldTheTrianglesOfALargeMeshOnceHoweverDeepTheyAreNested) {
  std::string mesh;
  for (int i = 0; i <= 30; ++i)
    for (int j = 0; j <= 30; ++j)
      mesh += "v " + std::to_string(0.01 * i) + " " + std::to_string(0.01 * j) + " " +
              std::to_string(0.3 + 0.001 * (i % 3)) + "\n";
  for (int i = 0; i < 30; ++i)
    for (int j = 1; j <= 30; ++j) {
      const int a = i * 31 + j;
      mesh += "f " + std::to_string(a) + " " + std::to_string(a + 31) + " " + std::to_string(a + 1) + "\n";
      mesh += "f " + std::to_string(a + 1) + " " + std::to_string(a + 31) + " " + std::to_string(a + 32) + "\n";
    }
  folder_.write("chair.obj", mesh);  // 1800 triangles
  const Project project =
      read(room("{ \"name\": \"hall\", \"shape\": \"group\", \"array\": { \"counts\": [10,10], \"u\": [0.5,0,0], "
                "\"v\": [0,0.3,0] }, "
                "\"objects\": [ { \"name\": \"block\", \"shape\": \"group\", \"array\": { \"counts\": [10,10], \"u\": "
                "[0.05,0,0], "
                "\"v\": [0,0.03,0] }, \"objects\": [ { \"shape\": \"mesh\", \"file\": \"chair.obj\", \"material\": "
                "\"grey\" } ] } ] }"));
  ASSERT_EQ(project.environment.objects.size(), 2U);
  const scene::Object& chairs = project.environment.objects.back();
  EXPECT_EQ(chairs.copies.size(), 9999U) << "10 000 chairs";
  EXPECT_EQ(chairs.shape.mesh.triangles.size(), 1800U) << "that cost one";
  EXPECT_NEAR(chairs.copies.back()[3].x, 9 * 0.5 + 9 * 0.05, 1e-9);
}

TEST_F(Groups, AreRefusedWhenEmptyUnknownOrNestedWithoutEnd) {
  expectError(room("{ \"shape\": \"group\", \"objects\": [] }"), "", "at least one object");
  expectError(room("{ \"shape\": \"group\" }"), "", "objects");
  expectError(room("{ \"shape\": \"group\", \"material\": \"grey\", \"objects\": [] }"), "", "material");
  std::string deep = "{ \"shape\": \"disc\", \"center\": [1,1,1], \"radius\": 0.1, \"material\": \"grey\" }";
  for (int i = 0; i < 40; ++i) deep = "{ \"shape\": \"group\", \"objects\": [ " + deep + " ] }";
  expectError(room(deep), "", "at most 32 deep");
}

}  // namespace
}  // namespace goniolux::project
