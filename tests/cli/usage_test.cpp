// The command line itself: help, mistakes in usage, and where what is said goes.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>

#include "pipeline/stage.h"
#include "support/program.h"

namespace goniolux::test {
namespace {

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// The text with every run of spaces and line ends as one space: help is wrapped.
std::string onOneLine(const std::string& text) {
  std::string line;
  for (const char c : text)
    if (c != ' ' && c != '\n')
      line += c;
    else if (line.empty() || line.back() != ' ')
      line += ' ';
  return line;
}

TEST(Usage, HelpListsEveryVerb) {
  const Outcome outcome = goniolux({"--help"});
  EXPECT_EQ(outcome.exitCode, 0);
  EXPECT_EQ(outcome.err, "");
  for (const pipeline::Stage& stage : pipeline::stages()) {
    EXPECT_TRUE(contains(outcome.out, "\n  " + stage.name)) << stage.name;
    EXPECT_TRUE(contains(onOneLine(outcome.out), stage.title.substr(1))) << stage.title;
  }
}

TEST(Usage, HelpOfEachVerbNamesItsOptionsWithUnitsAndDefaults) {
  for (const pipeline::Stage& stage : pipeline::stages()) {
    const Outcome outcome = goniolux({stage.name, "--help"});
    EXPECT_EQ(outcome.exitCode, 0) << stage.name;
    EXPECT_TRUE(contains(outcome.out, "usage: goniolux " + stage.name)) << outcome.out;
    EXPECT_TRUE(contains(outcome.out, "--json")) << stage.name;
    for (const core::Parameter& option : stage.options) {
      EXPECT_TRUE(contains(outcome.out, "--" + option.key)) << stage.name << " --" << option.key;
      const std::string unit = option.unit.empty() ? "" : "[" + option.unit + "]";
      EXPECT_TRUE(contains(outcome.out, unit)) << option.key;
      const std::string byDefault = option.defaultText.empty() ? "" : "default: " + option.defaultText;
      EXPECT_TRUE(contains(onOneLine(outcome.out), byDefault)) << option.key;
    }
    EXPECT_EQ(goniolux({"help", stage.name}).out, outcome.out);
  }
}

TEST(Usage, EveryStageDescribesItselfInTheRegistry) {
  for (const pipeline::Stage& stage : pipeline::stages()) {
    EXPECT_FALSE(stage.title.empty()) << stage.name;
    EXPECT_FALSE(stage.title.ends_with('.')) << stage.name << ": the help adds the full stop";
    EXPECT_NE(stage.run, nullptr) << stage.name;
    for (const core::Parameter& option : stage.options) {
      EXPECT_FALSE(option.help.empty() && option.title.empty()) << stage.name << " --" << option.key;
      EXPECT_FALSE(contains(option.key, "_")) << option.key << ": words of an option are joined by '-'";
    }
  }
}

TEST(Usage, TheVersionIsOneLine) {
  const Outcome outcome = goniolux({"--version"});
  EXPECT_EQ(outcome.exitCode, 0);
  EXPECT_TRUE(outcome.out.starts_with("goniolux ")) << outcome.out;
  EXPECT_EQ(std::count(outcome.out.begin(), outcome.out.end(), '\n'), 1);
}

TEST(Usage, NoVerbIsAnErrorThatPointsToTheHelp) {
  const Outcome outcome = goniolux({});
  EXPECT_EQ(outcome.exitCode, 2);
  EXPECT_EQ(outcome.out, "");
  EXPECT_TRUE(contains(outcome.err, "goniolux --help")) << outcome.err;
}

TEST(Usage, AMistypedVerbIsRefusedWithTheClosestOne) {
  const Outcome outcome = goniolux({"luminair", "x.ies"});
  EXPECT_EQ(outcome.exitCode, 2);
  EXPECT_EQ(outcome.out, "");
  EXPECT_TRUE(contains(outcome.err, "did you mean 'goniolux luminaire'")) << outcome.err;
}

TEST(Usage, AMistypedOptionIsRefusedWithTheClosestOne) {
  const Outcome outcome = goniolux({"check", "somewhere", "--thread", "2"});
  EXPECT_EQ(outcome.exitCode, 2);
  EXPECT_TRUE(contains(outcome.err, "'--threads'")) << outcome.err;
}

TEST(Usage, ValuesOfTheWrongKindAreRefusedByName) {
  const std::vector<std::vector<std::string>> wrong = {
      {"--threads", "0"},    {"--threads", "two"},           {"--seed", "-1"},        {"--seed", "1.5"},
      {"--time-limit", "0"}, {"--time-limit", ""},           {"--time-limit", "x"},   {"--set", "depth"},
      {"--accuracy", ""},    {"--seed", "1", "--seed", "2"}, {"--time-limit", "nan"}, {"--solver"},
  };
  for (const auto& options : wrong) {
    std::vector<std::string> arguments = {"check", "somewhere"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome outcome = goniolux(arguments);
    EXPECT_EQ(outcome.exitCode, 2) << options.front();
    EXPECT_TRUE(contains(outcome.err, options.front())) << outcome.err;
    EXPECT_FALSE(contains(outcome.err, "somewhere")) << "the project was read before the options: " << outcome.err;
  }
}

TEST(Usage, AnOptionThatTheVerbCannotObeyIsRefusedAndNotIgnored) {
  const Outcome accuracy = goniolux({"luminaire", "x.ies", "--accuracy", "1 %"});
  EXPECT_EQ(accuracy.exitCode, 2);
  EXPECT_TRUE(contains(accuracy.err, "--accuracy")) << accuracy.err;
  const Outcome resume = goniolux({"check", "somewhere", "--resume"});
  EXPECT_EQ(resume.exitCode, 2);
  EXPECT_TRUE(contains(resume.err, "has no option --resume")) << resume.err;
}

TEST(Usage, TooFewAndTooManyInputsAreRefused) {
  EXPECT_EQ(goniolux({"check"}).exitCode, 2);
  const Outcome outcome = goniolux({"check", "one", "two"});
  EXPECT_EQ(outcome.exitCode, 2);
  EXPECT_TRUE(contains(outcome.err, "'two'")) << outcome.err;
}

TEST(Usage, WithJsonAMistakeIsOneDocumentToo) {
  const Outcome outcome = goniolux({"check", "somewhere", "--json", "--thread", "2"});
  EXPECT_EQ(outcome.exitCode, 2);
  const core::Value document = oneDocument(outcome.out);
  ASSERT_NE(document.find("errors"), nullptr) << outcome.out;
  ASSERT_EQ(document.find("errors")->array().size(), 1u);
  EXPECT_EQ(document.find("errors")->array()[0].find("rule")->string(), "usage");
  EXPECT_NE(outcome.err, "");
}

TEST(Usage, AFullDiskUnderStandardOutputIsExitCodeThree) {
  Running running({GONIOLUX_PROGRAM, "--help"}, "/dev/full");
  const Outcome outcome = running.wait();
  EXPECT_EQ(outcome.exitCode, 3);
  EXPECT_TRUE(contains(outcome.err, "standard output")) << outcome.err;
}

TEST(Program, LinksNeitherVtkNorQt) {
  const Outcome outcome = Running({"ldd", GONIOLUX_PROGRAM}).wait();
  ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
  ASSERT_TRUE(contains(outcome.out, "libstdc++")) << "ldd lists nothing:\n" << outcome.out;
  EXPECT_FALSE(contains(outcome.out, "libvtk")) << outcome.out;
  EXPECT_FALSE(contains(outcome.out, "libQt")) << outcome.out;
}

double childrensCpuSeconds() {
  rusage usage{};
  getrusage(RUSAGE_CHILDREN, &usage);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

// 13 ms of CPU time were measured, most of it the dynamic linker's; loading VTK and Qt would add 30 ms. The best of
// several counts, because the machine has other work.
TEST(Program, StartsInMilliseconds) {
  double best = 1e9;
  for (int i = 0; i < 20; ++i) {
    const double before = childrensCpuSeconds();
    ASSERT_EQ(goniolux({"--version"}).exitCode, 0);
    best = std::min(best, childrensCpuSeconds() - before);
  }
  EXPECT_LT(best, 0.030);
}

}  // namespace
}  // namespace goniolux::test
