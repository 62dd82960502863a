// `export` of results from the outside.
#include <gtest/gtest.h>

#include "cli/projects.h"
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

}  // namespace
}  // namespace goniolux::test
