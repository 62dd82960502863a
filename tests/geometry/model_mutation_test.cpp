// Damaged models: every mutation of a good file gives a shape whose numbers are finite, or a refusal with a sentence;
// none crashes the program, hangs or eats the memory. Each runs in a process of its own with limits of 10 s and 2 GiB.
// GONIOLUX_MUTATIONS=100000 runs more of them.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <random>

#include "geometry/mesh_import.h"
#include "geometry/queries.h"
#include "geometry/radiance_scene.h"
#include "support/temporary_folder.h"

namespace goniolux::geometry {
namespace {

std::string binaryStl() {
  std::string bytes(80, ' ');
  const auto add = [&](const auto& value) { bytes.append(reinterpret_cast<const char*>(&value), sizeof value); };
  add(std::uint32_t{4});
  const float corners[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const int faces[4][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
  for (const auto& face : faces) {
    for (int k = 0; k < 3; ++k) add(0.0f);
    for (const int corner : face)
      for (const float x : corners[corner]) add(x);
    add(std::uint16_t{0});
  }
  return bytes;
}

std::string gltf(const std::string& children) {
  return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0)" + children +
         R"(}],"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],)"
         R"("accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]},)"
         R"({"bufferView":1,"componentType":5123,"count":3,"type":"SCALAR"}],)"
         R"("bufferViews":[{"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":6}],)"
         R"("buffers":[{"byteLength":42,"uri":"data:application/octet-stream;base64,)"
         R"(AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAABAAIA"}]})";
}

const std::vector<std::pair<std::string, std::string>>& seeds() {
  static const std::vector<std::pair<std::string, std::string>> list{
      {"a.obj",
       "o seat\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nusemtl fabric\nf 1 3 2\nf 1/1/1 2/2/2 4/1/1\ng legs\nf 2 3 "
       "4\nf 1 4 3\n"},
      {"a.ply",
       "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\nelement "
       "face 4\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 "
       "3\n3 1 2 3\n3 0 3 2\n"},
      {"a.stl",
       "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n"
       "endsolid s\n"},
      {"b.stl", binaryStl()},
      {"a.gltf", gltf("")},
  };
  return list;
}

std::string mutated(std::string bytes, std::mt19937_64& random) {
  static const char* pieces[] = {"nan",      "1e999", "-1", "4294967295", "2147483648", "99999999999999999999",
                                 "\xff\xfe", "0",     "\n", " ",          "{",          "["};
  const auto below = [&](std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random); };
  for (std::size_t k = 1 + below(3); k > 0 && !bytes.empty(); --k) {
    const std::size_t at = below(bytes.size());
    switch (below(5)) {
      case 0:
        bytes[at] = static_cast<char>(below(256));
        break;
      case 1:
        bytes.resize(at);
        break;
      case 2:
        bytes.insert(at, pieces[below(std::size(pieces))]);
        break;
      case 3:
        bytes.erase(at, 1 + below(8));
        break;
      default:
        bytes.insert(at, bytes.substr(below(bytes.size()), 1 + below(40)));
    }
  }
  return bytes;
}

// 0 when the work ends as it should; else what went wrong, as a process's end tells.
int inProcessOfItsOwn(const std::function<int()>& work) {
  const pid_t child = fork();
  if (child == 0) {
    const rlimit memory{2ull << 30, 2ull << 30}, noCore{0, 0};
    setrlimit(RLIMIT_AS, &memory);
    setrlimit(RLIMIT_CORE, &noCore);
    alarm(10);
    if (std::freopen("/dev/null", "w", stderr) == nullptr) _exit(3);
    _exit(work());
  }
  int status = 0;
  waitpid(child, &status, 0);
  return status;
}

int tryModel(const std::string& file) {
  try {
    const Shape shape = importMesh(file, 1, false);
    const double size = area(shape);
    return std::isfinite(size) && size > 0 ? 0 : 1;
  } catch (const std::invalid_argument& refusal) {
    return std::strlen(refusal.what()) > 10 ? 0 : 2;
  }
}

TEST(DamagedModels, AreRefusedWithASentenceOrReadWithFiniteNumbers) {
  const char* asked = std::getenv("GONIOLUX_MUTATIONS");
  const int perFormat = (asked ? std::atoi(asked) : 1000) / int(seeds().size());
  goniolux::test::TemporaryFolder folder;
  std::mt19937_64 random(2026);
  for (const auto& [name, bytes] : seeds()) {
    const auto whole = folder.write(name, bytes);
    ASSERT_EQ(inProcessOfItsOwn([&] { return tryModel(whole.string()); }), 0) << name;
    // A hundred in one process; when one fails, each alone, to name it.
    for (int first = 0; first < perFormat; first += 100) {
      std::vector<std::string> batch;
      for (int k = first; k < std::min(first + 100, perFormat); ++k) batch.push_back(mutated(bytes, random));
      const auto run = [&](const std::string& content) {
        return tryModel(folder.write("m-" + name, content).string());
      };
      const int together = inProcessOfItsOwn([&] {
        for (const std::string& content : batch)
          if (const int failed = run(content)) return failed;
        return 0;
      });
      if (together == 0) continue;
      for (const std::string& content : batch)
        EXPECT_EQ(inProcessOfItsOwn([&] { return run(content); }), 0) << name << ":\n" << content.substr(0, 600);
    }
  }
}

// Found by 20 000 mutations: the importer counted to 4 294 967 295 first.
TEST(DamagedModels, PlyFilesThatPromiseMoreElementsThanTheyHoldAreRefusedAtOnce) {
  goniolux::test::TemporaryFolder folder;
  for (const char* header : {"element vertex 42147483648\nproperty float x\nproperty float y\nproperty float z\n"
                             "element face 4\nproperty list uchar int vertex_indices\n",
                             "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
                             "element face 999999999999999999994\nproperty list uchar int vertex_indices\n"}) {
    const auto file = folder.write("a.ply", "ply\nformat ascii 1.0\n" + std::string(header) +
                                                "end_header\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n");
    try {
      importMesh(file.string(), 1, false);
      ADD_FAILURE() << header;
    } catch (const std::invalid_argument& refusal) {
      EXPECT_NE(std::string(refusal.what()).find("can hold"), std::string::npos) << refusal.what();
    }
  }
}

// Found by the fuzz target of PLY files: the importer never came back.
TEST(DamagedModels, PlyHeadersWithWordsThatNobodyKnowsAreRefusedWithTheirLine) {
  goniolux::test::TemporaryFolder folder;
  const auto refusal = [&](const std::string& header) -> std::string {
    try {
      importMesh(folder
                     .write("a.ply", "ply\nformat ascii 1.0\n" + header +
                                         "property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n"
                                         "3 0 1 2\n")
                     .string(),
                 1, false);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  const std::string vertices = "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
  EXPECT_EQ(refusal(vertices + "element face 1\n"), "");
  EXPECT_NE(refusal(vertices + " face 1\n").find("a.ply:7: \"face\" is no word"), std::string::npos);
  EXPECT_NE(refusal("element vertex 3\nproperty x s\n").find("a.ply:4: a property has a type"), std::string::npos);
  EXPECT_NE(refusal("element vertex 3x\n").find("no count"), std::string::npos);
  EXPECT_NE(refusal(vertices + "element 1000000000 5\n").find("begins with a letter"), std::string::npos);
}

// Found by the fuzz target of PLY files: the importer counted the corners.
TEST(DamagedModels, PlyFacesWithMoreCornersThanTheFileHoldsAreRefusedWithTheirLine) {
  goniolux::test::TemporaryFolder folder;
  const std::string header =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 2\n"
      "property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  for (const char* face : {"99999999999999999999 0 1 2\n", "-3 0 1 2\n", "three 0 1 2\n", "4 0 1 2\n"}) {
    try {
      importMesh(folder.write("a.ply", header + face).string(), 1, false);
      ADD_FAILURE() << face;
    } catch (const std::invalid_argument& refusal) {
      EXPECT_NE(std::string(refusal.what()).find("a.ply:1"), std::string::npos) << refusal.what();
    }
  }
}

// Found by the fuzz target of glTF files: the importer took the part after the "/" that was not there.
TEST(DamagedModels, GltfPicturesWithoutAMediaTypeAreRefused) {
  goniolux::test::TemporaryFolder folder;
  for (const char* type : {R"("mimeType":"-0",)", R"("mimeType":"image/",)", R"("mimeType":7,)", ""}) {
    std::string text = gltf("");
    text.insert(text.size() - 1,
                R"(,"images":[{)" + std::string(type) + R"("bufferView":0}],"textures":[{"source":0}])");
    try {
      importMesh(folder.write("x.gltf", text).string(), 1, true);
      ADD_FAILURE() << type;
    } catch (const std::invalid_argument& refusal) {
      EXPECT_NE(std::string(refusal.what()).find("media type"), std::string::npos) << refusal.what();
    }
  }
}

TEST(DamagedModels, GltfNodesInACircleCountsBeyondTheFileAndTwoParentsAreRefused) {
  goniolux::test::TemporaryFolder folder;
  const auto refusal = [&](const std::string& text) -> std::string {
    try {
      importMesh(folder.write("x.gltf", text).string(), 1, true);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(refusal(gltf("")), "");
  EXPECT_NE(refusal(gltf(",\"children\":[0]")).find("two parents or is its own"), std::string::npos);
  EXPECT_NE(refusal(gltf(",\"children\":[1]},{\"children\":[2]},{\"children\":[1]")).find("two parents"),
            std::string::npos);
  EXPECT_NE(refusal(gltf("},{\"children\":[2]},{\"children\":[1]")).find("circle"), std::string::npos);
  std::string huge = gltf("");
  huge.replace(huge.find("\"count\":3"), 9, "\"count\":3000000");
  EXPECT_NE(refusal(huge).find("ends beyond its buffer view"), std::string::npos);
  std::string index = gltf("");
  index.replace(index.find("\"indices\":1"), 11, "\"indices\":7");
  EXPECT_NE(refusal(index).find("does not exist"), std::string::npos);
}

TEST(DamagedModels, MutatedRadianceScenesAreRefusedOrRead) {
  const std::string scene =
      "void plastic wood 0 0 5 .5 .3 .2 0 0\nwood polygon top 0 0 12 1 1 .7 2 1 .7 2 2 .7 1 2 .7\nwood sphere ball 0 0 "
      "4 "
      "3 1 1 .2\nvoid alias oak wood\noak cone c 0 0 8 0 0 0 0 0 1 1 .5\n";
  std::mt19937_64 random(4);
  for (int k = 0; k < 5000; ++k) {
    try {
      const RadianceScene read = readRadianceScene(mutated(scene, random), "m.rad");
      for (const auto& t : read.mesh.triangles)
        for (const auto vertex : t) ASSERT_LT(vertex, read.mesh.vertices.size());
    } catch (const core::InputError& error) {
      ASSERT_FALSE(error.diagnostics().all().empty());
    }
  }
}

}  // namespace
}  // namespace goniolux::geometry
