// The study: errors against a reference, the front, what is kept, and a small project from end to end.
#include "pipeline/study.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <set>

#include "pipeline/report_input.h"
#include "pipeline/stage.h"
#include "support/temporary_folder.h"

namespace goniolux::pipeline {
namespace {

project::Results resultsOf(const std::vector<double>& values, double halfWidth) {
  project::Results results;
  project::GridResult grid;
  grid.values = values;
  grid.halfWidths.assign(values.size(), halfWidth);
  double sum = 0;
  for (const double value : values) sum += value / static_cast<double>(values.size());
  grid.mean.value = sum;
  results.grids = {grid};
  return results;
}

StudyRun runOf(double cpu, double rms) {
  StudyRun run;
  run.setting = {"path", "path", 0.01, "auto"};
  run.cpu_s = cpu;
  run.rms = rms;
  return run;
}

TEST(Study, MeasuresErrorsAsAccuracyIsAsked) {
  const StudyReference reference{resultsOf({100, 200, 5, 95}, 1), 0.01};  // mean 100: 5 is judged by 10
  StudyRun run;
  compareWithReference(resultsOf({102, 196, 6, 95}, 2), reference, run);
  EXPECT_NEAR(run.rms, std::sqrt((0.02 * 0.02 + 0.02 * 0.02 + 0.1 * 0.1) / 4), 1e-12);
  EXPECT_NEAR(run.largest, 0.1, 1e-12);
  EXPECT_NEAR(run.mean, (0.02 - 0.02 + 0.1) / 4, 1e-12);
  EXPECT_DOUBLE_EQ(run.inside, 0.75);  // 196 is 4 off; its half-width and the reference's make 2.2
  project::Results gap = resultsOf({102, 196, 6, 95}, 2);
  gap.grids[0].values[1] = std::numeric_limits<double>::quiet_NaN();
  compareWithReference(gap, reference, run);
  EXPECT_NEAR(run.rms, std::sqrt((0.02 * 0.02 + 0.1 * 0.1) / 3), 1e-12);
}

TEST(Study, FrontHoldsWhatNothingBeatsInBoth) {
  const std::vector<StudyRun> runs{runOf(1, 0.1), runOf(2, 0.05), runOf(3, 0.06), runOf(0.5, 0.2), runOf(0.6, 0.3)};
  const auto front = paretoFront(runs);
  ASSERT_EQ(front.size(), 3u);
  EXPECT_EQ(front[0], &runs[3]);
  EXPECT_EQ(front[1], &runs[0]);
  EXPECT_EQ(front[2], &runs[1]);
}

TEST(Study, RunsSurviveTheirFile) {
  StudyRun run = runOf(1.25, 0.0123);
  run.isAuto = run.reached = true;
  run.rays = 123456789;
  run.inside = 0.95;
  const auto again = studyRunFromJson(toJson(run));
  ASSERT_TRUE(again);
  EXPECT_EQ(core::toJson(toJson(*again)), core::toJson(toJson(run)));
  core::Value cut;
  cut.set("line", "path");
  EXPECT_FALSE(studyRunFromJson(cut));
}

TEST(Study, AFilesRunOfBeforePicturesIsMadeAnew) {
  core::Value old = toJson(runOf(1, 0.1));
  EXPECT_TRUE(studyRunFromJson(old));
  old.set("of", core::Value());
  EXPECT_FALSE(studyRunFromJson(old));
}

// No time helps a method whose intervals never hold; one that is right somewhere on its line has no plateau.
TEST(Study, PlateausAreOfLinesThatAreNeverRight) {
  std::vector<StudyRun> runs{runOf(1, 0.3), runOf(2, 0.2), runOf(3, 0.01)};
  runs[0].setting.line = runs[1].setting.line = "tree";
  runs[0].leftOut = runs[1].leftOut = "interreflection between matt surfaces (solver tree), but for the ambient term";
  runs[2].inside = 0.95;
  const auto found = plateaus(runs);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0], &runs[1]);
  const plot::LineChart chart = workPrecisionChart({"a room", "points of the grids", 0.001, 48}, runs);
  ASSERT_EQ(chart.levels.size(), 2u);  // the noise, and the tree
  EXPECT_NE(chart.levels[1].text.find("tree stays at 20 %: without interreflection between matt surfaces"),
            std::string::npos)
      << chart.levels[1].text;
  EXPECT_EQ(chart.front.size(), 3u);
  runs[0].inside = 0.9;
  EXPECT_TRUE(plateaus(runs).empty());
}

TEST(Study, ChangesOneThing) {
  project::Project project;
  scene::Luminaire panel;
  panel.flux_lm = 1000;
  panel.distribution = std::make_shared<photometry::CosinePowerDistribution>(1000 / core::pi, 1.0);
  panel.center = {1, 2, 3};
  panel.opening.shape = emitter::Opening::Shape::rectangle;
  panel.opening.length = 1.2;
  panel.opening.width = 0.3;
  project.environment.luminaires = {panel};
  EXPECT_EQ(changed(project, "tree.max_depth=3").settings.treeMaxDepth, 3);
  EXPECT_DOUBLE_EQ(changed(project, "tree.cutoff=0.1").settings.treeCutoff, 0.1);
  EXPECT_EQ(changed(project, "pixel.max_samples=64").settings.pixelMaxSamples, 64);
  const auto cut = changed(project, "luminaire.points=2").environment.luminaires;
  ASSERT_EQ(cut.size(), 4u);
  double flux = 0;
  core::Vec3 middle(0);
  for (const scene::Luminaire& point : cut) {
    EXPECT_EQ(point.opening.shape, emitter::Opening::Shape::point);
    EXPECT_NEAR(point.distribution->flux() * point.scale, 250, 1e-9);
    flux += point.flux_lm;
    middle += 0.25 * point.center;
  }
  EXPECT_NEAR(flux, 1000, 1e-9);
  EXPECT_NEAR(glm::distance(middle, core::Vec3(1, 2, 3)), 0, 1e-12);
}

class StudyStage : public ::testing::Test {
 protected:
  void write(const std::string& name, const std::string& extra) {
    std::filesystem::create_directories(folder_.path() / name);
    std::ofstream(folder_.path() / name / "project.json") << R"({ "format": "goniolux-project", "version": 1,
      "name": ")" << name << R"(",
      "materials": { "grey": { "model": "lambert", "diffuse": 0.5 } },
      "objects": [ { "name": "room", "shape": "box", "min": [0,0,0], "max": [4,3,2.5], "facing": "inward",
                     "material": "grey" } ],
      "luminaires": [ { "name": "L", "photometry": "isotropic", "flux": 3000, "position": [2,1.5,2] } ],
      "settings": { "accuracy": { "grid": "10 %" } })" << extra
                                                          << " }";
  }
  static StageReport study(const std::vector<std::string>& inputs, const std::string& output) {
    for (const Stage& stage : stages()) {
      if (stage.name != "study") continue;
      StageRequest request;
      request.inputs = inputs;
      request.common.output = output;
      request.common.timeLimit_s = 3;
      core::SilentProgress silent;
      return stage.run(request, silent);
    }
    throw std::logic_error("there is no stage study");
  }
  static constexpr const char* grid =
      R"(, "grids": [ { "name": "g", "origin": [0,0,0.8], "u": [4,0,0], "v": [0,3,0], "counts": [8,6] } ])";
  test::TemporaryFolder folder_;
};

TEST_F(StudyStage, ChartsEverySolverAndGoesOnWhereItWasStopped) {
  write("room", grid);
  const std::string project = (folder_.path() / "room").string(), out = (folder_.path() / "out").string();
  const StageReport first = study({project}, out);
  const core::Value& runs = *first.json.find("runs");
  bool path = false, gather = false, tree = false, chosen = false;
  for (const core::Value& run : runs.array()) {
    const std::string& line = run.find("line")->string();
    path |= line == "path", gather |= line == "gather";
    if (run.find("auto")->boolean()) chosen = true;
    // What claims to be right is right.
    if (line == "tree") {
      tree = true;
      EXPECT_GT(run.find("rms")->number(), 0.1);  // no interreflection
    } else {
      EXPECT_GT(run.find("inside")->number(), 0.8) << core::toJson(run);
    }
  }
  // On a slow machine the time ends before all have run, which is said; what `auto` does is always there.
  EXPECT_TRUE((path && gather && tree) || first.text.find("left out") != std::string::npos) << first.text;
  EXPECT_TRUE(chosen);
  EXPECT_TRUE(std::filesystem::exists(out + "/study.csv"));
  EXPECT_TRUE(std::filesystem::exists(out + "/work-precision.figure.json"));
  EXPECT_TRUE(first.json.find("cross")->find("agree")->boolean()) << core::toJson(*first.json.find("cross"));
  // A second call calculates nothing anew, not even after a line that was cut off.
  std::ofstream(out + "/study.jsonl", std::ios::app) << "{\"line\": \"pa";
  const StageReport second = study({project}, out);
  const auto& again = second.json.find("runs")->array();
  // (On a slow machine the first call may have left out a setting, which the second has time for.)
  std::set<std::string> known;
  for (const core::Value& run : again) known.insert(core::toJson(run));
  for (const core::Value& run : runs.array()) EXPECT_TRUE(known.contains(core::toJson(run))) << core::toJson(run);
}

// A light solution pays when many points share it; on the cube's six points `gather` took ten times what `path` takes.
TEST_F(StudyStage, AutoTakesPathsForAHandfulOfPoints) {
  write("few", R"(, "grids": [ { "name": "g", "origin": [0,0,0.8], "u": [4,0,0], "v": [0,3,0], "counts": [3,2] } ])");
  write("many", grid);
  for (const auto& [name, solver] : {std::pair{"few", "path"}, std::pair{"many", "gather"}}) {
    for (const Stage& stage : stages()) {
      if (stage.name != "plan") continue;
      StageRequest request;
      request.inputs = {(folder_.path() / name).string()};
      core::SilentProgress silent;
      EXPECT_EQ(stage.run(request, silent).json.find("solver")->string(), solver) << name;
    }
  }
}

// What is kept belongs to the settings that it was calculated with.
TEST_F(StudyStage, OtherSettingsAreCalculatedAnew) {
  write("room", grid);
  const std::string project = (folder_.path() / "room").string(), out = (folder_.path() / "out").string();
  const auto runsOf = [&](const char* set) {
    for (const Stage& stage : stages()) {
      if (stage.name != "study") continue;
      StageRequest request;
      request.inputs = {project};
      request.common.output = out;
      request.common.timeLimit_s = 1;
      if (set != nullptr) request.common.set = {set};
      core::SilentProgress silent;
      return core::toJson(*stage.run(request, silent).json.find("runs")->array()[0].find("rms"));
    }
    throw std::logic_error("there is no stage study");
  };
  const std::string first = runsOf(nullptr);
  EXPECT_EQ(runsOf(nullptr), first);
  EXPECT_NE(runsOf("seed=77"), first);
}

// A project of pictures alone has its chart, and colours are told beside luminances.
TEST_F(StudyStage, ChartsThePixelsOfTheFirstView) {
  write("view",
        R"(, "views": [ { "name": "door", "eye": [0.1,1.5,1.6], "target": [4,1.5,1], "width": 24, "height": 16 } ])");
  const std::string out = (folder_.path() / "out").string();
  const StageReport report = study({(folder_.path() / "view").string()}, out);
  bool path = false, gather = false, depth = false;
  for (const core::Value& run : report.json.find("runs")->array()) {
    EXPECT_EQ(run.find("of")->string(), "picture");
    ASSERT_NE(run.find("delta_e00_mean"), nullptr);
    const std::string& line = run.find("line")->string();
    path |= line == "path", gather |= line == "gather";
    if (line == "tree, depth") {
      depth = true;
      EXPECT_LT(run.find("mean")->number(), -0.05);  // no interreflection
    } else if (line == "path") {
      EXPECT_GT(run.find("inside")->number(), 0.8) << core::toJson(run);
    }
  }
  // On a slow machine the time ends before all have run, which is said.
  EXPECT_TRUE((path && gather && depth) || report.text.find("left out") != std::string::npos) << report.text;
  EXPECT_TRUE(path || gather);
  EXPECT_TRUE(std::filesystem::exists(out + "/picture-precision.figure.json"));
  // The reference is kept, and not counted when it has a time of its own.
  const auto made = std::filesystem::last_write_time(out + "/reference.exr");
  study({(folder_.path() / "view").string()}, out);
  EXPECT_EQ(std::filesystem::last_write_time(out + "/reference.exr"), made);
}

// A chart of the project as it was before a change would mislead.
TEST_F(StudyStage, TheReportTakesTheChartOfTheProjectAsItIs) {
  write("room", grid);
  const std::string folder = (folder_.path() / "room").string();
  EXPECT_FALSE(speedChartOf(project::readProject(folder)));
  study({folder}, folder + "/study");
  std::ofstream(folder + "/study/work-precision.svg") << "<svg/>";  // where drawing is not possible
  const auto chart = speedChartOf(project::readProject(folder));
  ASSERT_TRUE(chart);
  EXPECT_EQ(chart->bytes, "<svg/>");
  write("room", std::string(grid) + R"(, "units": "mm")");
  EXPECT_FALSE(speedChartOf(project::readProject(folder)));
}

TEST_F(StudyStage, SeveralProjectsMakeAPageAndABrokenOneFailsAlone) {
  write("a room", grid);
  write("no grid", "");
  const std::string out = (folder_.path() / "out").string();
  const StageReport report = study({folder_.path().string()}, out);
  EXPECT_TRUE(report.inputFailed);
  const std::string page = core::readFile(out + "/README.md");
  EXPECT_NE(page.find("not studied"), std::string::npos);
  EXPECT_NE(page.find("gather (`auto`)"), std::string::npos);
}

}  // namespace
}  // namespace goniolux::pipeline
