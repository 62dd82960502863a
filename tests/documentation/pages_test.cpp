// What the pages say exists, exists.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "core/document.h"
#include "documentation/pages.h"
#include "pipeline/stage.h"
#include "support/program.h"
#include "support/temporary_folder.h"

namespace goniolux::test {
namespace {

namespace fs = std::filesystem;
const fs::path root = GONIOLUX_SOURCE_DIR;

std::vector<Command> commandsOfAllPages() {
  std::vector<Command> all;
  for (const fs::path& page : pages())
    for (const Command& command : commandsOf(page)) all.push_back(command);
  return all;
}

const pipeline::Stage* stageNamed(const std::string& verb) {
  const auto& stages = pipeline::stages();
  const auto found = std::find_if(stages.begin(), stages.end(), [&](const auto& stage) { return stage.name == verb; });
  return found == stages.end() ? nullptr : &*found;
}

TEST(Pages, EveryGonioluxCommandHasAVerbAndOptionsThatTheProgramKnows) {
  int seen = 0;
  for (const Command& command : commandsOfAllPages()) {
    if (command.words.front() != "goniolux") continue;
    ++seen;
    ASSERT_GE(command.words.size(), 2u) << toString(command.place);
    ASSERT_NE(stageNamed(command.words[1]), nullptr) << toString(command.place) << ": no verb " << command.words[1];
    const std::string help = goniolux({command.words[1], "--help"}).out;
    for (std::size_t i = 2; i < command.words.size(); ++i) {
      const std::string& word = command.words[i];
      if (!word.starts_with('-')) continue;
      EXPECT_NE(help.find(" " + word.substr(0, word.find('='))), std::string::npos)
          << toString(command.place) << ": no option " << word;
    }
  }
  EXPECT_GT(seen, 5) << "the commands were not found";
}

// Verbs that need little time and whose input is in the repository are really run.
TEST(Pages, EveryCheapCommandOnAFileOfTheRepositorySucceeds) {
  const std::set<std::string> cheap = {"check", "plan", "luminaire", "schema"};
  const TemporaryFolder out;
  fs::current_path(root);
  for (const Command& command : commandsOfAllPages()) {
    if (command.words.front() != "goniolux" || !cheap.contains(command.words[1])) continue;
    const bool hasInput = command.words.size() > 2 && !command.words[2].starts_with('-');
    if (hasInput && !fs::exists(root / command.words[2])) continue;
    std::vector<std::string> arguments(command.words.begin() + 1, command.words.end());
    for (std::size_t i = 0; i + 1 < arguments.size(); ++i)
      if (arguments[i] == "-o") arguments[i + 1] = (out.path() / "file").string();
    const Outcome outcome = goniolux(arguments);
    EXPECT_EQ(outcome.exitCode, 0) << toString(command.place) << '\n' << outcome.err;
  }
}

TEST(Pages, EveryScriptAndPresetNamedExists) {
  const std::string presets = contentOf(root / "CMakePresets.json");
  for (const Command& command : commandsOfAllPages()) {
    const std::string& first = command.words.front();
    if (first.starts_with("script/") || first.starts_with(".ci/")) {
      EXPECT_EQ(access((root / first).c_str(), X_OK), 0) << toString(command.place) << ": " << first;
    }
    const auto preset = std::find(command.words.begin(), command.words.end(), "--preset");
    if (preset == command.words.end() || preset + 1 == command.words.end()) continue;
    EXPECT_NE(presets.find("\"" + *(preset + 1) + "\""), std::string::npos) << toString(command.place);
  }
}

TEST(Pages, EveryLinkLeadsToAFile) {
  int seen = 0;
  for (const fs::path& page : pages()) {
    for (const Link& link : linksOf(page)) {
      if (link.target.starts_with("http")) continue;
      ++seen;
      const std::string file = link.target.substr(0, link.target.find('#'));
      EXPECT_TRUE(file.empty() || fs::exists(page.parent_path() / file)) << toString(link.place) << ": " << link.target;
    }
  }
  EXPECT_GT(seen, 20) << "the links were not found";
}

TEST(Pages, EveryPageOfTheDocumentationIsLinkedFromAnother) {
  std::set<fs::path> linked;
  for (const fs::path& page : pages())
    for (const Link& link : linksOf(page))
      if (fs::exists(page.parent_path() / link.target)) linked.insert(fs::canonical(page.parent_path() / link.target));
  for (const fs::path& page : pages()) {
    if (!toString({page, 0}).starts_with("docs/")) continue;
    // A link to its folder will do: the folder lists it.
    EXPECT_TRUE(linked.contains(fs::canonical(page)) || linked.contains(fs::canonical(page.parent_path())))
        << toString({page, 0}) << ": name it in docs/README.md";
  }
}

TEST(Pages, TheExampleProjectOfTheReadmeAndOfGettingStartedPassTheCheck) {
  int seen = 0;
  for (const char* page : {"README.md", "docs/getting-started.md"}) {
    const std::string text = contentOf(root / page);
    const std::size_t format = text.find("\"format\": \"goniolux-project\"");
    ASSERT_NE(format, std::string::npos) << page;
    const std::size_t begin = text.rfind("```json", format), from = text.find('\n', begin) + 1;
    const std::size_t end = text.find("```", from);
    const TemporaryFolder folder;
    folder.write("project.json", text.substr(from, end - from));
    const Outcome outcome = goniolux({"check", folder.path().string()});
    EXPECT_EQ(outcome.exitCode, 0) << page << '\n' << outcome.err;
    ++seen;
  }
  EXPECT_EQ(seen, 2);
}

// The negative control: a page in which everything is wrong.
TEST(Pages, CommandsAndLinksAreFoundWithTheirLines) {
  const TemporaryFolder folder;
  const fs::path page =
      folder.write("page.md",
                   "see [a](b.md) and ![c](d.png)\n```sh\nA=1 goniolux run \"my room\" --accuracy '1 %'  # one\n"
                   "```\n```json\ngoniolux nothing [x](y)\n```\n");
  const auto commands = commandsOf(page);
  ASSERT_EQ(commands.size(), 1u);
  EXPECT_EQ(commands[0].place.line, 3);
  EXPECT_EQ(commands[0].words, (std::vector<std::string>{"goniolux", "run", "my room", "--accuracy", "1 %"}));
  const auto links = linksOf(page);
  ASSERT_EQ(links.size(), 2u);
  EXPECT_EQ(links[1].target, "d.png");
}

}  // namespace
}  // namespace goniolux::test
