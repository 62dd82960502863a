// expected.json beside each project: where its values come from, and what they are about.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "core/document.h"
#include "project/project.h"
#include "sample_projects.h"

namespace goniolux::project {
namespace {

namespace fs = std::filesystem;

core::Value parsed(const fs::path& file) {
  core::Diagnostics diagnostics;
  core::Value value = core::parseJson(core::readFile(file.string()), file.string(), diagnostics);
  EXPECT_FALSE(diagnostics.hasErrors()) << file;
  return value;
}

TEST(ExpectedValues, NameTheirSourceAndTheProjectsGrids) {
  int count = 0;
  for (const fs::path& file : test::sampleProjects()) {
    const fs::path expected = file.parent_path() / "expected.json";
    if (!fs::exists(expected)) continue;
    ++count;
    const core::Value document = parsed(expected);
    ASSERT_NE(document.find("format"), nullptr);
    EXPECT_EQ(document.find("format")->string(), "goniolux-expected");
    ASSERT_NE(document.find("source"), nullptr) << expected;
    EXPECT_GT(document.find("source")->string().size(), 20U) << expected;
    std::set<std::string> grids;
    for (const auto& grid : readProject(file.string()).grids) grids.insert(grid.name);
    ASSERT_FALSE(document.find("values")->array().empty()) << expected;
    for (const core::Value& value : document.find("values")->array()) {
      EXPECT_TRUE(grids.contains(value.find("grid")->string())) << expected << ":" << value.position().line;
      EXPECT_GT(value.find("value")->number(), 0) << expected << ":" << value.position().line;
      EXPECT_GT(value.find("half_width")->number(), 0) << expected << ":" << value.position().line;
    }
  }
  EXPECT_GE(count, 8) << "the validation projects have theirs";
}

}  // namespace
}  // namespace goniolux::project
