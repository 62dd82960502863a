// `verify` from the outside: what it flags, what it names as the cause, what it writes, and what survives.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>

#include <chrono>
#include <thread>

#include "cli/projects.h"
#include "support/program.h"

namespace goniolux::test {
namespace {

namespace fs = std::filesystem;

/// Little interreflection, so little noise: a run takes a moment.
const std::string room = changed(smallRoom, "\"diffuse\": 0.5", "\"diffuse\": 0.1");

class Verify : public testing::Test {
 protected:
  void write(const std::string& name, const std::string& text = room) {
    fs::create_directories(folder_.path() / "projects" / name);
    folder_.write("projects/" + name + "/project.json", text);
  }
  [[nodiscard]] std::string projects() const { return (folder_.path() / "projects").string(); }
  [[nodiscard]] std::string out() const { return (folder_.path() / "out").string(); }
  Outcome verify(std::vector<std::string> more) const {
    std::vector<std::string> arguments{"verify", projects(), "-o", out()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return goniolux(arguments);
  }
  void makeBaselines(const std::string& accuracy = "4 %") {
    const Outcome outcome = verify({"--update", "--accuracy", accuracy});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.out << outcome.err;
  }
  static const core::Value& project(const core::Value& document, std::size_t index) {
    return document.find("projects")->array().at(index);
  }
  static std::string verdict(const core::Value& document, std::size_t index) {
    return project(document, index).find("verdict")->string();
  }
  /// All changed inputs and differences of a project as one text.
  static std::string told(const core::Value& document, std::size_t index) {
    return core::toJson(*project(document, index).find("changed_inputs")) +
           core::toJson(*project(document, index).find("differences"));
  }
  TemporaryFolder folder_;
};

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST_F(Verify, AnUnchangedProjectPassesWithAnotherSeedAndOtherThreads) {
  write("a");
  makeBaselines();
  EXPECT_TRUE(fs::exists(folder_.path() / "projects/a/expected.json"));
  for (const char* seed : {"11", "12", "13"}) {
    const Outcome outcome = verify({"--seed", seed, "--threads", "2", "-j", "1", "--json"});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.out << outcome.err;
    EXPECT_EQ(verdict(oneDocument(outcome.out), 0), "pass");
  }
}

TEST_F(Verify, AChangedReflectanceIsSeenInTheValuesAndNamed) {
  write("a");
  makeBaselines();
  write("a", changed(room, "\"diffuse\": 0.1", "\"diffuse\": 0.3"));
  const Outcome outcome = verify({"--seed", "5", "--json"});
  EXPECT_EQ(outcome.exitCode, 1) << outcome.err;
  const core::Value document = oneDocument(outcome.out);
  EXPECT_EQ(verdict(document, 0), "fail");
  EXPECT_TRUE(contains(told(document, 0), "materials \\\"grey\\\"")) << told(document, 0);
  EXPECT_FALSE(contains(told(document, 0), "objects")) << told(document, 0);
  EXPECT_TRUE(contains(told(document, 0), "mean")) << told(document, 0);
}

TEST_F(Verify, ToleranceSilencesASmallChangeAndUpdateRenewsTheBaseline) {
  write("a");
  makeBaselines();
  write("a", changed(room, "\"flux\": 1000", "\"flux\": 1100"));
  EXPECT_EQ(verify({"--seed", "5"}).exitCode, 1);
  EXPECT_EQ(verify({"--seed", "5", "--tolerance", "12 %"}).exitCode, 0);
  const Outcome update = verify({"--seed", "6", "--update"});
  EXPECT_EQ(update.exitCode, 0) << update.err;
  EXPECT_TRUE(contains(update.out, "+10 %") || contains(update.out, "+9"))
      << "the difference comes first: " << update.out;
  EXPECT_EQ(verify({"--seed", "7"}).exitCode, 0);
}

TEST_F(Verify, ValuesOfAnotherSourceAreKeptByUpdateWhileTheyHold) {
  write("a");
  makeBaselines();
  core::Value baseline = oneDocument(contentOf(folder_.path() / "projects/a/expected.json"));
  double mean = 0;
  for (const core::Value& value : baseline.find("values")->array())
    if (value.find("quantity")->string() == "mean") mean = value.find("value")->number();
  const auto foreign = [&](double value) {
    return R"({ "format": "goniolux-expected", "version": 1, "source": "a long run of another program",
      "values": [ { "grid": "work plane", "quantity": "mean", "value": )" +
           std::to_string(value) + R"(, "half_width": 1, "unit": "lx" } ] })";
  };
  folder_.write("projects/a/expected.json", foreign(mean));
  EXPECT_EQ(verify({}).exitCode, 0) << "the form without own values is read as it always was";
  EXPECT_EQ(verify({"--update"}).exitCode, 0);
  EXPECT_TRUE(contains(contentOf(folder_.path() / "projects/a/expected.json"), "a long run of another program"));
  folder_.write("projects/a/expected.json", foreign(1.5 * mean));
  EXPECT_EQ(verify({}).exitCode, 1);
  const Outcome update = verify({"--update"});
  EXPECT_TRUE(contains(update.out, "taken out")) << update.out;
}

TEST_F(Verify, ABrokenProjectAndABrokenBaselineFailAlone) {
  write("a");
  write("b");
  write("c");
  makeBaselines();
  folder_.write("projects/a/project.json", "{ \"format\": ");
  folder_.write("projects/b/expected.json",
                "{ \"format\": \"goniolux-expected\", \"version\": 1, \"values\": [ {} ] }");
  const Outcome outcome = verify({"--json"});
  EXPECT_EQ(outcome.exitCode, 2);
  const core::Value document = oneDocument(outcome.out);
  EXPECT_EQ(verdict(document, 0), "error");
  EXPECT_EQ(verdict(document, 1), "error");
  EXPECT_EQ(verdict(document, 2), "pass");
  EXPECT_TRUE(contains(project(document, 0).find("error")->string(), "project.json:1:"));
  EXPECT_TRUE(contains(project(document, 1).find("error")->string(), "expected.json:1:"));
  EXPECT_TRUE(contains(contentOf(folder_.path() / "out/junit.xml"), "errors=\"2\""));
  EXPECT_TRUE(contains(contentOf(folder_.path() / "out/index.html"), "1 of 3 projects unchanged"));
}

TEST_F(Verify, ShardsPartTheProjectsAndResumeTakesOverWhatIsDone) {
  for (const char* name : {"a", "b", "c"}) write(name);
  makeBaselines();
  std::size_t together = 0;
  for (const char* shard : {"1/2", "2/2"}) {
    const Outcome outcome = verify({"--shard", shard, "--json"});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    together += oneDocument(outcome.out).find("projects")->array().size();
  }
  EXPECT_EQ(together, 3u);
  const fs::path kept = folder_.path() / "out/projects";
  std::size_t results = 0;
  for (const auto& entry : fs::recursive_directory_iterator(kept)) results += entry.path().filename() == "grids.json";
  EXPECT_EQ(results, 3u);
  const Outcome resumed = verify({"--resume"});
  EXPECT_EQ(resumed.exitCode, 0);
  EXPECT_TRUE(contains(resumed.out, "(kept)")) << resumed.out;
  write("b", changed(room, "\"flux\": 1000", "\"flux\": 2000"));
  const core::Value document = oneDocument(verify({"--resume", "--json"}).out);
  EXPECT_EQ(verdict(document, 1), "fail") << "a kept result of another input is no result";
}

TEST_F(Verify, ABatchOutOfTimeKeepsWhatIsDoneAndSaysSo) {
  for (const char* name : {"a", "b", "c", "d"}) write(name);
  makeBaselines();
  const Outcome outcome = verify({"--accuracy", "1 %", "--time-limit", "0.01", "-j", "1", "--json"});
  EXPECT_EQ(outcome.exitCode, 3);
  EXPECT_TRUE(contains(outcome.err, "--resume")) << outcome.err;
  EXPECT_EQ(verify({"--resume", "--accuracy", "2 %"}).exitCode, 0);
}

TEST_F(Verify, AnUnwritableFolderOrAProjectThatMayNotBeWrittenLosesNothing) {
  write("a");
  makeBaselines();
  const std::string before = contentOf(folder_.path() / "projects/a/expected.json");
  folder_.write("a-file", "");
  const Outcome nowhere = goniolux({"verify", projects(), "-o", (folder_.path() / "a-file/out").string()});
  EXPECT_EQ(nowhere.exitCode, 3) << nowhere.err;
  EXPECT_TRUE(contains(nowhere.err, "a-file")) << nowhere.err;
  EXPECT_EQ(contentOf(folder_.path() / "projects/a/expected.json"), before);
}

TEST_F(Verify, AFullDiskIsSaidBaselinesStayAndTheBatchCanGoOn) {
  write("a");
  makeBaselines();
  const std::string before = contentOf(folder_.path() / "projects/a/expected.json");
  write("a", changed(room, "\"flux\": 1000", "\"flux\": 3000"));
  // No file may grow beyond 1 KiB: what a disk that is nearly full does to all of them.
  const std::string command =
      "trap '' XFSZ; ulimit -f 1; exec '" GONIOLUX_PROGRAM "' verify '" + projects() + "' -o '" + out() + "' --update";
  const Outcome full = Running({"bash", "-c", command}).wait();
  EXPECT_EQ(full.exitCode, 3) << full.out << full.err;
  EXPECT_TRUE(contains(full.out + full.err, "cannot be written")) << full.out << full.err;
  EXPECT_EQ(contentOf(folder_.path() / "projects/a/expected.json"), before);
  for (const auto& entry : fs::recursive_directory_iterator(folder_.path()))
    EXPECT_NE(entry.path().extension(), ".part") << entry.path();
  EXPECT_EQ(verify({"--resume"}).exitCode, 1) << "with room on the disk the change is found";
}

TEST_F(Verify, OptionsThatCannotBeMeantAreRefused) {
  write("a");
  const std::vector<std::vector<std::string>> wrong{
      {"--shard", "3/2"}, {"--shard", "x"}, {"--tolerance", "1"}, {"--false-alarms", "0 %"}, {"-j", "0"}};
  for (const auto& options : wrong) EXPECT_EQ(verify(options).exitCode, 2) << options[0] << ' ' << options[1];
  EXPECT_EQ(goniolux({"verify", (folder_.path() / "nowhere").string()}).exitCode, 2);
  fs::create_directories(folder_.path() / "empty");
  const Outcome outcome = goniolux({"verify", (folder_.path() / "empty").string()});
  EXPECT_EQ(outcome.exitCode, 2);
  EXPECT_TRUE(contains(outcome.err, "project.json")) << outcome.err;
}

}  // namespace
}  // namespace goniolux::test
