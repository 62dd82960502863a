// Runs that are killed and resumed give the same bytes as one that was left alone, with any number of threads.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <random>
#include <regex>
#include <thread>

#include "core/document.h"
#include "core/parallel.h"
#include "pipeline/stages.h"
#include "support/temporary_folder.h"

namespace goniolux::pipeline {
namespace {

namespace fs = std::filesystem;

// Two rooms in one with a wall between, so that there are shadows; a grid, another quantity, an observer, a picture.
constexpr const char* office = R"({
  "format": "goniolux-project", "version": 1, "name": "office",
  "materials": { "grey": { "model": "lambert", "diffuse": 0.6 } },
  "objects": [
    { "name": "room", "shape": "box", "min": [0,0,0], "max": [4,3,2.5], "facing": "inward", "material": "grey" },
    { "name": "screen", "shape": "box", "min": [1.9,0,0], "max": [2.0,2,1.8], "material": "grey" } ],
  "luminaires": [ { "name": "L", "photometry": "cosine", "flux": 2000, "position": [1.3,1.5,2.4], "group": "a",
                    "shape": { "rectangle": { "length": 0.6, "width": 0.6 } } },
                  { "name": "M", "photometry": "cosine", "flux": 900, "position": [3,1.5,2.4], "group": "b",
                    "shape": { "rectangle": { "length": 0.6, "width": 0.6 } } } ],
  "grids": [ { "name": "plane", "origin": [0,0,0.8], "u": [4,0,0], "v": [0,3,0], "counts": [10,8], "normal": [0,0,1] },
             { "name": "faces", "points": [[1,1,1.2],[3,1,1.2]], "normal": [1,0,0], "quantity": "cylindrical" } ],
  "observers": [ { "name": "seat", "eye": [3.8,1.5,1.2], "direction": [-1,0,0], "quantity": "ugr" } ],
  "views": [ { "name": "door", "eye": [0.3,0.3,1.6], "target": [3,2.5,1], "up": [0,0,1], "fov": 70, "width": 40, "height": 30 } ],
  "settings": { "accuracy": { "grid": "2 %", "u0": "4 %", "image": "10 %" }, "pixel": { "max_samples": 128 } }
})";

constexpr int refused = 2, broken = 3;

class Resume : public testing::Test {
 protected:
  /// A stage in a process of its own: its exit code, or -1 when it was killed after `milliseconds`.
  int ran(Stage (*stage)(), const std::string& output, bool resumes, int threads, int milliseconds = -1,
          const std::string& seed = "1") const {
    std::fflush(nullptr);
    const pid_t child = fork();
    if (child == 0) {
      core::setThreadCount(threads);
      StageRequest request;
      request.inputs = {(folder_.path() / "p").string()};
      request.common.output = (folder_.path() / output).string();
      request.common.set = {"seed=" + seed};
      request.keepEvery_s = 0;
      if (resumes) request.options["resume"] = "true";
      core::SilentProgress silent;
      int code = 0;
      try {
        stage().run(request, silent);
      } catch (const core::InputError& error) {
        folder_.write("message", error.what());
        code = refused;
      } catch (const std::exception& error) {
        folder_.write("message", error.what());
        code = broken;
      }
      _exit(code);
    }
    if (milliseconds >= 0) {
      std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
      kill(child, SIGKILL);
    }
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  [[nodiscard]] std::string message() const { return test::contentOf(folder_.path() / "message"); }

  /// The results' files without what time it took; plots are left to the stage that draws them.
  [[nodiscard]] std::map<std::string, std::string> results(const std::string& output) const {
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder_.path() / output)) {
      const std::string name = entry.path().lexically_relative(folder_.path() / output).generic_string();
      if (!entry.is_regular_file() || name == "log.jsonl" || name.ends_with(".part")) continue;
      const std::regex times(R"re("(wall|cpu)": [0-9.e+-]+)re");
      files[name] = std::regex_replace(test::contentOf(entry.path()), times, "");
    }
    return files;
  }

  void expectSameAfterKills(Stage (*stage)(), unsigned seed, int longest, const std::string& settings = "") {
    std::string project = office;
    project.insert(project.find("\"accuracy\""), settings);
    folder_.write("p/project.json", project);
    ASSERT_EQ(ran(stage, "whole", false, 2), 0) << message();
    std::mt19937 random(seed);
    int kills = 0, last = -1;
    for (int attempt = 0; attempt < 25 && last == -1; ++attempt) {
      last =
          ran(stage, "killed", attempt > 0, 1 + attempt % 3, std::uniform_int_distribution<int>(20, longest)(random));
      kills += last == -1 ? 1 : 0;
      ASSERT_NE(last, broken) << message();
      ASSERT_NE(last, refused) << message();
    }
    if (last == -1) {
      ASSERT_EQ(ran(stage, "killed", true, 2), 0) << message();
    }
    EXPECT_GT(kills, 0) << "the runs were too short to be killed";
    const auto expected = results("whole"), found = results("killed");
    for (const auto& [name, content] : expected) {
      ASSERT_TRUE(found.contains(name)) << name;
      EXPECT_TRUE(found.at(name) == content) << name << " differs after " << kills << " kills";
    }
    EXPECT_EQ(found.size(), expected.size());
    EXPECT_FALSE(fs::exists(folder_.path() / "killed/checkpoint"));
  }

  test::TemporaryFolder folder_;
};

TEST_F(Resume, GridsAndObserversAreTheSameAfterKills) {
  expectSameAfterKills(illuminateStage, 1, 150);
}

TEST_F(Resume, PicturesAreTheSameAfterKills) {
  expectSameAfterKills(renderStage, 2, 150);
}

TEST_F(Resume, ScenesAreTheSameAfterKills) {
  // By whole paths: the light solution is slow where a lamp that is off hangs close below a ceiling.
  expectSameAfterKills(scenesStage, 3, 150, R"("solver": "path", )");
}

TEST_F(Resume, ARunWithOtherInputsOrSettingsIsRefusedAndToldWhichChanged) {
  folder_.write("p/project.json", office);
  for (int wait = 50; !fs::exists(folder_.path() / "out/checkpoint/finished.work") && wait < 8000; wait += wait / 2)
    ran(illuminateStage, "out", false, 1, wait);
  ASSERT_TRUE(fs::exists(folder_.path() / "out/checkpoint/finished.work"));
  EXPECT_EQ(ran(illuminateStage, "out", true, 1, -1, "7"), refused);
  EXPECT_NE(message().find("seed was 1 and is 7"), std::string::npos) << message();
  EXPECT_EQ(ran(renderStage, "out", true, 1), refused);
  EXPECT_NE(message().find("the verb was illuminate and is render"), std::string::npos) << message();
  std::string other = office;
  other.replace(other.find("0.6 }"), 3, "0.5");
  folder_.write("p/project.json", other);
  EXPECT_EQ(ran(illuminateStage, "out", true, 1), refused);
  EXPECT_NE(message().find("project.json has changed"), std::string::npos) << message();
  folder_.write("p/project.json", office);
  EXPECT_EQ(ran(illuminateStage, "out", true, 1), 0) << "a refusal spoils nothing: " << message();
}

TEST_F(Resume, ADamagedCheckpointIsNamedAndARunWithoutResumeReplacesIt) {
  folder_.write("p/project.json", office);
  folder_.write("out/checkpoint/finished.work", std::string(5000, 'x'));
  EXPECT_EQ(ran(illuminateStage, "out", true, 1), refused);
  EXPECT_NE(message().find("damaged"), std::string::npos) << message();
  EXPECT_EQ(ran(illuminateStage, "out", false, 1), 0) << message();
  EXPECT_FALSE(fs::exists(folder_.path() / "out/checkpoint"));
}

TEST_F(Resume, WithoutACheckpointItBeginsAtTheBeginning) {
  folder_.write("p/project.json", office);
  EXPECT_EQ(ran(illuminateStage, "out", true, 1), 0) << message();
  std::ifstream log(folder_.path() / "out/log.jsonl");
  std::string line, last;
  while (std::getline(log, line)) {
    core::Diagnostics diagnostics;
    const core::Value event = core::parseJson(line, "log.jsonl", diagnostics);
    EXPECT_FALSE(diagnostics.hasErrors()) << line;
    ASSERT_NE(event.find("event"), nullptr) << line;
    last = event.find("event")->string();
  }
  EXPECT_EQ(last, "end");
}

}  // namespace
}  // namespace goniolux::pipeline
