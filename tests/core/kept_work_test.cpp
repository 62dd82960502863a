// Finished work on disk: what is found again, what damage costs, and who is refused.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <random>

#include "core/diagnostics.h"
#include "core/document.h"
#include "core/parallel.h"
#include "core/work_items.h"
#include "support/temporary_folder.h"

namespace goniolux::test {
namespace {

namespace fs = std::filesystem;
using core::KeptWork;

constexpr std::size_t itemCount = 64;

class KeptWorkFile : public testing::Test {
 protected:
  [[nodiscard]] std::string folder() const { return (folder_.path() / "checkpoint").string(); }
  [[nodiscard]] fs::path file() const { return fs::path(folder()) / "finished.work"; }

  /// Does the items of a part; the results and how many were done now.
  static std::vector<double> results(KeptWork* work, std::size_t& doneNow, core::ProgressSink& progress,
                                     std::size_t cancelAfter = itemCount + 1) {
    std::vector<double> values(itemCount);
    std::atomic<std::size_t> done{0};
    core::WorkItems items;
    items.count = itemCount;
    items.work = [&](std::size_t item) {
      values[item] = 1 / (1.0 + static_cast<double>(item));
      if (++done >= cancelAfter) progress.cancel();
    };
    items.pack = [&](std::size_t item, std::string& bytes) { core::put(bytes, values[item]); };
    items.unpack = [&](std::size_t item, std::string_view bytes) { return core::take(bytes, values[item]); };
    core::doItems(items, core::Keeping{work, "run"}.part("numbers"), progress);
    doneNow = done;
    return values;
  }

  /// A checkpoint of a run that was cancelled after about `items` of its items.
  void interruptedAfter(std::size_t items) {
    core::setThreadCount(1);
    core::SilentProgress progress;
    KeptWork work(folder(), "who I am", 0);
    std::size_t done = 0;
    results(&work, done, progress, items);
    work.commit();
    core::setThreadCount(0);
  }

  TemporaryFolder folder_;
};

TEST_F(KeptWorkFile, AnInterruptedRunGoesOnWithWhatItHad) {
  interruptedAfter(20);
  KeptWork work(folder(), "who I am", 0);
  ASSERT_EQ(work.findEarlier(), "who I am");
  EXPECT_EQ(work.tornBytes(), 0u);
  core::SilentProgress progress;
  std::size_t doneNow = 0, all = 0;
  const auto resumed = results(&work, doneNow, progress);
  EXPECT_EQ(doneNow, itemCount - 20);
  EXPECT_EQ(resumed, results(nullptr, all, progress));
  EXPECT_EQ(all, itemCount);
  work.remove();
  EXPECT_FALSE(fs::exists(folder())) << "a finished run leaves no checkpoint";
}

TEST_F(KeptWorkFile, ARunThatIsOverBeforeTheIntervalWritesNothing) {
  KeptWork work(folder(), "who I am");
  core::SilentProgress progress;
  std::size_t done = 0;
  results(&work, done, progress);
  EXPECT_FALSE(fs::exists(folder()));
}

TEST_F(KeptWorkFile, NothingIsFoundWhereNothingIs) {
  EXPECT_EQ(KeptWork(folder(), "who I am").findEarlier(), std::nullopt);
}

TEST_F(KeptWorkFile, IsUsedUpToWhereItIsWholeWhereverItIsCut) {
  interruptedAfter(40);
  const std::string whole = contentOf(file());
  std::mt19937 random(5);
  for (int i = 0; i < 60; ++i) {
    const std::size_t cut = std::uniform_int_distribution<std::size_t>(0, whole.size() - 1)(random);
    core::writeFile(file().string(), whole.substr(0, cut), core::Durability::whenConvenient);
    KeptWork work(folder(), "who I am", 0);
    core::SilentProgress progress;
    std::size_t doneNow = 0, all = 0;
    try {
      ASSERT_EQ(work.findEarlier(), "who I am") << cut;
      EXPECT_EQ(results(&work, doneNow, progress), results(nullptr, all, progress)) << cut;
      // What was added after the torn end must be readable again.
      KeptWork again(folder(), "who I am", 0);
      EXPECT_THROW(again.findEarlier(), core::RunError) << "the first run is still at work";
    } catch (const core::InputError& error) {
      EXPECT_LT(cut, 150u) << "only a cut first record makes it useless: " << error.what();
    }
  }
}

TEST_F(KeptWorkFile, AChangedByteAnywhereIsNeverBelieved) {
  interruptedAfter(40);
  const std::string whole = contentOf(file());
  std::mt19937 random(6);
  for (int i = 0; i < 60; ++i) {
    std::string damaged = whole;
    const std::size_t at = std::uniform_int_distribution<std::size_t>(0, whole.size() - 1)(random);
    damaged[at] = static_cast<char>(damaged[at] ^ (1 << (i % 8)));
    core::writeFile(file().string(), damaged, core::Durability::whenConvenient);
    KeptWork work(folder(), "who I am", 0);
    core::SilentProgress progress;
    std::size_t doneNow = 0, all = 0;
    try {
      ASSERT_EQ(work.findEarlier(), "who I am");
      EXPECT_GT(work.tornBytes(), 0u) << at;
      EXPECT_EQ(results(&work, doneNow, progress), results(nullptr, all, progress)) << at;
    } catch (const core::InputError& error) {
      EXPECT_NE(std::string(error.what()).find("--resume"), std::string::npos) << error.what();
    }
  }
}

TEST_F(KeptWorkFile, WhatFollowsATornEndIsFoundTheNextTime) {
  interruptedAfter(40);
  const std::string whole = contentOf(file());
  core::writeFile(file().string(), whole.substr(0, whole.size() - 3), core::Durability::whenConvenient);
  {
    KeptWork work(folder(), "who I am", 0);
    ASSERT_TRUE(work.findEarlier());
    core::SilentProgress progress;
    std::size_t done = 0;
    results(&work, done, progress);
    work.commit();
  }
  KeptWork work(folder(), "who I am", 0);
  ASSERT_TRUE(work.findEarlier());
  EXPECT_EQ(work.tornBytes(), 0u);
  core::SilentProgress progress;
  std::size_t done = 0;
  results(&work, done, progress);
  EXPECT_EQ(done, 0u) << "all was kept";
}

TEST_F(KeptWorkFile, ADecisionStaysAsItWasMadeFirst) {
  {
    KeptWork work(folder(), "who I am", 0);
    EXPECT_EQ(work.decided("paths", 17), 17u);
    work.commit();
  }
  KeptWork work(folder(), "who I am", 0);
  ASSERT_TRUE(work.findEarlier());
  EXPECT_EQ(work.decided("paths", 99), 17u);
}

// A limit on the size of files stands in for a full disk: the write fails in the middle in the same way.
TEST_F(KeptWorkFile, AFullDiskKeepsWhatWasWrittenBeforeAndSaysSo) {
  interruptedAfter(20);
  const auto before = fs::file_size(file());
  const pid_t child = fork();
  if (child == 0) {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{before + 100, before + 100};
    setrlimit(RLIMIT_FSIZE, &limit);
    KeptWork work(folder(), "who I am", 0);
    if (!work.findEarlier()) _exit(2);
    work.add("more", std::string(10000, 'x'));
    try {
      work.commit();
    } catch (const core::RunError& error) {
      _exit(std::string(error.what()).find("--resume") != std::string::npos ? 0 : 3);
    }
    _exit(4);
  }
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << status;
  EXPECT_EQ(fs::file_size(file()), before) << "the torn end was taken back";
  KeptWork work(folder(), "who I am", 0);
  ASSERT_TRUE(work.findEarlier());
  EXPECT_EQ(work.tornBytes(), 0u);
}

TEST_F(KeptWorkFile, ANewRunLeavesTheOldCheckpointUntilItHasOneOfItsOwn) {
  interruptedAfter(20);
  const std::string before = contentOf(file());
  KeptWork work(folder(), "another", 0);
  EXPECT_EQ(contentOf(file()), before);
  work.add("first", "result");
  work.commit();
  KeptWork reader(folder(), "another", 0);
  EXPECT_THROW(reader.findEarlier(), core::RunError) << "the run is at work";
}

}  // namespace
}  // namespace goniolux::test
