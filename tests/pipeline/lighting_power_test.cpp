// Utilance, power density and percentiles of rooms with known answers.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "pipeline/engine.h"
#include "pipeline/illuminate.h"
#include "project/project.h"
#include "support/temporary_folder.h"

namespace goniolux::pipeline {
namespace {

project::Results resultsOf(const std::string& text) {
  const test::TemporaryFolder folder;
  const project::Project project = project::readProject(folder.write("project.json", text).string());
  core::SilentProgress silent;
  return calculateGrids(project, Engine(project, false), silent);
}

// A lamp in the middle of a black cube of 2 m gives each face a sixth of its light; the grid is the whole floor. The
// mean over cell centres stands for the integral: with 40 x 40 cells of a smooth function it is right to 1e-4.
std::string blackCube(const std::string& maintenance) {
  return R"({
  "format": "goniolux-project", "version": 1,
  "materials": { "black": { "model": "lambert", "diffuse": 0 } },
  "objects": [ { "name": "room", "shape": "box", "min": [0,0,0], "max": [2,2,2], "facing": "inward", "material": "black" } ],
  "luminaires": [ { "name": "L", "photometry": "isotropic", "flux": 1200, "position": [1,1,1], "maintenance": )" +
         maintenance + R"( } ],
  "grids": [ { "name": "floor", "origin": [0,0,0.0001], "u": [2,0,0], "v": [0,2,0], "counts": [40,40], "normal": [0,0,1] } ] })";
}

TEST(LightingPower, ALampInACubeGivesItsFloorASixthOfItsLight) {
  const project::Results results = resultsOf(blackCube("1.0"));
  ASSERT_TRUE(results.power);
  EXPECT_NEAR(results.power->flux_lm, 1200, 1e-6);
  EXPECT_NEAR(results.power->floorArea_m2.value_or(0), 4, 1e-9);
  EXPECT_FALSE(results.power->connectedLoad_W) << "this lamp does not state its watts";
  ASSERT_TRUE(results.grids.at(0).utilance);
  const core::Estimate& utilance = *results.grids[0].utilance;
  EXPECT_NEAR(utilance.value, 1.0 / 6, utilance.halfWidth() + 2e-4);
  EXPECT_NEAR(utilance.halfWidth() / utilance.value, results.grids[0].mean.halfWidth() / results.grids[0].mean.value,
              1e-9);
}

TEST(LightingPower, MaintenanceChangesTheFluxAndNotTheUtilance) {
  const project::Results results = resultsOf(blackCube("0.5"));
  EXPECT_NEAR(results.power->flux_lm, 600, 1e-6);
  EXPECT_NEAR(results.grids.at(0).utilance->value, 1.0 / 6, results.grids[0].utilance->halfWidth() + 2e-4);
}

TEST(LightingPower, TheLoadOverTheFloorIsThePowerDensity) {
  const test::TemporaryFolder folder;
  folder.write("lamp.ies", "IESNA:LM-63-2002\nTILT=NONE\n1 1000 1 3 1 1 2 0 0 0\n1 1 40\n0 45 90\n0\n100 100 100\n");
  std::string text = blackCube("1.0");
  const std::string lamp = R"("photometry": "isotropic", "flux": 1200,)";
  text.replace(
      text.find(lamp), lamp.size(),
      R"("photometry": "lamp.ies", "array": { "counts": [2,1], "u": [0.5,0,0], "v": [0,0.5,0] }, "shape": "point", "dimming": 0.5,)");
  const project::Project project = project::readProject(folder.write("project.json", text).string());
  core::SilentProgress silent;
  const project::Results results = calculateGrids(project, Engine(project, false), silent);
  EXPECT_NEAR(results.power->connectedLoad_W.value_or(0), 80, 1e-9) << "dimming does not change what is installed";
  ASSERT_TRUE(results.power->density_W_m2);
  EXPECT_NEAR(results.power->density_W_m2->value, 20, 1e-9);
  ASSERT_TRUE(results.grids.at(0).powerPer100lx);
  EXPECT_NEAR(results.grids[0].powerPer100lx->value, 100 * 20 / results.grids[0].mean.value, 1e-9);
}

// Direct light of that lamp, E = I cos^3 / h^2, grows towards the middle: its percentiles over the floor's cells are
// those of the formula at their centres.
TEST(LightingPower, PercentilesAreThoseOfTheInverseSquareLaw) {
  const project::Results results = resultsOf(blackCube("1.0"));
  const project::GridResult& grid = results.grids.at(0);
  std::vector<double> exact;
  for (const core::Vec3& p : grid.points) {
    const double r2 = (p.x - 1) * (p.x - 1) + (p.y - 1) * (p.y - 1) + (p.z - 1) * (p.z - 1);
    exact.push_back(1200 / (4 * core::pi) * (1 - p.z) / std::pow(r2, 1.5));
  }
  std::sort(exact.begin(), exact.end());
  ASSERT_EQ(grid.percentiles.size(), 5u);
  for (const auto& [percent, estimate] : grid.percentiles) {
    const double place = 0.01 * percent * static_cast<double>(exact.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const double expected = exact[below] + (place - static_cast<double>(below)) *
                                               (exact[std::min(below + 1, exact.size() - 1)] - exact[below]);
    EXPECT_NEAR(estimate.value, expected, estimate.halfWidth() + 1e-3 * expected) << percent << " %";
  }
}

}  // namespace
}  // namespace goniolux::pipeline
