// The installed tree: programs that find their data and helpers from where they stand, manual pages, completion, and
// the CMake package of the engine.
#include <gtest/gtest.h>

#include <filesystem>

#include "support/program.h"

namespace goniolux::test {
namespace {

namespace fs = std::filesystem;

Outcome shell(const std::string& command) {
  return Running({"/bin/sh", "-c", command}).wait();
}

/// Installed once for all tests, into a folder of its own.
class Installed : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new TemporaryFolder;
    const Outcome outcome = shell("cmake --install '" GONIOLUX_BINARY_DIR "' --prefix '" + prefix() + "'");
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
  }
  static void TearDownTestSuite() { delete folder_; }
  static std::string prefix() { return (folder_->path() / "usr").string(); }
  static std::string program() { return prefix() + "/bin/goniolux"; }
  static TemporaryFolder* folder_;
};
TemporaryFolder* Installed::folder_ = nullptr;

TEST_F(Installed, TheProgramFindsItsLuminairesWhereItIsInstalled) {
  // A change of the installed file must be seen: the one of the source tree would be found otherwise.
  const fs::path luminaire = fs::path(prefix()) / "share/goniolux/luminaires/only-installed.ies";
  fs::copy_file(fs::path(prefix()) / "share/goniolux/luminaires/panel-600.ies", luminaire);
  folder_->write("room/project.json", R"({ "format": "goniolux-project", "version": 1, "units": "m",
    "materials": { "grey": { "model": "lambert", "diffuse": 0.5 } },
    "objects": [ { "name": "room", "shape": "box", "min": [0,0,0], "max": [4,3,2.5], "facing": "inward", "material": "grey" } ],
    "luminaires": [ { "name": "L", "photometry": "only-installed.ies", "position": [2,1.5,2.5] } ],
    "grids": [ { "name": "g", "origin": [0,0,0.8], "u": [4,0,0], "v": [0,3,0], "counts": [4,3] } ] })");
  const std::string room = (folder_->path() / "room").string();
  const Outcome outcome = shell("'" + program() + "' check '" + room + "'");
  EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
  const Outcome plotted = shell("'" + program() + "' illuminate '" + room + "' --accuracy '20 %' --quiet && '" +
                                program() + "' plot '" + room + "/results' --format svg");
  EXPECT_EQ(plotted.exitCode, 0) << plotted.err;
  EXPECT_TRUE(fs::exists(fs::path(room) / "results/g.svg")) << "the drawing helper was not found: " << plotted.err;
}

TEST_F(Installed, EveryVerbHasAManualPageThatTheManReaderAccepts) {
  for (const std::string& verb :
       {std::string("goniolux"), std::string("goniolux-run"), std::string("goniolux-verify")}) {
    const std::string page = prefix() + "/share/man/man1/" + verb + ".1.gz";
    ASSERT_TRUE(fs::exists(page)) << page;
    if (shell("command -v man").exitCode != 0) continue;
    const Outcome outcome = shell("MANROFFSEQ= MANWIDTH=100 man --warnings -l '" + page + "' | cat");
    EXPECT_EQ(outcome.err, "") << verb;
    EXPECT_NE(outcome.out.find("EXIT STATUS"), std::string::npos) << outcome.out;
  }
  const Outcome verbs = shell("'" + program() + "' --verbs");
  EXPECT_NE(verbs.out.find("illuminate\n"), std::string::npos);
}

TEST_F(Installed, BashCompletesVerbsAndTheOptionsOfEach) {
  const std::string script = prefix() + "/share/bash-completion/completions/goniolux";
  const auto completed = [&](const std::string& words, int index) {
    return Running({"bash", "-c",
                    "source '" + script + "'; COMP_WORDS=(" + words + "); COMP_CWORD=" + std::to_string(index) +
                        "; _goniolux; echo \"${COMPREPLY[*]}\""})
        .wait()
        .out;
  };
  EXPECT_EQ(completed("goniolux ver", 1), "verify\n");
  EXPECT_EQ(completed("goniolux verify --res", 2), "--resume\n");
  EXPECT_EQ(completed("goniolux report --lang", 2), "--language\n");
  EXPECT_EQ(completed("goniolux run --resu", 2), "--resume\n");
  EXPECT_EQ(completed("goniolux run --lang", 2), "\n") << "run has no such option";
}

TEST_F(Installed, DesktopFileIsValid) {
  const std::string file = prefix() + "/share/applications/goniolux-studio.desktop";
  ASSERT_TRUE(fs::exists(file));
  if (shell("command -v desktop-file-validate").exitCode != 0) GTEST_SKIP() << "desktop-file-validate is not installed";
  const Outcome outcome = shell("desktop-file-validate '" + file + "'");
  EXPECT_EQ(outcome.exitCode, 0) << outcome.out << outcome.err;
}

TEST_F(Installed, AnotherProgramBuildsOnTheEngine) {
  const std::string build = (folder_->path() / "example").string();
  const Outcome made =
      shell("cmake -S '" GONIOLUX_SOURCE_DIR "/tests/install/example' -B '" + build +
            "' -DCMAKE_BUILD_TYPE=Release -DCMAKE_PREFIX_PATH='" + prefix() + "' && cmake --build '" + build + "'");
  ASSERT_EQ(made.exitCode, 0) << made.out << made.err;
  const Outcome outcome = shell("'" + build + "/room_light' '" + prefix() + "/share/goniolux/projects/validation/R1'");
  ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
  double mean = 0, halfWidth = 0;
  ASSERT_EQ(std::sscanf(outcome.out.c_str(), "work plane: %lf lx, half-width %lf lx", &mean, &halfWidth), 2)
      << outcome.out;
  // projects/validation/R1/expected.json: 578.37 lx of an independent path tracer, ± 0.46; the example asks for 5 %.
  EXPECT_NEAR(mean, 578.4, 0.05 * 578.4);
  EXPECT_GT(halfWidth, 0);
}

}  // namespace
}  // namespace goniolux::test
