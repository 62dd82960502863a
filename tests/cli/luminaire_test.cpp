// `goniolux luminaire` from the outside: a list, one entry per file, and the others are done when one cannot be read.
#include <gtest/gtest.h>

#include <algorithm>

#include "cli/projects.h"
#include "support/program.h"

namespace goniolux::test {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> luminairesOfTheRepository() {
  std::vector<std::string> files;
  for (const auto& entry : fs::directory_iterator(fs::path(GONIOLUX_SOURCE_DIR) / "luminaires")) {
    const fs::path extension = entry.path().extension();
    if (extension == ".ies" || extension == ".ldt") files.push_back(entry.path().string());
  }
  std::sort(files.begin(), files.end());
  return files;
}

TEST(Luminaire, JsonIsAListWithOneEntryForEachFileInTheirOrder) {
  std::vector<std::string> arguments = {"luminaire", "--json"};
  const std::vector<std::string> files = luminairesOfTheRepository();
  ASSERT_GT(files.size(), 5u);
  arguments.insert(arguments.end(), files.begin(), files.end());
  const Outcome outcome = goniolux(arguments);
  ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
  const core::Value list = oneDocument(outcome.out);
  ASSERT_EQ(list.array().size(), files.size());
  for (std::size_t i = 0; i < files.size(); ++i) {
    const core::Value& entry = list.array()[i];
    EXPECT_EQ(entry.find("file")->string(), files[i]);
    EXPECT_EQ(entry.find("error"), nullptr) << files[i];
    ASSERT_NE(entry.find("integrated_lumens"), nullptr) << files[i];
    EXPECT_GT(entry.find("integrated_lumens")->number(), 0) << files[i];
  }
}

TEST(Luminaire, AFileThatCannotBeReadHasItsLineAndTheOthersAreDone) {
  const TemporaryFolder folder;
  const std::string good = luminairesOfTheRepository().front();
  const std::string bad =
      folder.write("bad.ies", "IESNA:LM-63-2002\n[TEST] none\nTILT=NONE\n1 1000 1 3 1 1 2 0 0 oops\n");
  const Outcome outcome = goniolux({"luminaire", bad, good, "--json"});
  EXPECT_EQ(outcome.exitCode, 2);
  const core::Value list = oneDocument(outcome.out);
  ASSERT_EQ(list.array().size(), 2u) << outcome.out;
  const core::Value* error = list.array()[0].find("error");
  ASSERT_NE(error, nullptr) << outcome.out;
  EXPECT_EQ(error->find("line")->number(), 4) << outcome.out;
  EXPECT_NE(list.array()[1].find("integrated_lumens"), nullptr);
}

}  // namespace
}  // namespace goniolux::test
