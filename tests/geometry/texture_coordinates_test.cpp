// Every shape has coordinates for textures, and smooth normals join what bends little.
#include "geometry/texture_coordinates.h"

#include <gtest/gtest.h>

#include <cmath>

#include "geometry/mesh_checks.h"
#include "geometry/mesh_import.h"
#include "geometry/objects.h"
#include "geometry/queries.h"
#include "geometry/samples.h"
#include "geometry/smooth_normals.h"
#include "geometry/tessellate.h"
#include "support/temporary_folder.h"

namespace goniolux::geometry {
namespace {

using core::Vec2;
using core::Vec3;

TEST(TextureCoordinates, OfEveryShapeAreFiniteAndWithinItsUnitSquare) {
  const goniolux::test::TemporaryFolder folder;
  for (const test::Sample& sample : test::samples(folder.path())) {
    SCOPED_TRACE(sample.type + ": " + sample.title);
    const Shape shape = findObjectType(sample.type)->make(sample.arguments);
    const Bounds box = bounds(shape);
    for (std::size_t i = 0; i < shape.mesh.triangles.size(); ++i)
      for (const Vec2& uv : cornerCoordinates(shape.mesh, box, i)) {
        ASSERT_GE(std::min(uv.x, uv.y), -1e-9);
        ASSERT_LE(std::max(uv.x, uv.y), 1 + 1e-9);
      }
    for (const QuadricPatch& patch : shape.patches) {
      QuadricPatch canonical = patch;
      canonical.placement = core::Mat4(1.0);
      for (const Vec3& p : tessellate(canonical, 12).vertices) {
        const Vec2 uv = surfaceCoordinates(patch, p);
        ASSERT_GE(std::min(uv.x, uv.y), -1e-9);
        ASSERT_LE(std::max(uv.x, uv.y), 1 + 1e-9);
      }
    }
  }
}

TEST(TextureCoordinates, FollowTheRectanglesEdgesAndTheSpheresLongitude) {
  const Shape rectangle =
      findObjectType("rectangle")->make({{"origin", Vec3(1, 1, 1)}, {"u", Vec3(0, 2, 0)}, {"v", Vec3(0, 0, 3)}});
  const auto corners = cornerCoordinates(rectangle.mesh, bounds(rectangle), 0);
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 p = rectangle.mesh.vertices[rectangle.mesh.triangles[0][k]] - Vec3(1);
    EXPECT_NEAR(corners[k].x, p.y / 2, 1e-7);
    EXPECT_NEAR(corners[k].y, p.z / 3, 1e-7);
  }
  QuadricPatch sphere;
  sphere.kind = QuadricPatch::Kind::sphere;
  EXPECT_NEAR(surfaceCoordinates(sphere, {0, 1, 0}).x, 0.25, 1e-12);
  EXPECT_NEAR(surfaceCoordinates(sphere, {0, 1, 0}).y, 0.5, 1e-12);
  EXPECT_NEAR(surfaceCoordinates(sphere, {0, 0, -1}).y, 0, 1e-12);
  EXPECT_NEAR(surfaceCoordinates(sphere, {0, -1, 0}).x, 0.75, 1e-12);
}

TEST(TextureCoordinates, OfAnObjFileAreItsOwnAndStayWithTheirCornersWhenTrianglesAreTurned) {
  const goniolux::test::TemporaryFolder folder;
  // A tetrahedron whose first face is wound the wrong way round, so that it is turned on reading.
  folder.write("a.obj",
               "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvt 0 0\nvt 3 0\nvt 0 2\nvt 0.5 0.5\n"
               "f 1/1 2/2 3/3\nf 1/1 2/2 4/4\nf 2/2 3/3 4/4\nf 1/1 4/4 3/3\n");
  const Shape shape = importMesh((folder.path() / "a.obj").string(), 1, false);
  ASSERT_TRUE(shape.closed);
  ASSERT_EQ(shape.mesh.coordinates.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& p = shape.mesh.vertices[shape.mesh.triangles[i][k]];
      const glm::vec2 expected = p.z > 0.5 ? glm::vec2(0.5, 0.5) : glm::vec2(3 * p.x, 2 * p.y);
      EXPECT_EQ(shape.mesh.coordinates[i][k], expected) << i << " " << k;
    }
}

TEST(SmoothNormals, PointOutOfASphereAndKeepTheEdgesOfABox) {
  Shape ball = findObjectType("sphere")->make({{"center", Vec3(0)}, {"radius", 1.0}});
  Mesh mesh = tessellate(ball, 32);
  mergeVertices(mesh, 1e-9);
  removeDegenerateTriangles(mesh);
  addSmoothNormals(mesh, 40 * core::degree);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_GT(glm::dot(Vec3(mesh.smoothNormals[i][k]), mesh.vertices[mesh.triangles[i][k]]),
                std::cos(3 * core::degree));
  Mesh box = findObjectType("box")->make({{"min", Vec3(0)}, {"max", Vec3(1)}}).mesh;
  addSmoothNormals(box, 40 * core::degree);
  for (std::size_t i = 0; i < box.triangles.size(); ++i) {
    const auto& t = box.triangles[i];
    const Vec3 face =
        glm::normalize(glm::cross(box.vertices[t[1]] - box.vertices[t[0]], box.vertices[t[2]] - box.vertices[t[0]]));
    for (const core::Vec3f& normal : box.smoothNormals[i]) EXPECT_NEAR(glm::dot(Vec3(normal), face), 1, 1e-6);
  }
}

}  // namespace
}  // namespace goniolux::geometry
