// Watertightness, orientation and slivers: each check finds the fault it is there for.
#include "geometry/mesh_checks.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "geometry/box.h"

namespace goniolux::geometry {
namespace {

Mesh cube() {
  return makeBox({0, 0, 0}, {1, 1, 1}).mesh;
}

// Every triangle with vertices of its own, as STL files have it.
Mesh soup(const Mesh& mesh) {
  Mesh result;
  result.parts = mesh.parts;
  for (const auto& t : mesh.triangles) {
    const auto first = static_cast<std::uint32_t>(result.vertices.size());
    for (const auto vertex : t) result.vertices.push_back(mesh.vertices[vertex]);
    result.triangles.push_back({first, first + 1, first + 2});
  }
  return result;
}

TEST(Edges, OfACubeAreEighteenEachSharedByTwo) {
  const EdgeReport report = checkEdges(cube());
  EXPECT_EQ(report.edges, 18U);
  EXPECT_TRUE(report.watertight());
  EXPECT_FALSE(checkEdges(Mesh{}).watertight()) << "nothing encloses nothing";
}

TEST(Edges, AMissingTriangleLeavesThreeBorders) {
  Mesh mesh = cube();
  mesh.triangles.pop_back();
  mesh.parts.pop_back();
  EXPECT_EQ(checkEdges(mesh).boundary, 3U);
}

TEST(Edges, ATurnedTriangleAndAThirdOneAreFound) {
  Mesh turned = cube();
  std::swap(turned.triangles[4][0], turned.triangles[4][1]);
  EXPECT_EQ(checkEdges(turned).inconsistent, 3U);
  EXPECT_FALSE(checkEdges(turned).watertight());
  Mesh fin = cube();
  fin.vertices.emplace_back(2, 2, 2);
  fin.triangles.push_back({0, 1, 8});
  fin.parts.push_back(0);
  EXPECT_EQ(checkEdges(fin).nonManifold, 1U);
}

TEST(Orientation, IsRepairedWhateverWasTurned) {
  for (unsigned pattern = 0; pattern < 4096; pattern += 37) {
    Mesh mesh = cube();
    for (unsigned i = 0; i < 12; ++i) {
      if (pattern >> i & 1U) std::swap(mesh.triangles[i][0], mesh.triangles[i][1]);
    }
    ASSERT_TRUE(orientOutward(mesh).watertight()) << pattern;
    ASSERT_DOUBLE_EQ(signedVolume(mesh), 1) << pattern;
  }
}

TEST(Merging, MakesATriangleSoupWatertightAgain) {
  Mesh mesh = soup(cube());
  EXPECT_EQ(checkEdges(mesh).boundary, 36U);
  // Neighbours in other cells of the grid are found too: shift copies by less than the tolerance, across cell borders.
  for (std::size_t i = 0; i < mesh.vertices.size(); i += 3) mesh.vertices[i] += core::Vec3(0.5e-6);
  mergeVertices(mesh, 1e-6);
  EXPECT_EQ(mesh.vertices.size(), 8U);
  EXPECT_TRUE(checkEdges(mesh).watertight());
}

TEST(Slivers, AreDroppedAndCounted) {
  Mesh mesh = cube();
  mesh.vertices.emplace_back(0.5, 0, 0);
  mesh.triangles.push_back({0, 8, 1});  // on a line
  mesh.triangles.push_back({3, 3, 5});  // a vertex twice
  mesh.parts.insert(mesh.parts.end(), 2, 5);
  EXPECT_EQ(removeDegenerateTriangles(mesh), 2U);
  EXPECT_EQ(mesh.triangles.size(), 12U);
  EXPECT_EQ(mesh.parts.size(), 12U);
  EXPECT_FALSE(isDegenerate({0, 0, 0}, {1e-9, 0, 0}, {0, 1e-9, 0})) << "small is not degenerate";
  EXPECT_TRUE(isDegenerate({0, 0, 0}, {1, 0, 0}, {0.3, 1e-12, 0}));
}

}  // namespace
}  // namespace goniolux::geometry
