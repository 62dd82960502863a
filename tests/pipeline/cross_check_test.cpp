// Two solvers on one project: they agree on a room, a planted difference is found with its place, noise is not.
#include "pipeline/cross_check.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <random>

#include "pipeline/stage.h"
#include "support/temporary_folder.h"

namespace goniolux::pipeline {
namespace {

constexpr double t95 = 2.1314;  // Student's t, 15 degrees of freedom, 95 %

/// 40 points of 100 lx and their mean, measured with noise of 1 lx by 16 replicates each.
project::Results measured(std::mt19937& random, double common = 0, std::size_t planted = 40, double more = 0) {
  std::normal_distribution<double> normal;
  project::Results results;
  project::GridResult grid;
  grid.name = "work plane";
  const auto estimate = [&](double truth, double standardError) {
    double sum = 0, squares = 0;
    for (int r = 0; r < 16; ++r) {
      const double x = truth + 4 * standardError * normal(random);
      sum += x / 16;
      squares += x * x / 16;
    }
    core::Estimate e;
    e.value = sum;
    e.statistical = t95 * std::sqrt(std::max(0.0, squares - sum * sum) / 15);
    return e;
  };
  for (std::size_t i = 0; i < 40; ++i) {
    const core::Estimate e = estimate(100 + common + (i == planted ? more : 0), 1);
    grid.points.push_back({0.5 + static_cast<double>(i), 1, 0.8});
    grid.values.push_back(e.value);
    grid.halfWidths.push_back(e.statistical);
    grid.parts["statistical"].push_back(e.statistical);
  }
  grid.mean = estimate(100 + common, 0.05);
  results.grids = {grid};
  return results;
}

TEST(CrossCheck, NamesThePlaceThatDiffers) {
  std::mt19937 random(1);
  const project::Results one = measured(random), other = measured(random, 0, 17, 15);
  const CrossCheck check = compareSolvers(one, other, 0.01);
  ASSERT_EQ(check.places.size(), 1u);
  EXPECT_EQ(check.places[0].point, 17u);
  EXPECT_NEAR(check.places[0].position.x, 17.5, 1e-12);
  EXPECT_FALSE(check.agrees());
  EXPECT_GT(check.differences[0].values[17], 3);
  EXPECT_NE(textOf(check).find("point 17 at (17.5, 1, 0.8) m"), std::string::npos) << textOf(check);
}

TEST(CrossCheck, SeesInTheMeanWhatPointsAreTooNoisyFor) {
  std::mt19937 random(5);
  const project::Results one = measured(random), other = measured(random, 0.6);
  const CrossCheck check = compareSolvers(one, other, 0.01);
  EXPECT_TRUE(check.places.empty());
  EXPECT_TRUE(check.means[0].disagrees);
}

// Stated: at most 1 % of runs that agree are flagged. Of 400, 4; more than 12 come by chance three times in 10 000.
TEST(CrossCheck, KeepsItsRateOfFalseAlarms) {
  std::mt19937 random(3);
  int flagged = 0;
  for (int run = 0; run < 400; ++run)
    flagged += compareSolvers(measured(random), measured(random), 0.01).agrees() ? 0 : 1;
  EXPECT_LE(flagged, 12);
}

TEST(CrossCheck, IsAVerbWithAPictureAndAgreesOnARoom) {
  test::TemporaryFolder folder;
  folder.write("project.json", R"({ "format": "goniolux-project", "version": 1, "name": "room",
      "materials": { "grey": { "model": "lambert", "diffuse": 0.5 } },
      "objects": [ { "name": "room", "shape": "box", "min": [0,0,0], "max": [4,3,2.5], "facing": "inward", "material": "grey" } ],
      "luminaires": [ { "name": "L", "photometry": "isotropic", "flux": 3000, "position": [2,1.5,2] } ],
      "grids": [ { "name": "work plane", "origin": [0,0,0.8], "u": [4,0,0], "v": [0,3,0], "counts": [8,6] } ],
      "settings": { "accuracy": { "grid": "5 %" } } })");
  StageRequest request;
  request.inputs = {folder.path().string()};
  request.common.output = (folder.path() / "out").string();
  request.options["cross"] = "1";
  core::SilentProgress silent;
  for (const Stage& stage : stages()) {
    if (stage.name != "check") continue;
    const StageReport report = stage.run(request, silent);
    EXPECT_FALSE(report.verdictFailed) << report.text;
    const core::Value* cross = report.json.find("cross");
    ASSERT_NE(cross, nullptr);
    EXPECT_TRUE(cross->find("agree")->boolean());
    EXPECT_EQ(cross->find("solvers")->array()[0].string(), "gather");
    EXPECT_EQ(cross->find("solvers")->array()[1].string(), "path");
    EXPECT_EQ(cross->find("points")->number(), 48);
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "out" / "cross-work-plane.figure.json"));
  }
}

}  // namespace
}  // namespace goniolux::pipeline
