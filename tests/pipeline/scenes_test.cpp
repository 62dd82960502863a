// Lighting scenes by superposition: groups calculated once, scenes are sums; nothing is traced twice.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "pipeline/scene_groups.h"
#include "pipeline/stages.h"
#include "support/temporary_folder.h"

namespace goniolux::pipeline {
namespace {

using core::Value;

// A black room with two points of light: E = I cos / d2, without any interreflection.
std::string projectText(const std::string& dimming, const std::string& factor) {
  return R"({ "format": "goniolux-project", "version": 1, "name": "two groups", "units": "m",
    "materials": { "black": { "model": "lambert", "diffuse": 0.0 } },
    "objects": [ { "name": "room", "shape": "box", "min": [-9,-9,0], "max": [9,9,4], "facing": "inward", "material": "black" } ],
    "luminaires": [
      { "name": "A", "photometry": "isotropic", "flux": 1256.6370614, "position": [0,0,2.5], "group": "left", "dimming": )" +
         dimming + R"( },
      { "name": "B", "photometry": "isotropic", "flux": 2513.2741229, "position": [1,0,2.5], "group": "right" } ],
    "scenes": [ { "name": "half", "groups": { "left": )" +
         factor + R"(, "right": 1 } }, { "name": "right only", "groups": { "right": 1 } } ],
    "grids": [ { "name": "g", "points": [[0,0,0.5],[1,0,0.5],[2,0,0.5]], "normal": [0,0,1], "quantity": "illuminance" } ] })";
}

double lit(double flux, double dx) {
  const double d2 = 4 + dx * dx;
  return flux / (4 * core::pi) / d2 * 2 / std::sqrt(d2);
}

Value runScenes(const std::string& folder, StageReport& report) {
  StageRequest request;
  request.inputs = {folder};
  core::SilentProgress silent;
  report = scenesStage().run(request, silent);
  return report.json;
}

double valueOf(const Value& report, std::size_t scene, std::size_t point) {
  return report.find("scenes")->array()[scene].find("grids")->array()[0].find("values")->array()[point].number();
}

TEST(Scenes, AreSumsOfTheirGroupsAndALevelNeedsNoNewTrace) {
  const test::TemporaryFolder folder;
  folder.write("project.json", projectText("0.5", "0.25"));
  StageReport report;
  const Value first = runScenes(folder.path().string(), report);
  EXPECT_EQ(first.find("groups_calculated")->number(), 2);
  ASSERT_EQ(first.find("scenes")->array().size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    const double x = static_cast<double>(i), a = lit(1256.6370614, x), b = lit(2513.2741229, x - 1);
    EXPECT_NEAR(valueOf(first, 0, i), 0.5 * a + b, 1e-3);
    EXPECT_NEAR(valueOf(first, 1, i), 0.25 * 0.5 * a + b, 1e-3);
    EXPECT_NEAR(valueOf(first, 2, i), b, 1e-3);
  }
  // Another level in the project and in the scene: everything is kept.
  folder.write("project.json", projectText("0.8", "0.1"));
  const Value second = runScenes(folder.path().string(), report);
  EXPECT_EQ(second.find("groups_calculated")->number(), 0);
  EXPECT_EQ(second.find("groups_kept")->number(), 2);
  EXPECT_NEAR(valueOf(second, 0, 0), 0.8 * lit(1256.6370614, 0) + lit(2513.2741229, 1), 1e-3);
  EXPECT_NEAR(valueOf(second, 1, 0), 0.08 * lit(1256.6370614, 0) + lit(2513.2741229, 1), 1e-3);
  // Another flux is another light: both are traced anew.
  std::string brighter = projectText("0.8", "0.1");
  brighter.replace(brighter.find("2513"), 4, "2613");
  folder.write("project.json", brighter);
  EXPECT_EQ(runScenes(folder.path().string(), report).find("groups_calculated")->number(), 2);
}

// A surface that emits is lit once, not once with every group; glare ratings are not added up.
TEST(Scenes, CountEmittingSurfacesOnce) {
  const test::TemporaryFolder folder;
  std::string text = projectText("0.5", "0.25");
  text.replace(text.find("\"diffuse\": 0.0 }"), 16,
               "\"diffuse\": 0.0 }, \"glow\": { \"model\": \"lambert\", \"diffuse\": 0, \"exitance_lm_m2\": 100 }");
  text.replace(text.find("\"material\": \"black\""), 19, "\"materials\": { \"*\": \"black\", \"ceiling\": \"glow\" }");
  text.replace(text.find("\"grids\""), 7,
               "\"observers\": [ { \"name\": \"o\", \"eye\": [0,0,1], \"direction\": [1,0,0] } ], \"grids\"");
  folder.write("project.json", text);
  StageReport report;
  const Value scenes = runScenes(folder.path().string(), report);
  EXPECT_EQ(scenes.find("groups_calculated")->number(), 3);
  EXPECT_TRUE(scenes.find("scenes")->array()[0].find("observers")->array().empty());
  // The ceiling 18 m x 18 m, 3.5 m above the point in its middle: exitance times the form factor of its four quarters.
  const double a = 9 / 3.5, s = std::sqrt(1 + a * a);
  const double ceiling = 100 * 4 * (2 * a / s * std::atan(a / s)) / (2 * core::pi);
  EXPECT_NEAR(valueOf(scenes, 2, 0), lit(2513.2741229, 1) + ceiling, 0.02 * ceiling);
}

TEST(Superposition, AddsStatisticsInSquaresAndBoundsInFull) {
  project::GridResult grid;
  grid.points = {{0, 0, 0}, {1, 0, 0}};
  grid.values = {100, 200};
  grid.parts = {{"statistical", {3, 3}}, {"spectral", {1, 2}}};
  grid.mean.value = 150;
  grid.mean.statistical = 3;
  project::Results one;
  one.grids = {grid};
  project::Results two = one;
  two.grids[0].parts["statistical"] = {4, 4};
  two.grids[0].mean.statistical = 4;
  const project::Results sum = superposed({{"a", one}, {"b", two}}, {{"a", 1}, {"b", 1}});
  EXPECT_DOUBLE_EQ(sum.grids[0].values[1], 400);
  EXPECT_DOUBLE_EQ(sum.grids[0].parts.at("statistical")[0], 5);
  EXPECT_DOUBLE_EQ(sum.grids[0].parts.at("spectral")[1], 4);
  EXPECT_DOUBLE_EQ(sum.grids[0].halfWidths[0], 7);
  EXPECT_DOUBLE_EQ(sum.grids[0].mean.statistical, 5);
  EXPECT_DOUBLE_EQ(sum.grids[0].min.value, 200);
  EXPECT_NEAR(sum.grids[0].u0.value, 200.0 / 300, 1e-12);
  const project::Results off = superposed({{"a", one}, {"b", two}}, {{"a", 0.5}});
  EXPECT_DOUBLE_EQ(off.grids[0].values[0], 50);
  EXPECT_DOUBLE_EQ(off.grids[0].halfWidths[0], 2);
}

}  // namespace
}  // namespace goniolux::pipeline
