#include "scene/housing.h"

#include <gtest/gtest.h>

#include "geometry/objects.h"

namespace goniolux::scene {
namespace {

using core::Vec3;

Environment lampInBox(const Vec3& half, const std::string& model) {
  Environment environment;
  material::Material material;
  material.name = material.model = model;
  environment.materials = {material};
  Object box;
  box.shape = geometry::findObjectType("box")->make({{"min", -half}, {"max", half}});
  box.materials.assign(box.shape.partNames.size(), 0);
  environment.objects = {box};
  Luminaire lamp;
  lamp.opening = {.shape = emitter::Opening::Shape::rectangle, .length = 1.2, .width = 0.3};
  environment.luminaires = {lamp};
  return environment;
}

TEST(Housing, IsABodyAboutAsLargeAsItsLuminaire) {
  const auto found = enclosuresOf(lampInBox({0.62, 0.17, 0.04}, "lambert"));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_TRUE(found[0].isHousing);
}

TEST(Housing, IsNoCupboard) {
  const auto found = enclosuresOf(lampInBox({0.9, 0.4, 1.0}, "lambert"));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_FALSE(found[0].isHousing);
}

TEST(Housing, IsNotOfGlass) {
  EXPECT_TRUE(enclosuresOf(lampInBox({0.62, 0.17, 0.04}, "dielectric")).empty());
}

TEST(Housing, IsNoRoomAboutTheLuminaire) {
  Environment environment = lampInBox({0.62, 0.17, 0.04}, "lambert");
  environment.objects[0].facesInward = true;
  EXPECT_TRUE(enclosuresOf(environment).empty());
}

}  // namespace
}  // namespace goniolux::scene
