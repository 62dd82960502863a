// Bad input: each case gets a message that says where and what, exit code 2, and leaves earlier results untouched.
#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>
#include <regex>

#include "cli/projects.h"
#include "pipeline/stage.h"
#include "support/program.h"

namespace goniolux::test {
namespace {

struct Case {
  std::string name, part, replacement;  ///< how the small room is spoiled
  std::string says;                     ///< what the message must contain, lower case
};

std::ostream& operator<<(std::ostream& stream, const Case& c) {
  return stream << c.name;
}

class SpoiledProject : public testing::TestWithParam<Case> {};

std::string lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

// Every verb that needs nothing but a project.
std::vector<std::string> verbsOfProjects() {
  std::vector<std::string> verbs;
  for (const pipeline::Stage& stage : pipeline::stages()) {
    const auto isRequired = [](const core::Parameter& option) { return option.required; };
    if (stage.inputName == "PROJECT" && std::none_of(stage.options.begin(), stage.options.end(), isRequired))
      verbs.push_back(stage.name);
  }
  return verbs;
}

TEST_P(SpoiledProject, IsRefusedWithItsPlaceAndLeavesEarlierResultsUntouched) {
  const TemporaryFolder folder;
  const std::string project = folder.write("project.json", changed(smallRoom, GetParam().part, GetParam().replacement));
  folder.write("results/grids.json", "earlier");
  const auto before = snapshot(folder.path());
  for (const std::string& verb : verbsOfProjects()) {
    const Outcome outcome = goniolux({verb, folder.path().string()});
    EXPECT_EQ(outcome.exitCode, 2) << verb << '\n' << outcome.err;
    EXPECT_TRUE(std::regex_search(outcome.err, std::regex("project\\.json:[0-9]+:[0-9]+: error: "))) << verb << '\n'
                                                                                                     << outcome.err;
    EXPECT_NE(lower(outcome.err).find(GetParam().says), std::string::npos) << verb << '\n' << outcome.err;
    EXPECT_EQ(snapshot(folder.path()), before) << verb;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Each, SpoiledProject,
    testing::Values(Case{"BrokenJson", "\"version\": 1,", "\"version\" 1,", "colon"},
                    Case{"MissingFile", "\"photometry\": \"isotropic\"", "\"photometry\": \"lost.ies\"", "lost.ies"},
                    Case{"UnknownKey", "\"counts\"", "\"count\"", "counts"},
                    Case{"NegativeLength", "\"u\": [4,0,0]", "\"shape\": { \"disc\": { \"diameter\": -1 } }", "u"},
                    Case{"NegativeDiameter", "\"position\": [2,1.5,2]",
                         "\"position\": [2,1.5,2], \"shape\": { \"sphere\": { \"diameter\": -0.1 } }", "diameter"},
                    Case{"NegativeFlux", "\"flux\": 1000", "\"flux\": -1000", "flux"},
                    Case{"ReflectanceAboveOne", "\"diffuse\": 0.5", "\"diffuse\": 1.5", "1.5"},
                    Case{"ReflectanceNotANumber", "\"diffuse\": 0.5", "\"diffuse\": NaN", "nan"},
                    Case{"GridWhollyOutside", "\"origin\": [0,0,0.8]", "\"origin\": [0,0,9.8]", "outside"},
                    Case{"UnknownMaterial", "\"material\": \"grey\"", "\"material\": \"gray\"", "grey"},
                    Case{"WrongUnits", "\"units\": \"m\"", "\"units\": \"km\"", "km"},
                    Case{
                        "TwoGridsOfOneFileName", "\"grids\": [",
                        "\"grids\": [ { \"name\": \"Work-plane\", \"origin\": [0,0,1], \"u\": [1,0,0], \"v\": [0,1,0], "
                        "\"counts\": [1,1] },",
                        "work-plane"}),
    [](const auto& which) { return which.param.name; });

TEST(BadInput, AViewInsideAnObjectIsRefused) {
  const TemporaryFolder folder;
  folder.write(
      "project.json",
      changed(smallRoom, "\"objects\": [",
              "\"objects\": [ { \"name\": \"block\", \"shape\": \"box\", \"min\": [0.2,0.2,0], \"max\": [1,1,2], "
              "\"material\": \"grey\" },"));
  const auto before = snapshot(folder.path());
  const Outcome outcome = goniolux({"render", folder.path().string(), "--view", "door"});
  EXPECT_EQ(outcome.exitCode, 2) << outcome.err;
  EXPECT_NE(outcome.err.find("block"), std::string::npos) << outcome.err;
  EXPECT_EQ(snapshot(folder.path()), before);
}

TEST(BadInput, AProjectThatIsNotThereIsNamed) {
  const Outcome outcome = goniolux({"check", "no-such-folder"});
  EXPECT_EQ(outcome.exitCode, 2);
  EXPECT_NE(outcome.err.find("no-such-folder"), std::string::npos) << outcome.err;
}

TEST(BadInput, CheckWithJsonListsEveryErrorWithItsPlace) {
  const TemporaryFolder folder;
  folder.write("project.json", changed(changed(smallRoom, "\"diffuse\": 0.5", "\"diffuse\": 1.5"), "\"flux\": 1000",
                                       "\"flux\": -1000"));
  const Outcome outcome = goniolux({"check", folder.path().string(), "--json"});
  EXPECT_EQ(outcome.exitCode, 2);
  const core::Value document = oneDocument(outcome.out);
  ASSERT_NE(document.find("errors"), nullptr) << outcome.out;
  EXPECT_EQ(document.find("errors")->array().size(), 2u) << outcome.out;
  for (const core::Value& error : document.find("errors")->array()) {
    EXPECT_GT(error.find("line")->number(), 0) << outcome.out;
    EXPECT_GT(error.find("column")->number(), 0) << outcome.out;
    EXPECT_NE(error.find("message")->string(), "");
  }
}

TEST(BadInput, AnUnknownSettingOnTheCommandLineIsRefused) {
  const TemporaryFolder folder;
  folder.write("project.json", smallRoom);
  const Outcome outcome = goniolux({"check", folder.path().string(), "--set", "tree.cutof=0.01"});
  EXPECT_EQ(outcome.exitCode, 2);
  EXPECT_NE(outcome.err.find("cutoff"), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace goniolux::test
