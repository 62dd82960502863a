#include <gtest/gtest.h>

#include "pipeline/stages.h"
#include "support/temporary_folder.h"

namespace goniolux::pipeline {
namespace {

StageReport check(const std::string& project) {
  core::SilentProgress silent;
  StageRequest request;
  request.inputs = {project};
  return checkStage().run(request, silent);
}

TEST(CheckStage, GoodProjectHasNoErrors) {
  const StageReport report = check(std::string(GONIOLUX_SOURCE_DIR) + "/projects/validation/R1");
  EXPECT_FALSE(report.inputFailed);
  EXPECT_TRUE(report.json.find("errors")->array().empty());
  EXPECT_TRUE(report.json.find("warnings")->array().empty());
  EXPECT_NE(report.text.find("6 luminaires"), std::string::npos) << report.text;
}

TEST(CheckStage, BadProjectListsEveryErrorWithItsPlace) {
  const test::TemporaryFolder folder;
  const auto file = folder.write("project.json",
                                 "{ \"format\": \"goniolux-project\", \"version\": 1,\n"
                                 "  \"objcts\": [],\n"
                                 "  \"luminaires\": [ { \"photometry\": \"cosine\", \"position\": [0,0,0] } ] }\n");
  const StageReport report = check(folder.path().string());
  EXPECT_TRUE(report.inputFailed);
  const auto& errors = report.json.find("errors")->array();
  ASSERT_EQ(errors.size(), 2U) << report.text;
  EXPECT_EQ(errors[0].find("file")->string(), file.string());
  EXPECT_EQ(errors[0].find("line")->number(), 2);
  EXPECT_EQ(errors[0].find("column")->number(), 3);
  EXPECT_EQ(errors[0].find("rule")->string(), "unknown-key");
  EXPECT_NE(errors[0].find("message")->string().find("did you mean 'objects'?"), std::string::npos);
  EXPECT_EQ(errors[1].find("line")->number(), 3);
  EXPECT_EQ(report.warnings.all().size(), 2U) << "what a terminal shows";
  EXPECT_NE(report.text.find("2 errors, 0 warnings"), std::string::npos) << report.text;
}

TEST(CheckStage, MissingProjectIsAnErrorToo) {
  const StageReport report = check("no/such/folder");
  EXPECT_TRUE(report.inputFailed);
  EXPECT_EQ(report.json.find("errors")->array().size(), 1U);
}

TEST(SchemaStage, PrintsTheSchemaAndWritesItWhereAsked) {
  core::SilentProgress silent;
  const test::TemporaryFolder folder;
  StageRequest request;
  request.common.output = (folder.path() / "schema.json").string();
  const StageReport report = schemaStage().run(request, silent);
  EXPECT_EQ(report.json.find("$schema")->string(), "https://json-schema.org/draft/2020-12/schema");
  EXPECT_EQ(test::contentOf(folder.path() / "schema.json"), report.text);
  ASSERT_EQ(report.files.size(), 1U);
}

}  // namespace
}  // namespace goniolux::pipeline
