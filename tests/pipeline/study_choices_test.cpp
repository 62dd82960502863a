// Studies of single choices: each against what is known in closed form, and each refuses a project with nothing to
// vary.
#include "pipeline/study_choices.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/progress.h"
#include "pipeline/stages.h"
#include "support/temporary_folder.h"

namespace goniolux::pipeline {
namespace {

// A cube of one reflectance with a lamp in its middle; `more` are further members of the project.
project::Project cube(double rho, const std::string& luminaire, const std::string& material = "") {
  const std::string text = fmt::format(
      "{{ \"format\": \"goniolux-project\", \"version\": 1, \"name\": \"cube\", \"materials\": {{ \"grey\": {} }},\n"
      "\"objects\": [ {{ \"shape\": \"box\", \"min\": [0,0,0], \"max\": [4,4,4], \"facing\": \"inward\", \"material\": "
      "\"grey\" }} ],\n\"luminaires\": [ {{ \"position\": [2,2,2], \"flux\": 10000, {} }} ],\n\"grids\": [ {{ "
      "\"name\": "
      "\"floor\", \"origin\": [0,0,1e-6], \"u\": [4,0,0], \"v\": [0,4,0], \"counts\": [6,6], \"normal\": [0,0,1] }} "
      "],\n"
      "\"views\": [ {{ \"name\": \"view\", \"eye\": [0.5,0.5,1], \"target\": [4,4,2], \"width\": 64, \"height\": 48 }} "
      "] }}\n",
      material.empty() ? fmt::format("{{ \"model\": \"lambert\", \"diffuse\": {} }}", rho) : material, luminaire);
  return project::readProjectText(text, GONIOLUX_SOURCE_DIR "/projects/validation/project.json");
}

constexpr const char* point = "\"photometry\": \"isotropic\"";
constexpr const char* panel =
    "\"photometry\": \"cosine\", \"shape\": { \"rectangle\": { \"length\": 1, \"width\": 1 } }";

ChoiceResult run(const char* name, const project::Project& project) {
  core::SilentProgress silent;
  return findChoiceStudy(name)->run(project, silent);
}

TEST(StudyOfBounces, InARoomOfOneReflectanceFollowsItsPowers) {
  const ChoiceResult result = run("bounces", cube(0.8, point));
  // Not exact at the points of one face, but the powers are.
  double before = 0;
  for (const auto& row : result.rows) {
    const int n = std::stoi(row[0]);
    const double missing = std::stod(row[3]);
    if (n >= 2 && n <= 20) {
      EXPECT_NEAR(missing / before, 0.8, 0.03) << n;
    }
    before = missing;
  }
  EXPECT_NEAR(std::stod(result.rows.front()[3]), 100, 1e-3) << "without reflections all indirect light is missing";
}

TEST(StudyOfNearField, OfASquareIsTheTableOfTheFiveTimesRule) {
  const ChoiceResult result = run("near-field", cube(0.5, panel));
  bool found = false;
  for (const auto& row : result.rows) {
    if (row[1] != "1" || row[2] != "2") continue;
    EXPECT_NEAR(std::stod(row[3]), 8.30, 0.02);  // twice the side: 8.30 %
    found = true;
  }
  EXPECT_TRUE(found);
}

TEST(StudyOfGridSpacing, HasNoErrorWhereItIsTheFinest) {
  const ChoiceResult result = run("grid-spacing", cube(0.2, point));
  ASSERT_GE(result.rows.size(), 4u);
  // Coarser grids miss the corners: the minimum rises.
  EXPECT_GT(std::stod(result.rows.back()[5]), 1.2 * std::stod(result.rows.front()[5]));
}

TEST(StudyOfTreeDepth, LosesNothingWithoutMirrors) {
  const ChoiceResult result = run("tree-depth", cube(0.5, panel));
  for (const auto& row : result.rows) {
    if (row[0] != "adaptive, depth cap") continue;
    EXPECT_NEAR(std::stod(row[2]), 1, 1e-9) << "matt surfaces spawn no rays";
    EXPECT_NEAR(std::stod(row[4]), 0, 1e-6);
  }
}

TEST(StudyOfWavelengths, FindsTheAdaptedOnesBestInAColouredRoom) {
  const ChoiceResult result =
      run("wavelengths", cube(0, point, "{ \"model\": \"lambert\", \"diffuse\": \"red-paint.spd\" }"));
  double adapted = 0, paper = 0;
  for (const auto& row : result.rows) {
    if (row[1] != "9") continue;
    if (row[0] == "adapted") adapted = std::stod(row[2]);
    if (row[0] == "paper") paper = std::stod(row[2]);
  }
  EXPECT_GT(paper, 0);
  EXPECT_LT(adapted, paper);
}

// The paper's Figure 8, small: tristimulus products distort what is seen through both filters, nine samples hardly, as
// many as the scene needs not at all.
TEST(StudyOfSchemes, TristimulusProductsDistortAndNineSamplesHardlyDo) {
  project::Project filters = project::readProject(GONIOLUX_SOURCE_DIR "/projects/figure-8/project.json");
  filters.views.front().width = 24;
  filters.views.front().height = 16;
  const ChoiceResult result = run("schemes", filters);
  EXPECT_EQ(result.chart.curves.size(), 6u);
  for (const auto& curve : result.chart.curves) EXPECT_EQ(curve.points.size(), 24u) << curve.name;
  const auto mean = [&](const std::string& scheme) {
    for (const auto& row : result.rows)
      if (row[0] == scheme) return std::stod(row[2]);
    return std::nan("");
  };
  EXPECT_GT(mean("rgb"), 2);
  EXPECT_GT(mean("meyer"), 2);
  EXPECT_LT(mean("bins"), 1);
  EXPECT_LT(mean("adapted"), 0.2);  // accuracy.colour_de asks for 1
}

TEST(StudyOfReflectionModels, HasACurveForEachAndOneForPaths) {
  const ChoiceResult result = run("reflection-model", cube(0.5, panel));
  EXPECT_EQ(result.chart.curves.size(), 5u);
  for (const auto& curve : result.chart.curves) EXPECT_EQ(curve.points.size(), 160u) << curve.name;
}

TEST(StudyOfReflectionModels, GoesWithoutPathsWhereFinishesAreThePapers) {
  const ChoiceResult result = run(
      "reflection-model",
      cube(0.5, panel, "{ \"model\": \"hall\", \"diffuse\": 0.5, \"specular\": 0.1, \"gloss\": 20, \"ior\": 1.5 }"));
  EXPECT_EQ(result.chart.curves.size(), 4u);
}

// I = 1000 cos(gamma) every 5 degrees: thinned to 45 degrees it is a polygon, 12 % too low halfway.
TEST(StudyOfWebResolution, GrowsWithTheStep) {
  std::string pairs;
  for (int gamma = 0; gamma <= 90; gamma += 5)
    pairs += fmt::format("{}[{},{}]", gamma == 0 ? "" : ",", gamma,
                         gamma == 90 ? 0 : 1000 * std::cos(gamma * 3.14159265358979 / 180));
  const ChoiceResult result =
      run("web-resolution", cube(0.5, "\"photometry\": { \"goniometric\": { \"c0\": [" + pairs + "] } }"));
  ASSERT_GE(result.rows.size(), 3u);
  double before = 0;
  for (const auto& row : result.rows) {
    EXPECT_EQ(row[0], "gamma");
    EXPECT_GT(std::stod(row[3]), before);
    before = std::stod(row[3]);
  }
}

TEST(StudiesOfChoices, RefuseAProjectThatHasNothingToVary) {
  const project::Project grey = cube(0.5, point);
  for (const char* name : {"wavelengths", "near-field", "web-resolution"})
    EXPECT_THROW(run(name, grey), core::InputError) << name;
  project::Project empty = grey;
  empty.grids.clear();
  empty.views.clear();
  for (const ChoiceStudy& each : choiceStudies()) {
    core::SilentProgress silent;
    EXPECT_THROW(each.run(empty, silent), core::InputError) << each.name;
  }
}

TEST(StudiesOfChoices, AnUnknownNameIsRefusedWithTheKnownOnes) {
  StageRequest request;
  request.inputs = {GONIOLUX_SOURCE_DIR "/projects/validation/room-a"};
  request.options["of"] = "taste";
  core::SilentProgress silent;
  try {
    studyStage().run(request, silent);
    FAIL() << "a study of taste was made";
  } catch (const core::InputError& error) {
    EXPECT_NE(std::string(error.what()).find("near-field"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace goniolux::pipeline
