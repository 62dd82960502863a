// `export` of results from the outside.
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "cli/projects.h"
#include "project/results.h"
#include "support/program.h"

namespace goniolux::test {
namespace {

namespace fs = std::filesystem;

TEST(Export, WritesResultsAsSpreadsheetAndGridsForParaview) {
  const TemporaryFolder folder;
  folder.write("room/project.json", changed(smallRoom, "\"diffuse\": 0.5", "\"diffuse\": 0.1"));
  const std::string room = (folder.path() / "room").string();
  const Outcome early = goniolux({"export", room, "--to", "ods"});
  EXPECT_EQ(early.exitCode, 2);
  EXPECT_NE(early.err.find("goniolux run"), std::string::npos) << early.err;
  ASSERT_EQ(goniolux({"illuminate", room, "--accuracy", "10 %"}).exitCode, 0);
  const std::string sheet = (folder.path() / "sheet.ods").string();
  EXPECT_EQ(goniolux({"export", room, "--to", "ods", "-o", sheet}).exitCode, 0);
  EXPECT_EQ(contentOf(sheet).substr(0, 2), "PK");
  const Outcome grids = goniolux({"export", (folder.path() / "room/results").string(), "--to", "vtu"});
  EXPECT_EQ(grids.exitCode, 0) << grids.err;
  EXPECT_TRUE(fs::exists(folder.path() / "room/results/work-plane.vtu")) << grids.out;
  EXPECT_EQ(goniolux({"export", room, "--to", "ods", "-o", "sheet.xls"}).exitCode, 2);
  EXPECT_EQ(goniolux({"export", room, "--to", "dxf"}).exitCode, 2);
}

/// The numbers of each line of a CSV file; cells that are none are left out.
std::vector<std::vector<double>> numbersOf(const fs::path& file) {
  std::vector<std::vector<double>> rows;
  std::istringstream lines(contentOf(file));
  for (std::string line; std::getline(lines, line);) {
    std::erase(line, '"');  // LibreOffice quotes numbers that are not as they are shown
    std::vector<double> row;
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) {
      char* end = nullptr;
      const double value = std::strtod(cell.c_str(), &end);
      if (end != cell.c_str() && *end == '\0') row.push_back(value);
    }
    rows.push_back(row);
  }
  return rows;
}

// A program that we did not write reads the spreadsheet: every number arrives with all digits of its text form.
TEST(Export, LibreOfficeReadsTheNumbersOfTheSpreadsheet) {
  const TemporaryFolder folder;
  if (Running({"sh", "-c", "command -v soffice"}).wait().exitCode != 0)
    GTEST_SKIP() << "LibreOffice is not installed (Debian: libreoffice-calc-nogui)";
  folder.write("room/project.json", changed(smallRoom, "\"diffuse\": 0.5", "\"diffuse\": 0.1"));
  const std::string room = (folder.path() / "room").string();
  ASSERT_EQ(goniolux({"illuminate", room, "--accuracy", "10 %"}).exitCode, 0);
  ASSERT_EQ(goniolux({"export", room, "--to", "ods", "-o", (folder.path() / "sheet.ods").string()}).exitCode, 0);
  // Commas, UTF-8, values as they are and not as they are shown, every sheet into a file of its own.
  const Outcome read = Running({"timeout", "100", "soffice", "--headless",
                                "-env:UserInstallation=file://" + (folder.path() / "profile").string(), "--convert-to",
                                "csv:Text - txt - csv (StarCalc):44,34,76,1,,0,false,false,false,false,false,-1",
                                "--outdir", folder.path().string(), (folder.path() / "sheet.ods").string()})
                           .wait();
  if (read.exitCode == 124) GTEST_SKIP() << "LibreOffice did not come to an end in 100 s; the machine is busy";
  ASSERT_EQ(read.exitCode, 0) << read.out << read.err;

  const project::Results results = project::readResults(room + "/results");
  const project::GridResult& grid = results.grids.at(0);
  const auto expectSame = [](double found, double expected) {
    EXPECT_NEAR(found, expected, 1e-13 * std::abs(expected) + 1e-15);  // 15 digits are what its CSV files have
  };
  const auto rows = numbersOf(folder.path() / ("sheet-" + grid.name + ".csv"));
  ASSERT_EQ(rows.size(), grid.points.size() + 1);
  for (std::size_t i = 0; i < grid.points.size(); ++i) {
    ASSERT_EQ(rows[i + 1].size(), 5U) << i;
    for (const int axis : {0, 1, 2}) expectSame(rows[i + 1][static_cast<std::size_t>(axis)], grid.points[i][axis]);
    expectSame(rows[i + 1][3], grid.values[i]);
    expectSame(rows[i + 1][4], grid.halfWidths[i]);
  }
  const auto summary = numbersOf(folder.path() / "sheet-Summary.csv");
  ASSERT_GE(summary.size(), 5U);
  ASSERT_EQ(summary[4].size(), 8U) << "mean, minimum, maximum and U0, each with its half-width";
  expectSame(summary[4][0], grid.mean.value);
  expectSame(summary[4][1], grid.mean.halfWidth());
  expectSame(summary[4][6], grid.u0.value);
}

}  // namespace
}  // namespace goniolux::test
