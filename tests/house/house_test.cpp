// The tree is the architecture: these tests read the sources and hold them to docs/developer/house.json.
#include <gtest/gtest.h>

#include <filesystem>

#include "house/rules.h"
#include "support/generated_block.h"
#include "support/temporary_folder.h"

namespace goniolux::test {
namespace {

namespace fs = std::filesystem;

const fs::path root = GONIOLUX_SOURCE_DIR;

House theHouse() {
  return readHouse((root / "docs/developer/house.json").string());
}

std::string listed(const Findings& findings) {
  std::string out;
  for (const std::string& finding : findings) out += finding + '\n';
  return out;
}

TEST(House, EveryRoomIncludesLowerFloorsOnly) {
  const auto sources = readSources(root / "src");
  ASSERT_GT(sources.size(), 20u) << "the sources were not found";
  EXPECT_EQ(listed(brokenFloors(theHouse(), sources)), "");
}

TEST(House, LibrariesPrintingAndExitingStayBehindTheirFences) {
  EXPECT_EQ(listed(brokenFences(theHouse(), readSources(root / "src"))), "");
}

TEST(House, NoFileIsTooLong) {
  EXPECT_EQ(listed(longFiles(theHouse(), readSources(root / "src"))), "");
  EXPECT_EQ(listed(longFiles(theHouse(), readSources(root / "tests"))), "");
}

TEST(House, EveryHeaderHasPragmaOnceAndSaysSomethingItself) {
  EXPECT_EQ(listed(poorHeaders(readSources(root / "src"))), "");
  EXPECT_EQ(listed(poorHeaders(readSources(root / "tests"))), "");
}

TEST(House, NoFolderIsNamedAfterNothing) {
  EXPECT_EQ(listed(poorFolders(theHouse(), readSources(root / "src"))), "");
  EXPECT_EQ(listed(poorFolders(theHouse(), readSources(root / "tests"))), "");
}

TEST(House, NoFileNamesAPathOfOneMachine) {
  EXPECT_EQ(listed(machinePaths(root, {"src", "tests", "docs", "script", "cmake", ".ci"})), "");
}

TEST(House, EveryRoomOfTheTableIsThere) {
  for (const auto& floor : theHouse().floors)
    for (const Room& room : floor) EXPECT_TRUE(fs::is_directory(root / "src" / room.name)) << room.name;
}

// The negative control: a small house in which every rule is broken once.
class BrokenHouse : public testing::Test {
 protected:
  void SetUp() override {
    tree_.write("core/vector.h", "#pragma once\nstruct V {};\n");
    tree_.write("spectrum/curve.h", "#pragma once\nstruct C {};\n");
    tree_.write("photometry/web.h", "#pragma once\nstruct W {};\n");
  }
  [[nodiscard]] std::vector<SourceFile> sources() const { return readSources(tree_.path()); }
  TemporaryFolder tree_;
  House house_ = theHouse();
};

TEST_F(BrokenHouse, AnIncludeFromAHigherFloorIsFoundWithItsLine) {
  tree_.write("core/bad.cpp", "// one\n#include \"spectrum/curve.h\"\n");
  EXPECT_EQ(listed(brokenFloors(house_, sources())),
            "src/core/bad.cpp:2: 'core' (floor 0) must not include 'spectrum/curve.h' (floor 1); only lower floors\n");
}

TEST_F(BrokenHouse, AnIncludeFromTheSameFloorIsFound) {
  tree_.write("geometry/bad.h", "#pragma once\n#include \"photometry/web.h\"\n");
  EXPECT_EQ(brokenFloors(house_, sources()).size(), 1u);
}

TEST_F(BrokenHouse, AnIncludeThatIsNotWrittenFromSrcAndARoomOutsideTheTableAreFound) {
  tree_.write("core/bad.cpp", "#include \"vector.h\"\n");
  tree_.write("cellar/bad.cpp", "int x;\n");
  EXPECT_EQ(brokenFloors(house_, sources()).size(), 2u);
}

TEST_F(BrokenHouse, LibrariesOutsideTheirRoomsAreFound) {
  tree_.write("core/bad.cpp",
              "#include <embree3/rtcore.h>\n#include <vtkActor.h>\n#include <QWidget>\n#include <thread>\n");
  tree_.write("core/good.cpp", "#include <threads_of_gold.h>\n#include <Quantity.h>\n// #include <thread>\n");
  EXPECT_EQ(brokenFences(house_, sources()).size(), 4u) << listed(brokenFences(house_, sources()));
}

TEST_F(BrokenHouse, TheXmlParserInTwoFilesOfARoomIsFound) {
  tree_.write("spectrum/one.cpp", "#include <pugixml.hpp>\n");
  tree_.write("photometry/one.cpp", "#include <pugixml.hpp>\n");
  EXPECT_EQ(listed(brokenFences(house_, sources())), "");
  tree_.write("spectrum/two.cpp", "#include <pugixml.hpp>\n");
  EXPECT_EQ(brokenFences(house_, sources()).size(), 1u);
}

TEST_F(BrokenHouse, PrintingAndExitingAreFoundButNotInCommentsAndStrings) {
  tree_.write("core/bad.cpp", "void f() {\n  std::cout << 1;\n  std::exit(2);\n}\n");
  tree_.write("core/good.cpp",
              "// std::cout\nconst char* s = \"printf( exit(\"; /* exit(1) */ auto r = R\"x(abort() \" )x\"; int "
              "exited, n = 1'000;\n");
  EXPECT_EQ(listed(brokenFences(house_, sources())),
            "src/core/bad.cpp:2: standard output and error ('std::cout') belongs in app/, plot/vtk/main.cpp only; "
            "return a report or "
            "throw\nsrc/core/bad.cpp:3: process exit ('exit') belongs in app/, plot/vtk/main.cpp only; return a report "
            "or throw\n");
}

TEST_F(BrokenHouse, LongFilesPoorHeadersAndPoorFoldersAreFound) {
  tree_.write("core/long.cpp", std::string(static_cast<std::size_t>(house_.longestFile) + 1, '\n'));
  tree_.write("core/twice.h", "struct T {};\n");
  tree_.write("core/umbrella.h", "// all\n#pragma once\n#include \"core/vector.h\"\n");
  tree_.write("core/utils/text.h", "#pragma once\nstruct X {};\n");
  EXPECT_EQ(longFiles(house_, sources()).size(), 1u);
  EXPECT_EQ(poorHeaders(sources()).size(), 2u);
  EXPECT_EQ(poorFolders(house_, sources()).size(), 1u);
}

TEST_F(BrokenHouse, APathOfOneMachineIsFoundWithItsLine) {
  tree_.write("docs/page.md", std::string("one\nsee /") + "home/me/notes\n");
  EXPECT_EQ(machinePaths(tree_.path(), {"docs"}).at(0).substr(0, 15), "docs/page.md:2:");
}

TEST(HousePicture, InTheArchitecturePageIsDrawnFromTheTable) {
  expectGeneratedBlock(root / "docs/developer/architecture.md", "the house", drawHouse(theHouse()));
}

}  // namespace
}  // namespace goniolux::test
