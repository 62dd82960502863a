// Pictures that models wear come along as textures of the project's new materials.
#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>

#include "display/picture_file.h"
#include "pipeline/import_room.h"
#include "project/project.h"
#include "spectrum/cie_data.h"
#include "spectrum/colorimetry.h"
#include "support/temporary_folder.h"

namespace goniolux::pipeline {
namespace {

// Two by one pixels: sRGB codes 255 and 188, the latter 0.5029 of the former.
std::string blackAndGrey(std::uint16_t left, std::uint16_t right) {
  display::CodeImage image;
  image.width = 2;
  image.height = 1;
  image.bits = 8;
  image.rgb = {left, left, left, right, right, right};
  return display::encodePng(image, display::readDevice("srgb"));
}

const material::Material& materialNamed(const project::Project& project, const std::string& name) {
  for (const material::Material& material : project.environment.materials)
    if (material.name == name) return material;
  throw std::runtime_error("no such material");
}

double luminousReflectance(const material::Material& material) {
  return spectrum::tristimulus(material.spectra.at("diffuse"), *spectrum::illuminant("CIE D65")).Y;
}

const std::string squareObj =
    "mtllib a.mtl\nv 1 1 1\nv 2 1 1\nv 2 2 1\nv 1 2 1\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
    "usemtl cloth\nf 1/1 2/2 3/3\nusemtl back\nf 1/1 3/3 4/4\n";

TEST(ImportedTextures, OfAnObjAreCopiedAndTheirMeanIsTheReflectance) {
  const test::TemporaryFolder folder, models;
  folder.write("project.json", room);
  models.write("weave.png", blackAndGrey(255, 188));
  models.write("a.mtl", "newmtl cloth\nKd 1 1 1\nmap_Kd weave.png\nnewmtl back\nKd 0.5 0.5 0.5\nmap_Kd weave.png\n");
  const auto model = models.write("a.obj", squareObj);
  const StageReport report = import(model.string(), folder.path().string());
  const project::Project project = project::readProject(folder.path().string());
  const material::Material &cloth = materialNamed(project, "cloth"), &back = materialNamed(project, "back");
  ASSERT_TRUE(cloth.texture && back.texture);
  const double mean = 0.5 * (1 + 0.5029);
  EXPECT_NEAR(luminousReflectance(cloth), mean, 1e-3);
  EXPECT_NEAR(luminousReflectance(back), 0.5 * mean, 1e-3) << "the model's Kd darkens the picture";
  ASSERT_EQ(project.environment.objects[1].shape.mesh.coordinates.size(), 2U);
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "models" / "a-1.png"));
}

TEST(ImportedTextures, OfAGltfAreTakenOutOfItWithTheirCoordinates) {
  const test::TemporaryFolder folder, models;
  folder.write("project.json", room);
  const std::string picture = blackAndGrey(0, 255);
  std::string data;
  const auto add = [&](const auto& value) { data.append(reinterpret_cast<const char*>(&value), sizeof value); };
  for (const float x : {0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F}) add(x);
  for (const float x : {0.F, 1.F, 1.F, 1.F, 0.F, 0.F}) add(x);  // glTF's v runs downwards
  for (const int index : {0, 1, 2, 0}) add(static_cast<std::uint16_t>(index));
  const std::size_t pictureAt = data.size();
  data += picture;
  while (data.size() % 4 != 0) data += '\0';
  std::string json =
      R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],)"
      R"("meshes":[{"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":1},"indices":2,"material":0}]}],)"
      R"("materials":[{"name":"poster","pbrMetallicRoughness":{"baseColorTexture":{"index":0}}}],)"
      R"("textures":[{"source":0}],"images":[{"bufferView":3,"mimeType":"image/png"}],)"
      R"("accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]},)"
      R"({"bufferView":1,"componentType":5126,"count":3,"type":"VEC2"},)"
      R"({"bufferView":2,"componentType":5123,"count":3,"type":"SCALAR"}],)"
      R"("bufferViews":[{"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":24},)"
      R"({"buffer":0,"byteOffset":60,"byteLength":6},{"buffer":0,"byteOffset":)" +
      std::to_string(pictureAt) + R"(,"byteLength":)" + std::to_string(picture.size()) +
      R"(}],"buffers":[{"byteLength":)" + std::to_string(data.size()) + "}]}";
  while (json.size() % 4 != 0) json += ' ';
  std::string glb;
  const auto word = [&](std::size_t n) {
    const auto value = static_cast<std::uint32_t>(n);
    glb.append(reinterpret_cast<const char*>(&value), sizeof value);
  };
  glb += "glTF";
  word(2), word(12 + 8 + json.size() + 8 + data.size());
  word(json.size()), glb += "JSON" + json;
  word(data.size()), glb += std::string("BIN\0", 4) + data;
  const auto model = models.write("poster.glb", glb);
  (void)import(model.string(), folder.path().string());
  const project::Project project = project::readProject(folder.path().string());
  const material::Material& poster = materialNamed(project, "poster");
  ASSERT_TRUE(poster.texture);
  EXPECT_NEAR(luminousReflectance(poster), 0.5, 2e-3);
  const auto& corners = project.environment.objects[1].shape.mesh.coordinates.at(0);
  EXPECT_NEAR(corners[0].x, 0, 1e-6);
  EXPECT_NEAR(corners[0].y, 0, 1e-6) << "upwards";
  EXPECT_NEAR(corners[2].y, 1, 1e-6);
}

TEST(ImportedTextures, ThatCannotBeReadAreLeftOutWithAWarning) {
  const test::TemporaryFolder folder, models;
  folder.write("project.json", room);
  models.write("weave.png", "no picture at all");
  models.write("a.mtl", "newmtl cloth\nmap_Kd weave.png\nnewmtl back\nmap_Kd missing.jpg\n");
  const auto model = models.write("a.obj", squareObj);
  const StageReport report = import(model.string(), folder.path().string());
  int left = 0;
  for (const auto& each : report.warnings.all()) left += each.message.find("is left out") != std::string::npos;
  EXPECT_EQ(left, 2);
  const project::Project project = project::readProject(folder.path().string());
  EXPECT_FALSE(materialNamed(project, "cloth").texture);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "models" / "a-1.png"));
}

TEST(ImportedTextures, GiveWayToTheMaterialsOfAMapping) {
  const test::TemporaryFolder folder, models;
  folder.write("project.json", room);
  models.write("weave.png", blackAndGrey(255, 188));
  models.write("a.mtl", "newmtl cloth\nmap_Kd weave.png\nnewmtl back\nmap_Kd weave.png\n");
  const auto model = models.write("a.obj", squareObj);
  const auto map = models.write("map.json", R"({ "*": "grey" })");
  (void)import(model.string(), folder.path().string(), {{"materials", map.string()}});
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "models" / "a-1.png"));
}

}  // namespace
}  // namespace goniolux::pipeline
