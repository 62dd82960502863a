#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <filesystem>
#include <string>

#include "core/closest_name.h"
#include "core/document.h"
#include "core/sha256.h"

namespace goniolux::core {
namespace {

namespace fs = std::filesystem;

class DocumentFiles : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() /
              (std::string("goniolux-") + testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  fs::path folder_;
};

TEST_F(DocumentFiles, WrittenBytesAreReadBack) {
  const std::string bytes("a\0b\r\n\xFF", 6);
  writeFile(folder_ / "x.bin", bytes);
  EXPECT_EQ(readFile(folder_ / "x.bin"), bytes);
  writeFile(folder_ / "x.bin", "new");
  EXPECT_EQ(readFile(folder_ / "x.bin"), "new");
}

TEST_F(DocumentFiles, NothingIsLeftBesideTheTarget) {
  writeFile(folder_ / "x.json", "1");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 1);
}

TEST_F(DocumentFiles, MissingFileIsAnInputErrorThatNamesIt) {
  try {
    readFile(folder_ / "absent.json");
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("absent.json"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("No such file"), std::string::npos) << error.what();
  }
}

TEST_F(DocumentFiles, FolderIsNotReadAsAFile) {
  EXPECT_THROW(readFile(folder_), InputError);
}

TEST_F(DocumentFiles, FailedWriteLeavesTheEarlierFileAndSaysWhy) {
  try {
    writeFile(folder_ / "no-such-folder" / "x.json", "1");
    FAIL() << "no error";
  } catch (const RunError& error) {
    EXPECT_NE(std::string(error.what()).find("does the folder exist?"), std::string::npos) << error.what();
  }
  fs::create_directories(folder_ / "target" / "child");  // a folder cannot be replaced by a file
  EXPECT_THROW(writeFile(folder_ / "target", "1"), RunError);
  EXPECT_TRUE(fs::is_directory(folder_ / "target" / "child"));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 1);
}

// A limit on the size of files stands in for a full disk: the write fails in its middle.
TEST_F(DocumentFiles, WriteThatFailsInTheMiddleKeepsTheEarlierFile) {
  writeFile(folder_ / "x.json", "earlier");
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  rlimit small = before;
  small.rlim_cur = 1000;
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
  std::string message;
  try {
    writeFile(folder_ / "x.json", std::string(5000, 'x'));
  } catch (const RunError& error) {
    message = error.what();
  }
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_NE(message.find("x.json: cannot be written: File too large"), std::string::npos) << message;
  EXPECT_EQ(readFile(folder_ / "x.json"), "earlier");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 1);
}

TEST(ClosestName, FindsTheNameThatWasMeant) {
  const std::vector<std::string> known{"material", "materials", "transform", "shape", "min", "max"};
  EXPECT_EQ(closestName("materail", known), "material");
  EXPECT_EQ(closestName("Materials", known), "materials");
  EXPECT_EQ(closestName("tranform", known), "transform");
  EXPECT_EQ(closestName("mix", known), "min");
  EXPECT_EQ(closestName("photometry", known), "");
  EXPECT_EQ(closestName("", known), "");
  EXPECT_EQ(closestName("x", {}), "");
}

TEST(ClosestName, SuggestionListsTheKnownWhenNoneIsNear) {
  EXPECT_EQ(suggestion("shpae", {"shape", "min"}), "; did you mean 'shape'?");
  EXPECT_EQ(suggestion("photometry", {"shape", "min"}), "; known: shape, min");
  EXPECT_EQ(suggestion("x", {}), "");
}

// FIPS 180-4 examples.
TEST(Sha256, AgreesWithThePublishedExamples) {
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

}  // namespace
}  // namespace goniolux::core
