#include "project/results.h"

#include "project/summary_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support/temporary_folder.h"

namespace goniolux::project {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

Results sample() {
  Results results;
  results.project = "Small office";
  results.projectHash = "abc123";
  results.programVersion = "0.1.0";
  results.lightingScene = "presentation";
  results.seed = 18446744073709551615ULL;  // more than a JSON number holds exactly
  results.settingsUsed.set("solver", "path");
  results.leftOut = {"the far lamps: at most 0.1 lx"};
  results.wallTime_s = 1.5;
  results.cpuTime_s = 2.5;
  results.rays = 123456789012345ULL;
  results.reached = false;
  results.reachedText = "91 % of the points within 1 %";
  GridResult grid;
  grid.name = "work plane";
  grid.counts = {2, 2};
  grid.plane = GridPlane{{0, 0, 0.8}, {2, 0, 0}, {0, 1, 0}};
  grid.points = {{0.5, 0.25, 0.8}, {1.5, 0.25, 0.8}, {0.5, 0.75, 0.8}, {1.5, 0.75, 0.8}};
  grid.values = {500.123456789, 400, nan, 300};
  grid.halfWidths = {5, 4, nan, 3};
  grid.parts["statistical"] = {4, 3, nan, 2};
  grid.parts["truncation"] = {1, 1, nan, 1};
  grid.excluded = {2};
  grid.mean = {400.04, 2, {{"truncation", 1}, {"spectral", 0.5}}};
  grid.min = {300, 3, {}};
  grid.max = {500.123456789, 5, {}};
  grid.u0 = {0.75, 0.01, {}};
  grid.ud = {0.6, 0.01, {}};
  grid.initialMean = core::Estimate{500.05, 2, {}};
  results.grids.push_back(grid);
  ObserverResult seat;
  seat.name = "seat 1";
  seat.value = {18.5, 0.2, {}};
  seat.eye = {1, 2, 1.2};
  seat.direction = {0, 1, 0};
  seat.background = {25, 0.5, {}};
  seat.sources = {{"panel[0,0]", 3000, 0.02, 1.5, 0.75}, {"panel[1,0]", 2900, 0.01, 2, 0.25}};
  results.observers.push_back(seat);
  RequirementResult requirement;
  requirement.text = "mean of \"work plane\" at least 500 lx";
  requirement.verdict = RequirementResult::Verdict::fail;
  requirement.of = "work plane";
  requirement.quantity = "mean_lx";
  requirement.minimum = 500;
  requirement.found = results.grids.front().mean;
  requirement.clause = "EN 12464-1:2021, 34.2";
  results.requirements.push_back(requirement);
  results.inputs.push_back({"project.json", std::string(64, 'a')});
  return results;
}

core::Value parsed(const std::string& text) {
  core::Diagnostics diagnostics;
  core::Value value = core::parseJson(text, "grids.json", diagnostics);
  EXPECT_FALSE(diagnostics.hasErrors());
  return value;
}

/// The sample's text with one piece replaced.
core::Value damaged(const std::string& from, const std::string& to) {
  std::string text = core::toJson(toJson(sample()));
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return parsed(text.replace(at, from.size(), to));
}

TEST(Results, ReadBackEverythingTheyWrote) {
  const std::string text = core::toJson(toJson(sample()));
  const Results back = resultsFromJson(parsed(text));
  EXPECT_EQ(core::toJson(toJson(back)), text);
  EXPECT_EQ(back.seed, 18446744073709551615ULL);
  EXPECT_EQ(back.rays, 123456789012345ULL);
  ASSERT_EQ(back.grids.size(), 1U);
  EXPECT_EQ(back.grids[0].values[0], 500.123456789);
  EXPECT_TRUE(std::isnan(back.grids[0].values[2]));
  EXPECT_DOUBLE_EQ(back.grids[0].mean.halfWidth(), 3.5);
  EXPECT_EQ(back.requirements[0].verdict, RequirementResult::Verdict::fail);
}

TEST(Results, FollowTheInterfaceDocument) {
  const core::Value json = toJson(sample());
  for (const char* key : {"format", "version", "project", "confidence", "seed", "settings_used", "left_out", "time_s",
                          "rays", "grids", "observers", "requirements"}) {
    EXPECT_NE(json.find(key), nullptr) << key;
  }
  const core::Value& grid = json.find("grids")->array()[0];
  for (const char* key : {"name", "quantity", "unit", "counts", "points", "values", "half_widths", "parts", "excluded",
                          "mean", "min", "max", "u0", "ud"}) {
    EXPECT_NE(grid.find(key), nullptr) << key;
  }
  EXPECT_EQ(grid.find("mean")->find("half_width")->number(), 3.5);
}

TEST(Results, AreRefusedWithAPlaceWhenDamaged) {
  const std::pair<const char*, const char*> damages[] = {
      {"\"goniolux-results\"", "\"something\""},
      {"\"version\": 1", "\"version\": 2"},
      {"\"confidence\": 0.95", "\"confidence\": 95"},
      {"\"excluded\": [2]", "\"excluded\": [7]"},
      {"\"excluded\": [2]", "\"excluded\": []"},
      {"400, null, 300", "400, 300"},
      {"400, null, 300", "null, null, 300"},
      {"\"counts\": [2, 2]", "\"counts\": [3, 2]"},
      {"\"half_width\": 3.5", "\"half_width\": 0.1"},
      {"\"half_width\": 3.5", "\"half_width\": -3.5"},
      {"\"fail\"", "\"maybe\""},
      {"\"seed\": \"18446744073709551615\"", "\"seed\": -1"},
  };
  for (const auto& [from, to] : damages) {
    const core::Value document = damaged(from, to);
    try {
      resultsFromJson(document);
      ADD_FAILURE() << "accepted: " << from << " -> " << to;
    } catch (const core::InputError& error) {
      EXPECT_EQ(error.diagnostics().all()[0].position.file, "grids.json");
      EXPECT_GT(error.diagnostics().all()[0].position.line, 0) << to;
    }
  }
}

TEST(Results, KeepAnUndefinedUniformityOfADarkRoom) {
  Results results = sample();
  results.grids[0].u0 = {nan, nan, {}};
  const Results back = resultsFromJson(parsed(core::toJson(toJson(results))));
  EXPECT_TRUE(std::isnan(back.grids[0].u0.value));
}

TEST(Results, PassOverMembersThatTheyDoNotKnow) {
  EXPECT_EQ(resultsFromJson(damaged("\"version\": 1", "\"version\": 1, \"newer\": {}")).project, "Small office");
}

TEST(Results, AreFoundInTheirFolder) {
  const test::TemporaryFolder folder;
  EXPECT_THROW(readResults(folder.path().string()), core::InputError);
  EXPECT_THROW(readResults((folder.path() / "absent").string()), core::InputError);
  folder.write("grids.json", core::toJson(toJson(sample())));
  EXPECT_EQ(readResults(folder.path().string()).project, "Small office");
  EXPECT_EQ(readResults((folder.path() / "grids.json").string()).project, "Small office");
}

TEST(ResultsCsv, SaysHowItWasMadeAndHasOneRowPerPoint) {
  const Results results = sample();
  const std::string csv = toCsv(results, results.grids[0]);
  EXPECT_NE(
      csv.find("x_m,y_m,z_m,illuminance_lx,half_width_lx\n0.5,0.25,0.8,500.123,5\n1.5,0.25,0.8,400,4\n0.5,0.75,0.8,,\n"
               "1.5,0.75,0.8,300,3\n"),
      std::string::npos)
      << csv;
  EXPECT_NE(csv.find("# project hash abc123; seed 18446744073709551615; half-widths at 95 % confidence\n"),
            std::string::npos);
  EXPECT_NE(csv.find("# the accuracy asked for was not reached: 91 % of the points within 1 %\n"), std::string::npos);
}

TEST(ResultsCsv, KeepsALineBreakInANameInsideItsComment) {
  Results results = sample();
  results.project = "two\nlines";
  EXPECT_EQ(toCsv(results, results.grids[0]).find("\nlines"), std::string::npos);
}

TEST(FileNames, FollowTheInterfaceDocument) {
  EXPECT_EQ(fileNameFor("work plane"), "work-plane");
  EXPECT_EQ(fileNameFor("Desk_2/left.1"), "desk-2-left.1");
  EXPECT_EQ(fileNameFor("Büro"), "büro");
  EXPECT_EQ(fileNameFor(".."), "..-");
  EXPECT_EQ(fileNameFor(""), "-");
}

TEST(SummaryTable, HasAsManyCellsInEveryLineOfATableAsItsHeadAndNoneBrokenByAName) {
  Results results = sample();
  results.grids.front().name = "work\tplane\n2";
  const std::string table = toSummaryTable(results);
  EXPECT_NE(table.find("work plane 2\tilluminance\tlx\t400.04\t3.5\t300\t3\t500.123\t5\t0.75\t0.01\n"),
            std::string::npos)
      << table;
  EXPECT_NE(table.find("seat 1\tugr\t1\t18.5\t0.2\n"), std::string::npos) << table;
  EXPECT_NE(table.find("\tfail\tEN 12464-1:2021, 34.2\n"), std::string::npos) << table;
}

}  // namespace
}  // namespace goniolux::project
