// Box, rectangle and round shapes: where their surfaces are, which way they face, what they refuse.
#include <gtest/gtest.h>

#include <stdexcept>

#include "geometry/box.h"
#include "geometry/disc.h"
#include "geometry/objects.h"
#include "geometry/rectangle.h"
#include "geometry/round_solid.h"

namespace goniolux::geometry {
namespace {

using core::Vec3;

Vec3 areaVector(const Mesh& mesh, std::size_t triangle) {
  const auto& t = mesh.triangles[triangle];
  return 0.5 * glm::cross(mesh.vertices[t[1]] - mesh.vertices[t[0]], mesh.vertices[t[2]] - mesh.vertices[t[0]]);
}

std::string refusal(const std::string& type, const core::Arguments& arguments) {
  try {
    findObjectType(type)->make(arguments);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(Box, EachPartIsTheFaceThatItsNameSaysAndLooksOutward) {
  const Shape box = makeBox({1, 2, 3}, {5, 5, 5});
  const std::vector<Vec3> expected{{0, 0, -12}, {0, 0, 12}, {-6, 0, 0}, {6, 0, 0}, {0, -8, 0}, {0, 8, 0}};
  ASSERT_EQ(box.partNames, (std::vector<std::string>{"floor", "ceiling", "xmin", "xmax", "ymin", "ymax"}));
  std::vector<Vec3> areas(6, Vec3(0));
  for (std::size_t i = 0; i < box.mesh.triangles.size(); ++i) areas[box.mesh.parts[i]] += areaVector(box.mesh, i);
  for (std::size_t part = 0; part < 6; ++part) {
    EXPECT_EQ(areas[part], expected[part]) << box.partNames[part];
    for (std::size_t i = 0; i < box.mesh.triangles.size(); ++i) {
      if (box.mesh.parts[i] != part) continue;
      const Vec3 center(3, 3.5, 4);
      const Vec3 corner = box.mesh.vertices[box.mesh.triangles[i][0]];
      EXPECT_GT(glm::dot(corner - center, areaVector(box.mesh, i)), 0) << box.partNames[part];
    }
  }
}

TEST(Box, WallsNameTheFourUprightFaces) {
  const ObjectType* type = findObjectType("box");
  ASSERT_NE(type, nullptr);
  EXPECT_EQ(type->partGroups.at("walls"), (std::vector<std::string>{"xmin", "xmax", "ymin", "ymax"}));
}

TEST(Box, RefusesSwappedCornersAndNamesTheAxis) {
  EXPECT_THROW(makeBox({0, 0, 0}, {1, 1, 0}), std::invalid_argument);
  EXPECT_NE(refusal("box", {{"min", Vec3(0, 2, 0)}, {"max", Vec3(1, 1, 1)}}).find("no extent in y"), std::string::npos);
}

TEST(Box, RefusesCoordinatesThatAreNotFinite) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(refusal("box", {{"min", Vec3(0, nan, 0)}, {"max", Vec3(1, 1, 1)}}).find("\"min\""), std::string::npos);
}

TEST(Rectangle, FacesWhereTheEdgesTurn) {
  const Shape shape = makeRectangle({0, 0, 1}, {2, 0, 0}, {0, 3, 0});
  EXPECT_EQ(areaVector(shape.mesh, 0) + areaVector(shape.mesh, 1), Vec3(0, 0, 6));
  EXPECT_FALSE(shape.closed);
}

TEST(Rectangle, RefusesSkewedAndEmptyEdges) {
  EXPECT_NE(refusal("rectangle", {{"origin", Vec3(0)}, {"u", Vec3(1, 0, 0)}, {"v", Vec3(1, 1, 0)}}).find("45.0"),
            std::string::npos);
  EXPECT_NE(refusal("rectangle", {{"origin", Vec3(0)}, {"u", Vec3(1, 0, 0)}, {"v", Vec3(0)}}).find("\"v\""),
            std::string::npos);
}

TEST(RoundSolid, CapsDecideWhetherItIsClosed) {
  EXPECT_TRUE(makeRoundSolid({0, 0, 0}, {0, 0, 1}, 1, 1, Caps::both).closed);
  EXPECT_FALSE(makeRoundSolid({0, 0, 0}, {0, 0, 1}, 1, 1, Caps::bottom).closed);
  EXPECT_TRUE(makeRoundSolid({0, 0, 0}, {0, 0, 1}, 1, 0, Caps::bottom).closed) << "a cone needs no cap at its apex";
  EXPECT_FALSE(makeRoundSolid({0, 0, 0}, {0, 0, 1}, 1, 0, Caps::none).closed);
}

TEST(RoundSolid, CanonicalEndsLandOnTheGivenEnds) {
  const Vec3 base(1, 2, 3), top(2, 4, 5);
  for (const double topRadius : {0.5, 1.0, 2.0}) {
    const Shape shape = makeRoundSolid(base, top, 1, topRadius, Caps::both);
    const QuadricPatch& side = shape.patches[0];
    const bool swapped = topRadius > 1;
    const Vec3 first = swapped ? top : base, last = swapped ? base : top;
    EXPECT_LT(glm::distance(Vec3(side.placement * glm::dvec4(0, 0, 0, 1)), first), 1e-14);
    EXPECT_LT(glm::distance(Vec3(side.placement * glm::dvec4(0, 0, 1, 1)), last), 1e-14);
    const Vec3 rim = Vec3(side.placement * glm::dvec4(1, 0, 0, 1));
    EXPECT_NEAR(glm::distance(rim, first), std::max(1.0, topRadius), 1e-14);
    EXPECT_NEAR(glm::dot(rim - first, top - base), 0, 1e-14);
    EXPECT_GT(glm::determinant(side.placement), 0);
  }
}

TEST(RoundSolid, CapsLookOutward) {
  const Shape shape = makeRoundSolid({0, 0, 0}, {0, 0, 2}, 1, 0.5, Caps::both);
  ASSERT_EQ(shape.patches.size(), 3U);
  EXPECT_GT(0, shape.patches[1].placement[2].z) << "bottom";
  EXPECT_LT(0, shape.patches[2].placement[2].z) << "top";
}

TEST(Sphere, TakesARadiusOrADiameterButNotBothOrNone) {
  const auto* sphere = findObjectType("sphere");
  const Shape byRadius = sphere->make({{"center", Vec3(0)}, {"radius", 2.0}});
  const Shape byDiameter = sphere->make({{"center", Vec3(0)}, {"diameter", 4.0}});
  EXPECT_EQ(byRadius.patches[0].placement, byDiameter.patches[0].placement);
  EXPECT_NE(refusal("sphere", {{"center", Vec3(0)}}).find("either \"radius\" or \"diameter\""), std::string::npos);
  EXPECT_NE(refusal("sphere", {{"center", Vec3(0)}, {"radius", 1.0}, {"diameter", 2.0}}).find("not both"),
            std::string::npos);
  EXPECT_NE(refusal("sphere", {{"center", Vec3(0)}, {"radius", -1.0}}).find("above 0"), std::string::npos);
}

TEST(Cylinder, HeightAlongAnAxisIsTheSameAsATop) {
  const auto* cylinder = findObjectType("cylinder");
  const Shape a = cylinder->make({{"base", Vec3(1, 0, 0)}, {"height", 2.0}, {"axis", Vec3(0, 5, 0)}, {"radius", 0.1}});
  const Shape b = cylinder->make({{"base", Vec3(1, 0, 0)}, {"top", Vec3(1, 2, 0)}, {"radius", 0.1}});
  for (std::size_t i = 0; i < a.patches.size(); ++i) EXPECT_EQ(a.patches[i].placement, b.patches[i].placement);
  EXPECT_NE(refusal("cylinder", {{"base", Vec3(0)}, {"radius", 1.0}}).find("\"top\""), std::string::npos);
  EXPECT_NE(refusal("cylinder", {{"base", Vec3(0)}, {"top", Vec3(0)}, {"radius", 1.0}}).find("coincide"),
            std::string::npos);
  EXPECT_NE(refusal("cylinder", {{"base", Vec3(0)}, {"height", 1.0}, {"radius", 1.0}, {"caps", std::string("yes")}})
                .find("both, bottom, top or none"),
            std::string::npos);
}

TEST(Disc, FacesItsNormal) {
  const Shape disc = makeDisc({0, 0, 1}, {0, 0, -3}, 0.5);
  EXPECT_EQ(Vec3(disc.patches[0].placement[2]), Vec3(0, 0, -1));
  EXPECT_THROW(makeDisc({0, 0, 0}, {0, 0, 0}, 1), std::invalid_argument);
}

}  // namespace
}  // namespace goniolux::geometry
