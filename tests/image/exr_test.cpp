#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <string>

#include "core/diagnostics.h"
#include "image/xyz_image.h"
#include "support/temporary_folder.h"

namespace goniolux::image {
namespace {

XyzImage testImage(int width, int height) {
  XyzImage image;
  image.width = width;
  image.height = height;
  const std::size_t count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  for (std::size_t i = 0; i < count; ++i) {
    const auto value = static_cast<float>(i);
    image.x.push_back(0.1F + value);
    image.y.push_back(1e-3F * value);
    image.z.push_back(1e6F - value);
    image.halfWidth.push_back(1e-5F * value);
  }
  image.attributes = {{"seed", "42"}, {"projectHash", "abc"}};
  return image;
}

std::string complaint(const std::filesystem::path& file) {
  try {
    readExr(file.string());
  } catch (const core::InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Exr, FloatsComeBackToTheBit) {
  const test::TemporaryFolder folder;
  const std::string path = (folder.path() / "view.exr").string();
  const XyzImage image = testImage(37, 21);
  writeExr(path, image);
  const XyzImage back = readExr(path);
  EXPECT_EQ(back.width, 37);
  EXPECT_EQ(back.height, 21);
  EXPECT_EQ(back.x, image.x);
  EXPECT_EQ(back.y, image.y);
  EXPECT_EQ(back.z, image.z);
  EXPECT_EQ(back.halfWidth, image.halfWidth);
}

TEST(Exr, AttributesAndCalibrationComeBack) {
  const test::TemporaryFolder folder;
  const std::string path = (folder.path() / "view.exr").string();
  XyzImage image = testImage(4, 4);
  image.halfWidth.clear();
  writeExr(path, image);
  const XyzImage back = readExr(path);
  EXPECT_TRUE(back.halfWidth.empty());
  EXPECT_EQ(back.attributes.at("seed"), "42");
  EXPECT_EQ(back.attributes.at("projectHash"), "abc");
  EXPECT_EQ(back.attributes.at("photometricUnits"), "cd/m2");
  EXPECT_EQ(back.attributes.at("observer"), "CIE 1931 2 degree");
  EXPECT_EQ(back.attributes.at("spectralRange_nm"), "360 830");
}

TEST(Exr, EveryTruncationIsRefusedWithAMessage) {
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "view.exr";
  writeExr(path.string(), testImage(64, 48));
  const std::string whole = test::contentOf(path);
  for (std::size_t size = 0; size < whole.size(); size += 1 + whole.size() / 97) {
    const auto cut = folder.write("cut.exr", whole.substr(0, size));
    EXPECT_NE(complaint(cut), "") << size << " of " << whole.size() << " bytes";
  }
}

TEST(Exr, FlippedBytesAreReadOrRefusedButNeverCrash) {
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "view.exr";
  writeExr(path.string(), testImage(16, 12));
  const std::string whole = test::contentOf(path);
  int refused = 0;
  for (std::size_t i = 0; i < whole.size(); i += 3) {
    std::string bytes = whole;
    bytes[i] = static_cast<char>(bytes[i] ^ 0xA5);
    if (!complaint(folder.write("flipped.exr", bytes)).empty()) ++refused;
  }
  EXPECT_GT(refused, 10);
}

TEST(Exr, HeaderThatPromisesFarMoreThanTheFileHoldsIsRefused) {
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "view.exr";
  writeExr(path.string(), testImage(16, 12));
  std::string bytes = test::contentOf(path);
  const std::size_t window = bytes.find("dataWindow");
  ASSERT_NE(window, std::string::npos);
  const std::size_t maxX = window + sizeof("dataWindow") + sizeof("box2i") + 4 + 8;  // name, type, size, min.x, min.y
  ASSERT_EQ(bytes[maxX], 15);
  for (const char high : {char{0}, char{0x7f}}) {  // 65296 x 65292 pixels; two thousand million
    bytes[maxX + 1] = bytes[maxX + 5] = static_cast<char>(0xff);
    bytes[maxX + 3] = bytes[maxX + 7] = high;
    EXPECT_NE(complaint(folder.write("huge.exr", bytes)), "");
  }
}

TEST(Exr, MissingChannelIsNamed) {
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "view.exr";
  writeExr(path.string(), testImage(16, 12));
  std::string bytes = test::contentOf(path);
  const std::size_t channels = bytes.find("chlist");
  const std::size_t z = bytes.find(std::string("Z\0", 2), channels);
  ASSERT_NE(z, std::string::npos);
  bytes[z] = 'a';
  const std::string message = complaint(folder.write("noZ.exr", bytes));
  EXPECT_NE(message.find("channel Z is missing"), std::string::npos) << message;
}

TEST(Exr, OtherFilesAreRefused) {
  const test::TemporaryFolder folder;
  EXPECT_NE(complaint(folder.write("a.exr", "hello")).find("not an OpenEXR image"), std::string::npos);
  EXPECT_NE(complaint(folder.write("b.exr", "")), "");
  EXPECT_NE(complaint(folder.path() / "absent.exr").find("absent.exr"), std::string::npos);
}

TEST(Exr, WritingIntoNoFolderIsARunError) {
  const test::TemporaryFolder folder;
  EXPECT_THROW(writeExr((folder.path() / "no-folder/view.exr").string(), testImage(4, 4)), core::RunError);
}

TEST(Exr, ForeignToolReadsTheHeader) {
  if (std::system("command -v exrheader >/dev/null 2>&1") != 0) GTEST_SKIP() << "exrheader is not installed";
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "view.exr";
  writeExr(path.string(), testImage(37, 21));
  const auto listing = folder.path() / "header.txt";
  ASSERT_EQ(std::system(("exrheader '" + path.string() + "' > '" + listing.string() + "' 2>&1").c_str()), 0);
  const std::string header = test::contentOf(listing);
  for (const char* expected : {"X, 32-bit floating-point", "Y, 32-bit floating-point", "Z, 32-bit floating-point",
                               "Y.halfWidth", "photometricUnits", "cd/m2", "projectHash", "(36 20)"}) {
    EXPECT_NE(header.find(expected), std::string::npos) << expected << " is not in\n" << header;
  }
}

}  // namespace
}  // namespace goniolux::image
