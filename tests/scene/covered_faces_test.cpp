// Which faces of a luminous volume lie against a surface.
#include "scene/covered_faces.h"

#include <gtest/gtest.h>

#include "geometry/objects.h"

namespace goniolux::scene {
namespace {

using core::Vec3;
using emitter::Opening;

const photometry::LuminaireFrame down{{1, 0, 0}, {0, 1, 0}, {0, 0, -1}};
constexpr unsigned back = 1u << 5;  // opposite to the aim

Object boxObject(const Vec3& min, const Vec3& max, bool facesInward) {
  Object object;
  object.shape = geometry::findObjectType("box")->make({{"min", min}, {"max", max}});
  object.materials.assign(object.shape.partNames.size(), 0);
  object.facesInward = facesInward;
  return object;
}

/// A room of 6 m x 4 m x 3 m with a shelf under the ceiling's middle.
World room() {
  Environment environment;
  material::Material material;
  material.name = material.model = "lambert";
  material.spectra["diffuse"] = spectrum::SpectralDistribution::flat(0.5);
  environment.materials = {material};
  environment.objects = {boxObject({0, 0, 0}, {6, 4, 3}, true), boxObject({2.9, 1.9, 2}, {3.1, 2.1, 2.1}, false)};
  return buildWorld(environment);
}

unsigned coveredAt(const World& world, const Opening& opening, const Vec3& place) {
  return coveredFaces(world, opening, down, place - world.origin);
}

TEST(CoveredFaces, AreTheBackOfABattenOnTheCeiling) {
  const World world = room();
  const Opening batten{.shape = Opening::Shape::box, .length = 1.2, .width = 0.06, .height = 0.026};
  EXPECT_EQ(coveredAt(world, batten, {3, 2, 2.987}), back);
  EXPECT_EQ(coveredAt(world, batten, {3, 2, 2.986}), back) << "a gap of a millimetre";
  EXPECT_EQ(coveredAt(world, batten, {3, 2, 2.95}), 0u) << "it hangs";
  EXPECT_EQ(coveredAt(world, batten, {3, 0.03, 2.987}) & back, back);
  EXPECT_NE(coveredAt(world, batten, {3, 0.03, 2.987}), back) << "along the wall a side is covered as well";
}

TEST(CoveredFaces, AreCoveredWhole) {
  const World world = room();
  const Opening batten{.shape = Opening::Shape::box, .length = 1.2, .width = 0.06, .height = 0.026};
  EXPECT_EQ(coveredAt(world, batten, {3, 2, 2.113}), 0u) << "its middle alone stands on the shelf";
  EXPECT_EQ(coveredAt(world, batten, {5.9, 2, 2.987}), 0u) << "half of it sticks through the wall";
}

TEST(CoveredFaces, AreCapsOfRoundCylindersToo) {
  const World world = room();
  const Opening drum{.shape = Opening::Shape::cylinder, .height = 0.1, .diameter = 0.3};
  EXPECT_EQ(coveredAt(world, drum, {3, 2, 2.95}), back);
  EXPECT_EQ(coveredAt(world, drum, {3, 2, 1}), 0u);
  EXPECT_EQ(coveredAt(world, {.shape = Opening::Shape::sphere, .diameter = 0.3}, {3, 2, 2.85}), 0u);
}

}  // namespace
}  // namespace goniolux::scene
