// `report` from the outside: the files it writes, and that old results are not passed off as those of a new project.
#include <gtest/gtest.h>

#include "cli/projects.h"
#include "support/program.h"

namespace goniolux::test {
namespace {

namespace fs = std::filesystem;

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

class ReportStage : public testing::Test {
 protected:
  void SetUp() override {
    folder_.write("project.json", changed(smallRoom, "\"diffuse\": 0.5", "\"diffuse\": 0.1"));
    ASSERT_EQ(goniolux({"illuminate", folder_.path().string(), "--accuracy", "10 %", "--quiet"}).exitCode, 0);
  }
  [[nodiscard]] std::string results() const { return (folder_.path() / "results").string(); }
  TemporaryFolder folder_;
};

TEST_F(ReportStage, WritesOneHtmlFileWithPlanLuminairesAndMap) {
  const Outcome outcome = goniolux({"report", results(), "--format", "html"});
  ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
  const std::string html = contentOf(fs::path(results()) / "report.html");
  for (const char* part : {"Small room", "4.00 × 3.00 × 2.50 m", "12.0 m²", "work plane", "project.json", "<svg"})
    EXPECT_TRUE(contains(html, part)) << part;
  EXPECT_FALSE(contains(html, "src=\"/")) << "everything is in the file";
  EXPECT_FALSE(fs::exists(fs::path(results()) / "report.pdf"));
}

TEST_F(ReportStage, WritesAPdfOrSaysWhatIsMissing) {
  const Outcome outcome = goniolux({"report", results(), "--units", "imperial", "--language", "de"});
  ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
  const fs::path pdf = fs::path(results()) / "report.pdf";
  if (!fs::exists(pdf)) {
    EXPECT_TRUE(contains(outcome.err, "weasyprint")) << outcome.err;
    GTEST_SKIP() << "weasyprint is not installed";
  }
  EXPECT_TRUE(contentOf(pdf).starts_with("%PDF-"));
  const std::string html = contentOf(fs::path(results()) / "report.html");
  EXPECT_TRUE(contains(html, "Lichttechnischer Bericht"));
  EXPECT_TRUE(contains(html, "13,12 × 9,84 × 8,20 ft"));
}

TEST_F(ReportStage, SaysWhichInputHasChangedSinceTheResults) {
  folder_.write("project.json", changed(smallRoom, "\"flux\": 1000", "\"flux\": 2000"));
  const Outcome outcome = goniolux({"report", results(), "--format", "html"});
  EXPECT_EQ(outcome.exitCode, 0);
  EXPECT_TRUE(contains(outcome.err, "changed since")) << outcome.err;
  EXPECT_TRUE(contains(contentOf(fs::path(results()) / "report.html"), "changed since"));
}

TEST_F(ReportStage, RefusesWhatItCannotMean) {
  EXPECT_EQ(goniolux({"report", results(), "--units", "cubits"}).exitCode, 2);
  EXPECT_EQ(goniolux({"report", results(), "--language", "fr"}).exitCode, 2);
  EXPECT_EQ(goniolux({"report", (folder_.path() / "nowhere").string()}).exitCode, 2);
}

}  // namespace
}  // namespace goniolux::test
