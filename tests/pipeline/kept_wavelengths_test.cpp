// Groups kept per wavelength: another lamp spectrum needs no new trace, and gives what a full calculation gives.
#include "pipeline/kept_wavelengths.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "pipeline/illuminate.h"
#include "pipeline/scene_groups.h"
#include "pipeline/stages.h"
#include "spectrum/cie_data.h"
#include "support/temporary_folder.h"

namespace goniolux::pipeline {
namespace {

using core::Value;

// Green walls and a red floor: what the lamps' spectra do is seen.
std::string projectText(const std::string& left, const std::string& walls) {
  return R"({ "format": "goniolux-project", "version": 1, "name": "coloured", "units": "m",
    "materials": {
      "walls": { "model": "lambert", "diffuse": )" +
         walls + R"( },
      "floor": { "model": "lambert", "diffuse": )" +
         (walls == "0.5" ? "0.2" : R"({ "wavelengths": [400, 560, 610, 700], "values": [0.05, 0.06, 0.6, 0.7] })") +
         R"( },
      "ceiling": { "model": "lambert", "diffuse": 0.8 } },
    "objects": [ { "name": "room", "shape": "box", "min": [0,0,0], "max": [4,3,2.5], "facing": "inward",
      "materials": { "floor": "floor", "walls": "walls", "ceiling": "ceiling" } } ],
    "luminaires": [
      { "name": "A", "photometry": "cosine", "flux": 3000, "position": [1,1.5,2.4], "group": "left", "spectrum": )" +
         left + R"( },
      { "name": "B", "photometry": "isotropic", "flux": 1000, "position": [3,1.5,2], "group": "right", "spectrum": "CIE A" } ],
    "settings": { "accuracy": { "grid": "5 %", "u0": "20 %" } },
    "grids": [
      { "name": "plane", "origin": [0.2,0.2,0.8], "u": [3.6,0,0], "v": [0,2.6,0], "counts": [8,6], "normal": [0,0,1] },
      { "name": "eye", "points": [[2,1.5,1.2],[1,1,1.2]], "normal": [1,0,0], "quantity": "melanopic-edi" } ] })";
}

const std::string green = R"({ "wavelengths": [400, 480, 540, 600, 700], "values": [0.1, 0.2, 0.7, 0.15, 0.1] })";

Value scenesOf(const std::string& folder, const std::string& keep = "spectra") {
  StageRequest request;
  request.inputs = {folder};
  request.options = {{"keep", keep}};
  core::SilentProgress silent;
  return scenesStage().run(request, silent).json;
}

Value fullRun(const std::string& folder) {
  StageRequest request;
  request.inputs = {folder};
  core::SilentProgress silent;
  return illuminateStage().run(request, silent).json;
}

TEST(KeptWavelengths, GiveAnotherLampWithoutANewTraceWhatAFullRunGives) {
  const test::TemporaryFolder folder;
  const std::string path = folder.path().string();
  folder.write("project.json", projectText("\"CIE FL11\"", green));
  const Value first = scenesOf(path);
  EXPECT_GE(first.find("groups_calculated")->number(), 2 * 5);
  int points = 0, outside = 0;
  double before = 0;
  for (const char* lamp : {"CIE FL11", "CIE LED-B3", "CIE A", "CIE LED-RGB1", "CIE HP1"}) {
    SCOPED_TRACE(lamp);
    folder.write("project.json", projectText("\"" + std::string(lamp) + "\"", green));
    const Value again = scenesOf(path), full = fullRun(path);
    EXPECT_EQ(again.find("groups_calculated")->number(), 0);
    for (std::size_t g = 0; g < 2; ++g) {
      const Value &a = again.find("scenes")->array()[0].find("grids")->array()[g], &b = full.find("grids")->array()[g];
      EXPECT_EQ(a.find("quantity")->string(), b.find("quantity")->string());
      EXPECT_EQ(a.find("unit")->string(), b.find("unit")->string());
      for (std::size_t i = 0; i < a.find("values")->array().size(); ++i) {
        const auto at = [i](const Value& grid, const char* key) { return grid.find(key)->array()[i].number(); };
        const double apart = std::abs(at(a, "values") - at(b, "values"));
        ++points;
        outside += apart > at(a, "half_widths") + at(b, "half_widths");
        EXPECT_LT(apart, 0.1 * at(b, "values")) << i;
      }
      const auto mean = [](const Value& grid, const char* key) { return grid.find("mean")->find(key)->number(); };
      std::printf("%-12s %-6s kept %8.3f +- %.3f, full run %8.3f +- %.3f\n", lamp, a.find("name")->string().c_str(),
                  mean(a, "value"), mean(a, "half_width"), mean(b, "value"), mean(b, "half_width"));
      EXPECT_LT(std::abs(mean(a, "value") - mean(b, "value")), mean(a, "half_width") + mean(b, "half_width"));
      if (g == 0 && std::string(lamp) == "CIE FL11") before = mean(a, "value");
      if (g == 0 && std::string(lamp) == "CIE HP1") {
        // The negative control: this lamp's light is not that of the first.
        EXPECT_GT(std::abs(mean(b, "value") - before), 4 * mean(b, "half_width"));
      }
    }
  }
  // Two 95 % intervals that are both missed by a point are rare: fewer than 2 % of the points.
  std::printf("%d of %d points outside both intervals\n", outside, points);
  EXPECT_LE(outside, points / 50);
}

TEST(KeptWavelengths, AreOneInAGreyRoomWhateverTheLamp) {
  const test::TemporaryFolder folder;
  const std::string path = folder.path().string();
  folder.write("project.json", projectText("\"CIE FL11\"", "0.5"));
  const Value first = scenesOf(path);
  EXPECT_EQ(first.find("groups_calculated")->number(), 2);
  folder.write("project.json", projectText("\"CIE HP1\"", "0.5"));
  const Value second = scenesOf(path);
  EXPECT_EQ(second.find("groups_calculated")->number(), 0);
  const auto grid = [](const Value& scenes, std::size_t g) {
    return scenes.find("scenes")->array()[0].find("grids")->array()[g].find("mean")->find("value")->number();
  };
  EXPECT_EQ(grid(first, 0), grid(second, 0));
  EXPECT_GT(grid(first, 1), 1.2 * grid(second, 1));  // sodium light is poor in melanopic response
  // Other finishes are another room.
  folder.write("project.json", projectText("\"CIE HP1\"", green));
  EXPECT_GT(scenesOf(path).find("groups_calculated")->number(), 2);
}

TEST(KeptWavelengths, DependOnTheFinishesAndNotOnTheLamps) {
  const test::TemporaryFolder folder;
  const auto wavelengths = [&](const std::string& lamp) {
    folder.write("project.json", projectText(lamp, green));
    const project::Project project = project::readProject(folder.path().string());
    return KeptWavelengths(project, scene::buildWorld(project.environment)).wavelengths();
  };
  EXPECT_EQ(wavelengths("\"CIE FL2\""), wavelengths("{ \"lines\": [[589, 1]] }"));
}

TEST(KeptWavelengths, OfAFileThatOnlyALampNamesDoNotDependOnThatFile) {
  const test::TemporaryFolder folder;
  const auto key = [&](const std::string& lamp, LampSpectra spectra) {
    folder.write("lamp.spd", lamp);
    folder.write("project.json", projectText("\"lamp.spd\"", green));
    return groupKey(project::readProject(folder.path().string()), spectra);
  };
  const std::string warm = "400 1\n700 5\n", cold = "400 5\n700 1\n";
  EXPECT_EQ(key(warm, LampSpectra::doNotMatter), key(cold, LampSpectra::doNotMatter));
  EXPECT_NE(key(warm, LampSpectra::matter), key(cold, LampSpectra::matter));
}

TEST(KeptWavelengths, RefuseAGroupOfDifferentLamps) {
  const test::TemporaryFolder folder;
  std::string text = projectText("\"CIE FL11\"", green);
  text.replace(text.find("\"right\""), 7, "\"left\"");
  folder.write("project.json", text);
  try {
    (void)scenesOf(folder.path().string());
    ADD_FAILURE() << "two lamps in one group were taken";
  } catch (const core::InputError& error) {
    EXPECT_EQ(error.diagnostics().all().front().rule, "spectra-within-group");
    EXPECT_GT(error.diagnostics().all().front().position.line, 0);
  }
  EXPECT_THROW(scenesOf(folder.path().string(), "everything"), core::InputError);
}

}  // namespace
}  // namespace goniolux::pipeline
