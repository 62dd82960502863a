// The spreadsheet of results: sheets, exact numbers, names that every program takes.
#include "project/spreadsheet.h"

#include <gtest/gtest.h>

#include <cmath>

namespace goniolux::project {
namespace {

Results sample() {
  Results results;
  results.project = "Room <1>";
  GridResult grid;
  grid.name = "a grid with a long name: 10/12 [über dem Tisch]";
  grid.counts = {2, 2};
  grid.points = {{0, 0, 1}, {2, 0, 1}, {0, 1.5, 1}, {2, 1.5, 1}};
  grid.values = {100, 200.25, 1.0 / 3, NAN};
  grid.halfWidths = {1, 2, 3, NAN};
  grid.mean = {100.5, 0.5, {}};
  results.grids = {grid, grid};
  results.leftOut = {"fluorescence"};
  RequirementResult requirement;
  requirement.of = "desk";
  requirement.quantity = "mean_lx";
  requirement.minimum = 500;
  requirement.verdict = RequirementResult::Verdict::fail;
  results.requirements.push_back(requirement);
  return results;
}

std::vector<std::string> all(const std::string& text, const std::string& begin, const std::string& end) {
  std::vector<std::string> found;
  for (std::size_t at = 0; (at = text.find(begin, at)) != std::string::npos;) {
    at += begin.size();
    found.push_back(text.substr(at, text.find(end, at) - at));
  }
  return found;
}

TEST(Spreadsheet, IsAnOpenDocumentPackage) {
  const std::string bytes = toSpreadsheet(sample());
  // OpenDocument 1.2, part 3, 3.3: the type stands bare at byte 38.
  EXPECT_EQ(bytes.substr(38, 46), "application/vnd.oasis.opendocument.spreadsheet");
  for (const char* part : {"content.xml", "styles.xml", "META-INF/manifest.xml"})
    EXPECT_NE(bytes.find(part), std::string::npos) << part;
  EXPECT_EQ(bytes, toSpreadsheet(sample())) << "same results, same bytes";
}

TEST(Spreadsheet, HasASheetForTheSummaryTwoForEachRegularGridAndOneForItsMaking) {
  const auto names = all(toSpreadsheet(sample()), "table:table table:name=\"", "\"");
  ASSERT_EQ(names.size(), 6U);
  EXPECT_EQ(names.front(), "Summary");
  EXPECT_EQ(names.back(), "How it was made");
  EXPECT_TRUE(names[2].ends_with(" plan"));
  for (const std::string& name : names) {
    EXPECT_LE(name.size(), 31U) << name;
    EXPECT_EQ(name.find_first_of("[]:*?/"), std::string::npos) << name;
    EXPECT_EQ(std::count(names.begin(), names.end(), name), 1) << name;
  }
}

TEST(Spreadsheet, KeepsEveryDigitAndLeavesWhatDoesNotExistEmpty) {
  const std::string bytes = toSpreadsheet(sample());
  const auto values = all(bytes, "office:value=\"", "\"");
  std::size_t thirds = 0;
  for (const std::string& value : values) {
    EXPECT_TRUE(std::isfinite(std::stod(value))) << value;
    thirds += std::stod(value) == 1.0 / 3 ? 1 : 0;
  }
  EXPECT_EQ(thirds, 4U) << "in the list and in the plan of both grids";
  EXPECT_NE(bytes.find("<table:table-cell/>"), std::string::npos);
  EXPECT_NE(bytes.find("Room &lt;1&gt;"), std::string::npos);
  EXPECT_NE(bytes.find("<text:p>fail</text:p>"), std::string::npos);
}

// Values run u fastest; a plan is read with v upward, so the first value stands in the last row.
TEST(Spreadsheet, LaysThePlanWithTheFirstPointAtTheLowerLeft) {
  const std::string bytes = toSpreadsheet(sample());
  const std::size_t plan = bytes.find("right: along u");
  const std::string sheet = bytes.substr(plan, bytes.find("</table:table>", plan) - plan);
  const auto values = all(sheet, "office:value=\"", "\"");
  ASSERT_EQ(values.size(), 7U) << "two distances, three values, two distances";
  EXPECT_EQ(std::stod(values[0]), 1.5);
  EXPECT_EQ(std::stod(values[1]), 1.0 / 3);
  EXPECT_EQ(std::stod(values[2]), 0);
  EXPECT_EQ(std::stod(values[3]), 100);
  EXPECT_EQ(std::stod(values[4]), 200.25);
  EXPECT_EQ(std::stod(values[6]), 2);
}

}  // namespace
}  // namespace goniolux::project
