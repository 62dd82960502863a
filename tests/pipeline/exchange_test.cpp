// Models into projects and scenes out of them: what goes out comes back with the same area.
#include <gtest/gtest.h>

#include <cmath>

#include "geometry/mesh_import.h"
#include "geometry/queries.h"
#include "geometry/radiance_scene.h"
#include "pipeline/import_room.h"
#include "pipeline/scene_export.h"
#include "pipeline/stages.h"
#include "project/project.h"
#include "project/project_text.h"
#include "support/temporary_folder.h"

namespace goniolux::pipeline {
namespace {

const std::string source = GONIOLUX_SOURCE_DIR;

TEST(ProjectText, AddsEntriesAndKeepsCommentsAndTheRest) {
  project::ProjectText text(room, "project.json");
  text.appendTo("objects", core::Value::Object{{"name", "x"}, {"shape", "sphere"}});
  text.addMember("materials", "a \"b\"", core::Value::Object{{"model", "lambert"}});
  text.addMember("settings", "seed", 3);
  EXPECT_EQ(text.root().find("objects")->array().size(), 2U);
  EXPECT_NE(text.root().find("materials")->find("a \"b\""), nullptr);
  EXPECT_EQ(text.root().find("settings")->find("seed")->number(), 3);
  for (const char* comment : {"// a comment stays", "// last"})
    EXPECT_NE(text.text().find(comment), std::string::npos) << text.text();
  text.replace(*text.root().find("objects")->array()[1].find("name"), "y");
  EXPECT_EQ(text.root().find("objects")->array()[1].find("name")->string(), "y");
}

TEST(ImportStage, AMeshBecomesAnObjectAndItsUnmappedMaterialsAreListed) {
  const test::TemporaryFolder folder;
  folder.write("project.json", room);
  const auto model = folder.write("chair.obj",
                                  "v 1000 1000 0\nv 2000 1000 0\nv 1000 2000 0\nv 1000 1000 1000\n"
                                  "usemtl seat\nf 1 3 2\nf 1 2 4\nusemtl legs\nf 2 3 4\nf 1 4 3\n");
  const auto map = folder.write("map.json", R"({ "seat": "grey" })");
  const StageReport report =
      import(model.string(), folder.path().string(), {{"units", "mm"}, {"materials", map.string()}});
  ASSERT_EQ(report.json.find("unmapped")->array().size(), 1U);
  EXPECT_EQ(report.json.find("unmapped")->array()[0].string(), "legs");
  const project::Project project = project::readProject(folder.path().string());
  ASSERT_EQ(project.environment.objects.size(), 2U);
  EXPECT_NEAR(geometry::volume(project.environment.objects[1].shape), 1.0 / 6, 1e-9);
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "models" / "chair.obj"));
  EXPECT_THROW(import(model.string(), folder.path().string()), core::InputError) << "the name is taken";
}

TEST(ImportStage, ADamagedModelLeavesTheProjectAsItWas) {
  const test::TemporaryFolder folder;
  const auto file = folder.write("project.json", room);
  const auto model = folder.write("bad.obj", "v 1 1 nan\nv 2 1 0\nv 1 2 0\nf 1 2 3\n");
  EXPECT_THROW(import(model.string(), folder.path().string()), core::InputError);
  EXPECT_EQ(test::contentOf(file), room);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "models"));
}

TEST(ImportStage, ARadianceSceneGivesItsSurfacesAndListsTheRestWithItsLine) {
  const test::TemporaryFolder folder;
  folder.write("project.json", room);
  const auto model = folder.write("scene.rad",
                                  "# a scene\nvoid plastic wood 0 0 5 .5 .3 .2 0 0\n"
                                  "wood polygon top 0 0 12 1 1 .7 2 1 .7 2 2 .7 1 2 .7\n"
                                  "wood sphere ball\n0\n0\n4 3 1 1 .2\n"
                                  "void glass pane 0 0 3 .9 .9 .9\n"
                                  "wood ring disc 0 0 8 3 2 1  0 0 1  .1 .3\n"
                                  "!genbox wood box 1 1 1\n");
  const StageReport report = import(model.string(), folder.path().string());
  std::string left;
  for (const auto& d : report.warnings.all()) left += toString(d) + "\n";
  EXPECT_NE(left.find("scene.rad:8: warning: glass \"pane\" is left out"), std::string::npos) << left;
  EXPECT_NE(left.find("scene.rad:10: warning: the command"), std::string::npos) << left;
  const project::Project project = project::readProject(folder.path().string());
  ASSERT_EQ(project.environment.objects.size(), 4U);
  EXPECT_NEAR(geometry::area(project.environment.objects[1].shape), 1, 1e-12);
  EXPECT_NEAR(geometry::area(project.environment.objects[3].shape), core::pi * 0.08, 1e-12);
  EXPECT_NEAR(project.environment.materials[1].spectra.at("diffuse").continuum(555),
              0.265 * .5 + 0.670 * .3 + 0.065 * .2, 1e-12);
}

TEST(ImportStage, DamagedRadianceScenesAreRefusedWithTheirLine) {
  const auto refusal = [](const std::string& text) -> std::string {
    try {
      geometry::readRadianceScene(text, "s.rad");
    } catch (const core::InputError& error) {
      return toString(error.diagnostics().all().front());
    }
    return "";
  };
  EXPECT_NE(refusal("void plastic a 0 0 5 .5 .5\n").find("s.rad:1: error: the file ends"), std::string::npos);
  EXPECT_NE(refusal("void plastic a 0 0 5 .5 .5 x 0 0\n").find("no finite number"), std::string::npos);
  EXPECT_NE(refusal("\na polygon b 0 0 -9\n").find("s.rad:2"), std::string::npos);
  EXPECT_NE(refusal("a polygon b 0 0 999999999999\n").find("whole number"), std::string::npos);
  EXPECT_NE(refusal("a sphere b 0 0 3 1 2 3\n").find("4 are expected"), std::string::npos);
}

TEST(ExportStage, TheSmallOfficeInRadianceHasTheAreaOfItsObjects) {
  const project::Project project = project::readProject(source + "/projects/small-office");
  core::Diagnostics left;
  const FileContents files = radianceFiles(project, left);
  EXPECT_TRUE(left.all().empty());
  EXPECT_TRUE(files.contains("work-plane.pts") && files.contains("door.vf") && files.contains("calculate.sh"));
  // Read a second way, by our own reader of the same format, which knows no luminaires.
  const geometry::RadianceScene scene = geometry::readRadianceScene(files.at("scene.rad"), "scene.rad");
  double openings = 0, rounds = 0, objects = 0;
  for (std::size_t i = 0; i < scene.mesh.triangles.size(); ++i) {
    const auto& t = scene.mesh.triangles[i];
    const core::Vec3 &a = scene.mesh.vertices[t[0]], &b = scene.mesh.vertices[t[1]], &c = scene.mesh.vertices[t[2]];
    const double area = 0.5 * glm::length(glm::cross(b - a, c - a));
    (scene.partNames[scene.mesh.parts[i]][0] == 'l' ? openings : objects) += area;
  }
  for (const auto& round : scene.rounds) {
    using Kind = geometry::RadianceRound::Kind;
    const double height = glm::distance(round.a, round.b);
    if (round.kind == Kind::sphere) rounds += 4 * core::pi * round.r0 * round.r0;
    if (round.kind == Kind::ring) rounds += core::pi * (round.r1 * round.r1 - round.r0 * round.r0);
    if (round.kind == Kind::cylinder) rounds += 2 * core::pi * round.r0 * height;
    if (round.kind == Kind::cone) rounds += core::pi * (round.r0 + round.r1) * std::hypot(height, round.r0 - round.r1);
  }
  double expected = 0;
  for (const auto& object : project.environment.objects) expected += geometry::area(object.shape, object.transform);
  EXPECT_NEAR(objects + rounds, expected, 1e-6 * expected);
  EXPECT_GT(rounds, 1);
  EXPECT_GE(openings, 6 * 0.5 * 0.5);
}

TEST(ExportStage, GltfComesBackThroughTheImporterWithTheSameAreaAndSides) {
  const project::Project project = project::readProject(source + "/projects/small-office");
  core::Diagnostics left;
  const test::TemporaryFolder folder;
  const FileContents files = gltfFile(project, "office.glb", left);
  const auto file = folder.write("office.glb", files.at("office.glb"));
  const geometry::Shape shape = geometry::importMesh(file.string(), 1, true);
  double expected = 0;
  geometry::Bounds box;
  for (const auto& object : project.environment.objects) {
    expected += geometry::area(object.shape, object.transform);
    box.add(geometry::bounds(object.shape, object.transform));
  }
  // Six panels of 0.36 m2 or less are there too; round things as 64-sided ones.
  EXPECT_NEAR(geometry::area(shape), expected, 0.015 * expected);
  EXPECT_GT(geometry::area(shape), expected);
  const geometry::Bounds back = geometry::bounds(shape);
  EXPECT_LT(glm::distance(back.min, box.min) + glm::distance(back.max, box.max), 1e-4);
}

}  // namespace
}  // namespace goniolux::pipeline
