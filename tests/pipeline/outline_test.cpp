#include "pipeline/outline.h"

#include <gtest/gtest.h>

#include <cmath>

#include "geometry/objects.h"

namespace goniolux::pipeline {
namespace {

using core::Vec3;
using geometry::QuadricPatch;

scene::Object box(const std::string& name, const Vec3& low, const Vec3& high, bool inward = false) {
  core::Arguments arguments;
  arguments["min"] = low;
  arguments["max"] = high;
  return {name, geometry::findObjectType("box")->make(arguments), core::Mat4(1), {0}, inward, {}};
}

double totalLength(const std::vector<Segment>& segments) {
  double length = 0;
  for (const Segment& segment : segments) length += glm::distance(segment.from, segment.to);
  return length;
}

scene::Object patch(QuadricPatch::Kind kind, const core::Mat4& placement, double ratio = 1) {
  scene::Object object;
  object.shape.patches.push_back({kind, ratio, placement, 0});
  return object;
}

core::Mat4 scaled(double x, double y, double z) {
  core::Mat4 matrix(1);
  matrix[0][0] = x;
  matrix[1][1] = y;
  matrix[2][2] = z;
  return matrix;
}

TEST(FeatureEdges, OfABoxAreItsTwelveEdgesWithoutDiagonals) {
  const std::vector<Segment> edges = featureEdges(box("desk", {0, 0, 0}, {2, 1, 0.5}));
  EXPECT_EQ(edges.size(), 12U);
  EXPECT_NEAR(totalLength(edges), 4 * (2 + 1 + 0.5), 1e-12);
}

TEST(FeatureEdges, OfAFlatPatchOfTrianglesAreItsRim) {
  scene::Object object;
  object.shape.mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  object.shape.mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  EXPECT_NEAR(totalLength(featureEdges(object)), 4, 1e-12);
  object.shape.mesh.triangles = {{0, 1, 2}, {0, 3, 2}};  // the second wound the other way round: still flat
  EXPECT_NEAR(totalLength(featureEdges(object)), 4, 1e-12);
}

TEST(FeatureEdges, OfARoundMeshAreItsSilhouetteFromAbove) {
  // A sphere of small triangles bends nowhere by 20 degrees.
  scene::Object object;
  constexpr int rings = 24, around = 48;
  for (int i = 0; i <= rings; ++i) {
    for (int k = 0; k < around; ++k) {
      const double t = core::pi * i / rings, p = 2 * core::pi * k / around;
      object.shape.mesh.vertices.emplace_back(std::sin(t) * std::cos(p), std::sin(t) * std::sin(p), std::cos(t));
    }
  }
  for (std::uint32_t i = 0; i < rings; ++i) {
    for (std::uint32_t k = 0; k < around; ++k) {
      const std::uint32_t a = i * around + k, b = i * around + (k + 1) % around, c = a + around, d = b + around;
      object.shape.mesh.triangles.push_back({a, c, d});
      object.shape.mesh.triangles.push_back({a, d, b});
    }
  }
  EXPECT_NEAR(totalLength(featureEdges(object)), 2 * core::pi, 0.02) << "the equator";
}

TEST(FeatureEdges, OfATiltedEllipsoidProjectToItsShadow) {
  // The shadow of x = M s, |s| = 1, on the plan has the half width sqrt((M M^T)_xx) along x.
  core::Mat4 tilt(1);
  const double c = std::cos(0.7), s = std::sin(0.7);
  tilt[0][0] = c;
  tilt[0][2] = -s;
  tilt[2][0] = s;
  tilt[2][2] = c;
  const core::Mat4 placement = tilt * scaled(2, 1, 0.5);
  double widest = 0;
  for (const Segment& edge : featureEdges(patch(QuadricPatch::Kind::sphere, placement)))
    widest = std::max(widest, edge.from.x);
  EXPECT_NEAR(widest, std::sqrt(4 * c * c + 0.25 * s * s), 0.003);
}

TEST(FeatureEdges, OfALyingCylinderIncludeItsTwoSides) {
  // Canonical z along world x: length 3, radius 0.5.
  core::Mat4 placement(0.0);
  placement[0][2] = 0.5;  // canonical x -> world z
  placement[1][1] = 0.5;  // canonical y -> world y
  placement[2][0] = 3;    // canonical z -> world x
  placement[3][3] = 1;
  int sides = 0;
  for (const Segment& edge : featureEdges(patch(QuadricPatch::Kind::cylinder, placement))) {
    if (std::abs(edge.to.x - edge.from.x) < 2.9) continue;
    ++sides;
    EXPECT_NEAR(std::abs(edge.from.y), 0.5, 1e-12);
    EXPECT_NEAR(edge.from.z, 0, 1e-12);
  }
  EXPECT_EQ(sides, 2);
}

TEST(PlanVisibility, CutsALineWhereSomethingLiesOverIt) {
  const std::vector<Triangle> cover{{Vec3{1, -1, 2}, Vec3{3, -1, 2}, Vec3{3, 1, 2}},
                                    {Vec3{1, -1, 2}, Vec3{3, 1, 2}, Vec3{1, 1, 2}}};
  const std::vector<Segment> visible = PlanCovers(cover).visible({{{0, 0, 0}, {4, 0, 0}}}, 1e-4);
  ASSERT_EQ(visible.size(), 2U);
  EXPECT_NEAR(visible[0].to.x, 1, 1e-6);
  EXPECT_NEAR(visible[1].from.x, 3, 1e-6);
  EXPECT_EQ(PlanCovers(cover).visible({{{0, 0, 3}, {4, 0, 3}}}, 1e-4).size(), 1U) << "above the cover";
  // A line that rises through the cover shows from where it comes out.
  const std::vector<Segment> rising = PlanCovers(cover).visible({{{1, 0, 1}, {3, 0, 3}}}, 1e-6);
  ASSERT_EQ(rising.size(), 1U);
  EXPECT_NEAR(rising[0].from.x, 2, 1e-4);
}

TEST(PlanVisibility, DropsUprightLines) {
  EXPECT_TRUE(PlanCovers({}).visible({{{1, 1, 0}, {1, 1, 2}}}, 1e-4).empty());
}

project::Project furnishedRoom() {
  project::Project project;
  project.name = "room";
  project.hash = "h";
  project.environment.objects = {box("room", {0, 0, 0}, {6, 4, 3}, true), box("table top", {1, 1, 0.7}, {3, 2, 0.75}),
                                 box("leg", {1.1, 1.1, 0}, {1.15, 1.15, 0.7})};
  scene::Luminaire panel;
  panel.name = "L[0,0]";
  panel.type = "L";
  panel.center = {1, 1, 3};
  panel.opening = {emitter::Opening::Shape::rectangle, 1.2, 0.3, 0, 0, {1, 0, 0}};
  scene::Luminaire tube;
  tube.name = "T";
  tube.center = {3, 2, 2.5};
  tube.opening = {emitter::Opening::Shape::tube, 1.2, 0, 0, 0.026, {0, 1, 0}};
  scene::Luminaire point;
  point.name = "P";
  project.environment.luminaires = {panel, tube, point};
  return project;
}

TEST(Outline, DrawsATableButNotTheLegsUnderIt) {
  const Outline outline = outlineOf(furnishedRoom());
  ASSERT_EQ(outline.objects.size(), 3U);
  EXPECT_TRUE(outline.objects[0].isRoom);
  EXPECT_FALSE(outline.objects[1].isRoom);
  EXPECT_NEAR(totalLength(outline.objects[1].plan), 2 * (2 + 1), 0.01) << "the top's rim once";
  EXPECT_TRUE(outline.objects[2].plan.empty());
  EXPECT_EQ(outline.objects[2].edges.size(), 12U);
  EXPECT_EQ(outline.high, Vec3(6, 4, 3));
}

TEST(Outline, HasTheOpeningsOfLuminairesWithTheirLengthAlongC0) {
  const Outline outline = outlineOf(furnishedRoom());
  ASSERT_EQ(outline.luminaires.size(), 3U);
  EXPECT_EQ(outline.luminaires[0].footprint[0], Vec3(0.4, 0.85, 3));
  EXPECT_EQ(outline.luminaires[0].footprint[2], Vec3(1.6, 1.15, 3));
  EXPECT_NEAR(outline.luminaires[1].footprint[1].y - outline.luminaires[1].footprint[0].y, 1.2, 1e-12);
  EXPECT_TRUE(outline.luminaires[2].footprint.empty());
}

TEST(Outline, ReadsBackAndRefusesDamage) {
  const std::string text = core::toJson(toJson(outlineOf(furnishedRoom())));
  core::Diagnostics diagnostics;
  EXPECT_EQ(core::toJson(toJson(outlineFromJson(core::parseJson(text, "outline.json", diagnostics)))), text);
  for (const auto& [from, to] :
       {std::pair("goniolux-outline", "other"), std::pair("\"version\": 1", "\"version\": 9"),
        std::pair("\"edges\": [", "\"edges\": [[1, 2], "), std::pair("\"room\": true", "\"room\": 1")}) {
    std::string broken = text;
    ASSERT_NE(broken.find(from), std::string::npos) << from;
    broken.replace(broken.find(from), std::string(from).size(), to);
    EXPECT_THROW(outlineFromJson(core::parseJson(broken, "outline.json", diagnostics)), core::InputError) << to;
  }
}

}  // namespace
}  // namespace goniolux::pipeline
