// `goniolux check --fix`: the new project is free of what was mended, and the old one is as it was.
#include <gtest/gtest.h>

#include "pipeline/stages.h"
#include "project/project.h"
#include "support/temporary_folder.h"

namespace goniolux::pipeline {
namespace {

const std::string project = R"({ "format": "goniolux-project", "version": 1,
  "materials": { "grey": { "model": "lambert", "diffuse": 0.5 }, "red": { "model": "lambert", "diffuse": 0.3 } },
  "objects": [ // the room
    { "name": "room", "shape": "box", "min": [0,0,0], "max": [4,3,2.5], "facing": "inward", "material": "grey" },
    { "name": "rug", "shape": "rectangle", "origin": [1,1,0], "u": [1,0,0], "v": [0,1,0], "material": "red" },
    { "name": "thing", "shape": "mesh", "file": "thing.obj", "material": "grey" } ],
  "luminaires": [ { "photometry": "isotropic", "flux": 1000, "position": [2,1.5,2] } ],
  "grids": [ { "name": "plane", "origin": [0,0,0.8], "u": [4,0,0], "v": [0,3,0], "counts": [4,3] } ] }
)";
// A tetrahedron whose last face stands off by 3 micrometres, with one triangle twice and one the wrong way round.
const std::string model =
    "v 2 2 0.5\nv 2.5 2 0.5\nv 2 2.5 0.5\nv 2 2 1\nv 2.500003 2 0.5\nv 2 2.500003 0.5\nv 2 2 1.000003\n"
    "f 1 3 2\nf 1 3 2\nf 1 2 4\nf 1 3 4\nf 5 6 7\n";

StageReport check(const std::filesystem::path& file, const std::string& fix = "") {
  core::SilentProgress silent;
  StageRequest request;
  request.inputs = {file.string()};
  if (!fix.empty()) request.options["fix"] = fix;
  return checkStage().run(request, silent);
}

TEST(Repair, PartsSurfacesInOnePlaneAndClosesCrackedMeshes) {
  const test::TemporaryFolder folder;
  const auto file = folder.write("project.json", project);
  folder.write("thing.obj", model);
  ASSERT_FALSE(project::readProject(file.string()).environment.objects[2].shape.closed);
  const auto mended = folder.path() / "mended.json";
  const StageReport report = check(file, mended.string());
  ASSERT_FALSE(report.inputFailed) << report.text << toString(report.warnings.all().front());
  EXPECT_EQ(report.json.find("repairs")->array().size(), 2U) << report.text;
  EXPECT_EQ(test::contentOf(file), project);
  EXPECT_NE(test::contentOf(mended).find("// the room"), std::string::npos) << "comments outside stay";
  EXPECT_TRUE(project::readProject(mended.string()).environment.objects[2].shape.closed);
  const StageReport again = check(mended);
  for (const auto& d : again.warnings.all()) EXPECT_NE(d.rule, "coincident") << d.message;
  EXPECT_TRUE(check(file, mended.string()).inputFailed) << "the file is there already";
}

TEST(Repair, WritesNothingWhenNothingNeedsIt) {
  const test::TemporaryFolder folder;
  const auto file = folder.write("project.json", project.substr(0, project.find(",\n    { \"name\": \"rug\"")) + " ]" +
                                                     project.substr(project.find(",\n  \"luminaires\"")));
  const auto mended = folder.path() / "mended.json";
  EXPECT_TRUE(check(file, mended.string()).json.find("repairs")->array().empty());
  EXPECT_FALSE(std::filesystem::exists(mended));
}

}  // namespace
}  // namespace goniolux::pipeline
