// The ten-minute guide, word for word: its project file is written, its commands are run in order, its message appears.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "documentation/pages.h"
#include "support/program.h"

namespace goniolux::test {
namespace {

namespace fs = std::filesystem;

/// The content of the page's n-th block of a language.
std::string blockOf(const std::string& page, const std::string& language, int number) {
  std::size_t at = 0;
  const std::string fence = "```" + language + "\n";
  for (int i = 0; i <= number; ++i) {
    at = page.find(fence, at);
    if (at == std::string::npos) return {};
    at += fence.size();
  }
  return page.substr(at, page.find("```", at) - at);
}

/// Commands are given as a reader of the guide gives them, from a folder with luminaires/ in it.
class Guide : public testing::Test {
 protected:
  void SetUp() override {
    before_ = fs::current_path();
    fs::create_directory_symlink(fs::path(GONIOLUX_SOURCE_DIR) / "luminaires", folder_.path() / "luminaires");
    fs::create_directory(folder_.path() / "my-room");
    fs::current_path(folder_.path());
  }
  void TearDown() override { fs::current_path(before_); }
  TemporaryFolder folder_;
  fs::path before_;
};

TEST_F(Guide, CanBeFollowedWordForWord) {
  const fs::path file = fs::path(GONIOLUX_SOURCE_DIR) / "docs/getting-started.md";
  const std::string page = contentOf(file);
  const std::string project = blockOf(page, "json", 0);
  ASSERT_FALSE(project.empty());

  // The mistake that it asks the reader to make.
  std::string wrong = project;
  const std::string good = "\"diffuse\": 0.35";
  ASSERT_NE(wrong.find(good), std::string::npos);
  wrong.replace(wrong.find(good), good.size(), "\"diffuse\": 1.2");
  folder_.write("my-room/project.json", wrong);
  const Outcome refused = goniolux({"check", "my-room"});
  EXPECT_EQ(refused.exitCode, 2);
  const std::string promised = blockOf(page, "text", 0);
  EXPECT_NE((refused.err + refused.out).find(promised.substr(0, promised.find('\n'))), std::string::npos)
      << refused.err << "\nthe guide promises: " << promised;

  folder_.write("my-room/project.json", project);
  int run = 0;
  for (const Command& command : commandsOf(file)) {
    if (command.words.front() != "goniolux") continue;
    std::vector<std::string> arguments(command.words.begin() + 1, command.words.end());
    const Outcome outcome = goniolux(arguments);
    EXPECT_EQ(outcome.exitCode, 0) << toString(command.place) << '\n' << outcome.out << outcome.err;
    ++run;
  }
  EXPECT_GE(run, 8);
  for (const char* made :
       {"my-room/results/work-plane.png", "my-room/results/grids.json", "my-room/results/report.html",
        "fine/grids.json", "quick/grids.json", "image/door.exr", "door.png"})
    EXPECT_TRUE(fs::exists(folder_.path() / made)) << made;
}

}  // namespace
}  // namespace goniolux::test
