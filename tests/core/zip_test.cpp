// ZIP archives: the check value of CRC-32, and what another program unpacks.
#include "core/zip.h"

#include <gtest/gtest.h>

#include "support/program.h"

namespace goniolux::core {
namespace {

// The check value of CRC-32/ISO-HDLC (catalogue of parametrised CRC algorithms; ISO 3309).
TEST(Zip, ChecksumsHaveTheStandardsCheckValue) {
  EXPECT_EQ(crc32("123456789"), 0xcbf43926U);
  EXPECT_EQ(crc32(""), 0U);
}

TEST(Zip, BeginsWithTheFirstEntryUncompressed) {
  const std::string archive = zipArchive({{"mimetype", "text/x"}, {"a/b", "content"}});
  // 30 bytes of local header, then the name, then the bytes: OpenDocument's part 3 puts its type at this place.
  EXPECT_EQ(archive.substr(0, 4), std::string("PK\x03\x04", 4));
  EXPECT_EQ(archive.substr(30, 14), "mimetypetext/x");
}

TEST(Zip, IsUnpackedByAnotherProgram) {
  const test::TemporaryFolder folder;
  std::string binary;
  for (int i = 0; i < 1000; ++i) binary += static_cast<char>(i * 7);
  folder.write("a.zip", zipArchive({{"empty", ""}, {"folder/binary", binary}}));
  const std::string file = (folder.path() / "a.zip").string(), into = (folder.path() / "out").string();
  if (test::Running({"/bin/sh", "-c", "command -v python3"}).wait().exitCode != 0) GTEST_SKIP() << "python3 is missing";
  ASSERT_EQ(test::Running({"python3", "-m", "zipfile", "-e", file, into}).wait().exitCode, 0);
  EXPECT_EQ(test::contentOf(folder.path() / "out/folder/binary"), binary);
  EXPECT_EQ(test::contentOf(folder.path() / "out/empty"), "");
}

}  // namespace
}  // namespace goniolux::core
