// Edits of a project's text: what is not edited stays to the letter, comments and layout too.
#include "project/project_text.h"

#include <gtest/gtest.h>

#include <string>

namespace goniolux::project {
namespace {

const char* const text = R"({
  // how it began
  "name": "Office",
  "grids": [
    { "name": "one" },  // the first
    { "name": "two" }   // the last
  ],
  "settings": { "seed": 3, "solver": "path" /* slow */ }
}
)";

TEST(ProjectText, RemovalTakesTheEntryAndItsCommaAndNoComment) {
  ProjectText project(text, "project.json");
  project.remove(*project.root().find("grids"), 0);
  ASSERT_EQ(project.root().find("grids")->array().size(), 1u);
  EXPECT_EQ(project.root().find("grids")->array()[0].find("name")->string(), "two");
  EXPECT_NE(project.text().find("// the last"), std::string::npos);
  EXPECT_NE(project.text().find("// how it began"), std::string::npos);
}

TEST(ProjectText, RemovalOfTheLastEntryLeavesNoTrailingComma) {
  ProjectText project(text, "project.json");
  project.remove(*project.root().find("grids"), 1);
  ASSERT_EQ(project.root().find("grids")->array().size(), 1u);
  EXPECT_NE(project.text().find("// the first"), std::string::npos);
  project.remove(*project.root().find("grids"), 0);
  EXPECT_TRUE(project.root().find("grids")->array().empty());
}

TEST(ProjectText, MembersAreRemovedWithTheirKeys) {
  ProjectText project(text, "project.json");
  project.remove(*project.root().find("settings"), 1);
  EXPECT_EQ(project.root().find("settings")->find("solver"), nullptr);
  EXPECT_EQ(project.root().find("settings")->find("seed")->number(), 3);
  project.remove(project.root(), 1);
  EXPECT_EQ(project.root().find("grids"), nullptr);
  EXPECT_EQ(project.root().find("name")->string(), "Office");
}

TEST(ProjectText, AddingAndRemovingAgainGivesTheSameValues) {
  ProjectText project(text, "project.json");
  const std::string before = core::toJson(project.root());
  project.append(*project.root().find("grids"), core::Value::Object{{"name", "three"}});
  project.add(*project.root().find("settings"), "time_limit_s", 5);
  EXPECT_EQ(project.root().find("settings")->find("time_limit_s")->number(), 5);
  project.remove(*project.root().find("grids"), 2);
  project.remove(*project.root().find("settings"), 2);
  EXPECT_EQ(core::toJson(project.root()), before);
}

}  // namespace
}  // namespace goniolux::project
