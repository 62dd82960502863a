// Mesh files: what names, units and axes become, and that damaged files are refused with their name, never worse.
#include "geometry/mesh_import.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <random>
#include <stdexcept>

#include "geometry/mesh_checks.h"
#include "geometry/queries.h"
#include "support/temporary_folder.h"

namespace goniolux::geometry {
namespace {

using core::Vec3;

const char* const tetrahedron =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
    "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";

std::string binaryStl() {
  const float t[4][9] = {{0, 0, 0, 0, 1, 0, 1, 0, 0},
                         {0, 0, 0, 1, 0, 0, 0, 0, 1},
                         {1, 0, 0, 0, 1, 0, 0, 0, 1},
                         {0, 0, 0, 0, 0, 1, 0, 1, 0}};
  std::string bytes(80, ' ');
  const std::uint32_t count = 4;
  bytes.append(reinterpret_cast<const char*>(&count), 4);
  for (const auto& triangle : t) {
    bytes.append(12, '\0');
    bytes.append(reinterpret_cast<const char*>(triangle), 36);
    bytes.append(2, '\0');
  }
  return bytes;
}

std::string ply(const std::string& faces = "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n") {
  return "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
         "element face 4\nproperty list uchar int vertex_indices\nend_header\n"
         "0 0 0\n1 0 0\n0 1 0\n0 0 1\n" +
         faces;
}

std::string gltf() {
  // Positions of the four corners (48 bytes) and 12 indices (24 bytes).
  return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],
    "nodes":[{"mesh":0,"name":"shade","translation":[0,2,0]}],
    "materials":[{"name":"glass"}],
    "meshes":[{"name":"shade","primitives":[{"attributes":{"POSITION":0},"indices":1,"material":0}]}],
    "accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3","min":[0,0,0],"max":[1,1,1]},
                 {"bufferView":1,"componentType":5123,"count":12,"type":"SCALAR"}],
    "bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":24}],
    "buffers":[{"byteLength":72,"uri":"corners.bin"}]})";
}

std::string gltfBuffer() {
  const float corners[12] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
  const std::uint16_t indices[12] = {0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2};
  return std::string(reinterpret_cast<const char*>(corners), 48) +
         std::string(reinterpret_cast<const char*>(indices), 24);
}

class MeshFile : public ::testing::Test {
 protected:
  std::string write(const std::string& name, const std::string& text) { return folder_.write(name, text).string(); }
  std::string refusal(const std::string& file) {
    try {
      importMesh(file, 1, false);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  }

 private:
  goniolux::test::TemporaryFolder folder_;
};

TEST_F(MeshFile, EveryFormatGivesTheSameClosedTetrahedron) {
  write("corners.bin", gltfBuffer());
  for (const auto& file :
       {write("t.obj", tetrahedron), write("t.stl", binaryStl()), write("T.PLY", ply()), write("t.gltf", gltf())}) {
    SCOPED_TRACE(file);
    const Shape shape = importMesh(file, 1, false);
    EXPECT_EQ(shape.mesh.vertices.size(), 4U);
    EXPECT_TRUE(shape.closed);
    EXPECT_NEAR(volume(shape), 1.0 / 6, 1e-7);
    EXPECT_TRUE(shape.remarks.empty());
  }
}

TEST_F(MeshFile, UnitsAndUpAxisAreApplied) {
  const ObjectType* type = findObjectType("mesh");
  const std::string file = write("t.obj", "v 0 0 0\nv 2000 0 0\nv 0 3000 0\nf 1 2 3\n");
  const Shape shape = type->make({{"file", file}, {"units", std::string("mm")}, {"up", std::string("y")}});
  const Bounds box = bounds(shape);
  EXPECT_NEAR(glm::distance(box.max, Vec3(2, 0, 3)), 0, 1e-6) << "y of the file is up";
  EXPECT_GT(0, vectorArea(shape).y) << "the front of the x-y plane, +z, looks towards -y";
  EXPECT_THROW(type->make({{"file", file}, {"units", std::string("yd")}}), std::invalid_argument);
  EXPECT_THROW(type->make({{"file", file}, {"up", std::string("x")}}), std::invalid_argument);
}

TEST_F(MeshFile, GltfIsYUpAndItsNodesArePlaced) {
  write("corners.bin", gltfBuffer());
  const Shape shape = findObjectType("mesh")->make({{"file", write("t.gltf", gltf())}});
  EXPECT_NEAR(bounds(shape).min.z, 2, 1e-6) << "translated by 2 along the file's y";
  EXPECT_EQ(shape.partNames, std::vector<std::string>{"glass"});
  EXPECT_EQ(shape.partGroups.at("shade"), std::vector<std::string>{"glass"});
}

TEST_F(MeshFile, MaterialsAndGroupsBecomePartsAndGroupsOfParts) {
  const std::string file =
      write("chair.obj",
            "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
            "o seat\nusemtl fabric\nf 1 3 2\nusemtl steel\nf 1 2 4\no legs\nusemtl steel\nf 2 3 4\nf 1 4 3\n");
  const Shape shape = importMesh(file, 1, false);
  auto names = shape.partNames;
  std::sort(names.begin(), names.end());
  EXPECT_EQ(names, (std::vector<std::string>{"fabric", "legs/steel", "seat/steel"}));
  auto seat = shape.partGroups.at("seat"), steel = shape.partGroups.at("steel");
  std::sort(seat.begin(), seat.end());
  std::sort(steel.begin(), steel.end());
  EXPECT_EQ(seat, (std::vector<std::string>{"fabric", "seat/steel"}));
  EXPECT_EQ(steel, (std::vector<std::string>{"legs/steel", "seat/steel"}));
  EXPECT_TRUE(shape.closed) << "parts do not open a surface";
  std::vector<int> triangles(3, 0);
  for (const auto part : shape.mesh.parts) ++triangles.at(part);
  std::sort(triangles.begin(), triangles.end());
  EXPECT_EQ(triangles, (std::vector<int>{1, 1, 2}));
}

TEST_F(MeshFile, WithoutNamesThereIsOnePart) {
  EXPECT_EQ(importMesh(write("t.obj", tetrahedron), 1, false).partNames, std::vector<std::string>{"surface"});
  EXPECT_EQ(importMesh(write("t.ply", ply()), 1, false).partNames, std::vector<std::string>{"surface"});
}

TEST_F(MeshFile, TrianglesWithoutAreaAreLeftOutAndCounted) {
  const Shape shape = importMesh(write("t.obj", std::string(tetrahedron) + "v 0.5 0 0\nf 1 1 2\nf 1 5 2\n"), 1, false);
  EXPECT_EQ(shape.mesh.triangles.size(), 4U);
  ASSERT_EQ(shape.remarks.size(), 1U);
  EXPECT_NE(shape.remarks[0].find("2 triangles without area"), std::string::npos) << shape.remarks[0];
}

TEST_F(MeshFile, ATetrahedronTurnedInsideOutIsPutRight) {
  const Shape shape =
      importMesh(write("t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 4 2\nf 2 3 4\nf 1 3 4\n"), 1, false);
  EXPECT_TRUE(shape.closed);
  EXPECT_NEAR(volume(shape), 1.0 / 6, 1e-7);
}

TEST_F(MeshFile, IsRefusedWithItsNameAndTheReason) {
  const std::string missing = write("t.obj", tetrahedron) + ".stl";
  EXPECT_NE(refusal(missing).find("cannot be read"), std::string::npos);
  EXPECT_EQ(refusal(missing).find(missing), 0U);
  EXPECT_NE(refusal(write("t.dwg", "x")).find("\".dwg\" is no mesh format"), std::string::npos);
  EXPECT_NE(refusal(write("e.obj", "")).find("is empty"), std::string::npos);
  EXPECT_NE(refusal(write("c.obj", "# only a comment\n")), "");
  EXPECT_NE(refusal(write("p.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n")), "") << "points alone";
  EXPECT_NE(refusal(write("n.obj", "v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")).find("not a finite number"),
            std::string::npos);
  EXPECT_NE(refusal(write("i.obj", "v inf 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")).find("not a finite number"),
            std::string::npos);
  EXPECT_NE(refusal(write("d.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n")).find("no triangle with an area"),
            std::string::npos);
}

TEST_F(MeshFile, IndicesOutOfRangeAreRefusedOrLeftOut) {
  for (const std::string face : {"f 1 2 99999999\n", "f 1 2 -9\n", "f 1 2 4294967297\n", "f 0 1 2\n"}) {
    const std::string file = write("x.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n" + face);
    EXPECT_NE(refusal(file), "") << face;
  }
  EXPECT_NE(refusal(write("x.ply", ply("3 0 2 1\n3 0 1 99\n3 1 2 -3\n3 0 3 2\n"))), "");
}

TEST_F(MeshFile, DamagedFilesNeverCrash) {
  // Every cut and some thousand altered bytes; whatever comes back must hold what a shape promises.
  write("corners.bin", gltfBuffer());
  std::mt19937 generator(3);
  int refused = 0, accepted = 0;
  const auto attempt = [&](const std::string& name, const std::string& bytes) {
    const std::string file = write(name, bytes);
    try {
      const Shape shape = importMesh(file, 1, false);
      ++accepted;
      for (const auto& t : shape.mesh.triangles) {
        for (const auto vertex : t) ASSERT_LT(vertex, shape.mesh.vertices.size());
      }
      ASSERT_TRUE(std::isfinite(area(shape)));
    } catch (const std::invalid_argument& error) {
      ASSERT_EQ(std::string(error.what()).find(file), 0U) << error.what();
      ++refused;
    }
  };
  const std::vector<std::pair<std::string, std::string>> files{
      {"t.obj", tetrahedron}, {"t.stl", binaryStl()}, {"t.ply", ply()}, {"t.gltf", gltf()}};
  for (const auto& [name, bytes] : files) {
    for (std::size_t length = 0; length < bytes.size(); length += 1 + bytes.size() / 200)
      attempt(name, bytes.substr(0, length));
    for (int i = 0; i < 250; ++i) {
      std::string damaged = bytes;
      for (int k = 0; k < 3; ++k) damaged[generator() % damaged.size()] = static_cast<char>(generator());
      attempt(name, damaged);
    }
  }
  EXPECT_GT(refused, 50);
  EXPECT_GT(accepted, 50);
}

}  // namespace
}  // namespace goniolux::geometry
