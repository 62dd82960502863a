// Areas, volumes and planes of placed shapes, against closed forms.
#include "geometry/queries.h"

#include <gtest/gtest.h>

#include <cmath>

#include "geometry/box.h"
#include "geometry/disc.h"
#include "geometry/inside.h"
#include "geometry/round_solid.h"
#include "geometry/sphere.h"

namespace goniolux::geometry {
namespace {

using core::Mat4;
using core::pi;
using core::Vec3;

Mat4 scaling(double x, double y, double z) {
  Mat4 map{1.0};
  map[0].x = x, map[1].y = y, map[2].z = z;
  return map;
}

TEST(Area, OfSpheroidsIsTheClosedForm) {
  // Oblate a = a > c: 2 pi a^2 (1 + (1 - e^2)/e artanh e); prolate c > a: 2 pi a^2 (1 + c/(a e) asin e).
  const Shape sphere = makeSphere({0, 0, 0}, 1);
  for (const double c : {0.1, 0.5, 0.9}) {
    const double e = std::sqrt(1 - c * c);
    const double expected = 2 * pi * (1 + (1 - e * e) / e * std::atanh(e));
    EXPECT_NEAR(area(sphere, scaling(1, 1, c)) / expected, 1, 1e-6) << c;
    EXPECT_NEAR(area(sphere, scaling(c, 1, 1)) / expected, 1, 1e-6) << "the short axis lies elsewhere, " << c;
  }
  for (const double c : {1.1, 2.0, 10.0}) {
    const double e = std::sqrt(1 - 1 / (c * c));
    EXPECT_NEAR(area(sphere, scaling(1, 1, c)) / (2 * pi * (1 + c / e * std::asin(e))), 1, 1e-6) << c;
  }
}

TEST(Area, OfAnEllipticCylinderIsPerimeterTimesHeight) {
  // Perimeter of the ellipse with half axes 2 and 1: 8 E(3/4) = 9.688448220547675 (Abramowitz & Stegun 17.3).
  const Shape tube = makeRoundSolid({0, 0, 0}, {0, 0, 1}, 1, 1, Caps::none);
  EXPECT_NEAR(area(tube, scaling(2, 1, 3)), 3 * 9.688448220547675, 1e-10);
  EXPECT_NEAR(8 * std::comp_ellint_2(std::sqrt(0.75)), 9.688448220547675, 1e-12);
}

TEST(Area, OfADiscUnderAShearIsExact) {
  Mat4 shear{1.0};
  shear[1].x = 0.7;
  EXPECT_NEAR(area(makeDisc({0, 0, 0}, {0, 0, 1}, 2), shear), 4 * pi, 1e-13);
  EXPECT_NEAR(area(makeDisc({0, 0, 0}, {1, 0, 0}, 1), shear), pi * std::hypot(1.0, 0.7), 1e-13);
}

TEST(Volume, ScalesWithTheDeterminantEvenFarFromTheOrigin) {
  Mat4 map = scaling(1, -2, 3);
  map[3] = {1e6, -1e6, 1e6, 1};
  EXPECT_NEAR(volume(makeSphere({0, 0, 0}, 0.5), map), 6 * pi / 6, 1e-9);
  EXPECT_NEAR(volume(makeBox({0, 0, 0}, {1, 1, 1}), map), 6, 1e-8);
  EXPECT_NEAR(volume(makeRoundSolid({1, 2, 3}, {4, 5, 7}, 2, 0.5, Caps::both), scaling(2, 2, -0.5)),
              2 * pi * std::sqrt(34.0) / 3 * (4 + 1 + 0.25), 1e-10);
}

TEST(Volume, OfABoxTurnedInsideOutIsNegative) {
  Shape box = makeBox({0, 0, 0}, {1, 2, 3});
  for (auto& t : box.mesh.triangles) std::swap(t[0], t[1]);
  EXPECT_DOUBLE_EQ(volume(box), -6);
}

TEST(Bounds, OfARotatedSphereAreStillItsDiameter) {
  Mat4 map{1.0};
  map[0] = {0.6, 0.8, 0, 0};
  map[1] = {-0.8, 0.6, 0, 0};
  const Bounds box = bounds(makeSphere({0, 0, 0}, 2), map);
  EXPECT_NEAR(box.extent().x, 4, 1e-14);
  EXPECT_TRUE(Bounds{}.empty());
}

TEST(FacesInPlane, FindTheCeilingWithinTheToleranceOnly) {
  const Shape room = makeBox({0, 0, 0}, {6, 4, 3});
  const auto ceiling = facesInPlane(room, Mat4(1.0), {1, 1, 3 - 1e-7}, {0, 0, -1}, 1e-6);
  ASSERT_EQ(ceiling.triangles.size(), 2U);
  for (const auto i : ceiling.triangles) EXPECT_EQ(room.partNames[room.mesh.parts[i]], "ceiling");
  EXPECT_TRUE(facesInPlane(room, Mat4(1.0), {1, 1, 2.999}, {0, 0, -1}, 1e-6).triangles.empty());
  const Shape disc = makeDisc({0, 0, 3}, {0, 0, -1}, 1);
  EXPECT_EQ(facesInPlane(disc, Mat4(1.0), {0, 0, 3}, {0, 0, 1}, 1e-6).patches.size(), 1U);
  EXPECT_TRUE(facesInPlane(disc, Mat4(1.0), {0, 0, 3}, glm::normalize(Vec3(0, 1e-3, 1)), 1e-6).patches.empty());
}

TEST(Inside, APointOnTheDesksTopIsNotInTheDesk) {
  const Shape deskShape = makeBox({0, 0, 0}, {1.6, 0.8, 0.75});
  const InsideTest desk(deskShape, Mat4(1.0));
  EXPECT_FALSE(desk.contains({0.8, 0.4, 0.75}));
  EXPECT_FALSE(desk.contains({0.8, 0.4, 0.75 - 1e-9}));
  EXPECT_TRUE(desk.contains({0.8, 0.4, 0.75 - 1e-5}));
  EXPECT_FALSE(desk.contains({0.8, 0.4, 0.76}));
  const Shape globeShape = makeSphere({0, 0, 0}, 1);
  const InsideTest globe(globeShape, scaling(1, 1, 100));
  EXPECT_FALSE(globe.contains({0, 0, 100 - 1e-7}));
  EXPECT_TRUE(globe.contains({0, 0, 100 - 1e-5}));
}

TEST(Inside, AnOpenShapeHasNoInside) {
  const Shape tubeShape = makeRoundSolid({0, 0, 0}, {0, 0, 1}, 1, 1, Caps::none);
  const InsideTest tube(tubeShape, Mat4(1.0));
  EXPECT_FALSE(tube.contains({0, 0, 0.5}));
}

TEST(Inside, RoundSolidsHoldTheirAxisAndNothingBesideThem) {
  const Shape coneShape = makeRoundSolid({0, 0, 0}, {0, 0, 2}, 1, 0, Caps::both);
  const InsideTest cone(coneShape, Mat4(1.0));
  EXPECT_TRUE(cone.contains({0, 0, 1}));
  EXPECT_TRUE(cone.contains({0.49, 0, 1}));
  EXPECT_FALSE(cone.contains({0.51, 0, 1}));
  EXPECT_FALSE(cone.contains({0, 0, 2.1}));
  EXPECT_FALSE(cone.contains({0.9, 0.9, 0.01})) << "in the bounding box, beside the base";
}

TEST(Inside, ACavityIsOutside) {
  Shape shell = makeBox({0, 0, 0}, {3, 3, 3});
  const Shape hole = makeBox({1, 1, 1}, {2, 2, 2});
  for (auto t : hole.mesh.triangles) shell.mesh.triangles.push_back({t[0] + 8, t[2] + 8, t[1] + 8});
  shell.mesh.parts.insert(shell.mesh.parts.end(), 12, 0);
  shell.mesh.vertices.insert(shell.mesh.vertices.end(), hole.mesh.vertices.begin(), hole.mesh.vertices.end());
  const InsideTest inside(shell, Mat4(1.0));
  EXPECT_TRUE(inside.contains({0.5, 1.5, 1.5}));
  EXPECT_FALSE(inside.contains({1.5, 1.5, 1.5}));
  EXPECT_DOUBLE_EQ(volume(shell), 26);
}

}  // namespace
}  // namespace goniolux::geometry
