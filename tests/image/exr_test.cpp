#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <utility>

#include "core/diagnostics.h"
#include "image/exr.h"
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

TEST(Exr, SixteenBitFormsRoundByLessThanAThousandth) {
  const test::TemporaryFolder folder;
  XyzImage image = testImage(37, 21);  // up to 1e6 cd/m2: beyond 16-bit floats
  image.chromaticityX = image.chromaticityY = std::vector<float>(image.y.size(), 0.001F);
  const auto size = [&](const char* name, ExrForm form) {
    const std::string path = (folder.path() / name).string();
    writeExr(path, image, form);
    const XyzImage back = readExr(path);
    for (std::size_t i = 0; i < image.y.size(); ++i) {
      // Half of 2^-10, and half of the smallest step where scaled values leave the normal range (2^-25 * scale).
      const float tiny = 16 * 3.0e-8F;
      EXPECT_NEAR(back.x[i], image.x[i], image.x[i] * 4.9e-4F + tiny);
      EXPECT_NEAR(back.y[i], image.y[i], image.y[i] * 4.9e-4F + tiny);
      EXPECT_NEAR(back.z[i], image.z[i], image.z[i] * 4.9e-4F + tiny);
    }
    EXPECT_EQ(back.halfWidth.empty(), form == ExrForm::paper) << "the paper's form has three channels";
    return std::filesystem::file_size(path);
  };
  const auto full = size("float.exr", ExrForm::float32);
  EXPECT_LT(size("half.exr", ExrForm::half), full);
  EXPECT_GT(size("paper.exr", ExrForm::paper), 0U);
}

TEST(Exr, SpectralChannelsComeBackUnderThePublishedNames) {
  EXPECT_EQ(spectralChannelName(550), "S0.550,000000nm");
  const test::TemporaryFolder folder;
  const std::string path = (folder.path() / "view.exr").string();
  XyzImage image = testImage(5, 4);
  image.spectrum = {{437.5, std::vector<float>(20, 0.25F), {}}, {550, std::vector<float>(20, 0.5F), {}}};
  writeExr(path, image);
  EXPECT_NE(test::contentOf(path).find("S0.437,500000nm"), std::string::npos);
  const XyzImage back = readExr(path);
  ASSERT_EQ(back.spectrum.size(), 2U);
  EXPECT_EQ(back.spectrum[0].wavelength_nm, 437.5);
  EXPECT_EQ(back.spectrum[1].values, image.spectrum[1].values);
  EXPECT_EQ(back.attributes.at("emissiveUnits"), "W.m^-2.sr^-1.nm^-1");
}

// R, G, B as other programs write them: Rec. 709 unless the file says otherwise, relative unless it has a white.
TEST(Exr, RgbOfOtherProgramsBecomesXyz) {
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "view.exr";
  XyzImage image = testImage(4, 4);
  image.halfWidth.clear();
  for (auto* plane : {&image.x, &image.y, &image.z}) std::fill(plane->begin(), plane->end(), 1.0F);
  writeExr(path.string(), image);
  std::string bytes = test::contentOf(path);
  const std::size_t channels = bytes.find("chlist");
  // The channel list is X, Y, Z in this order: the same bytes are B, G, R.
  for (const auto& [from, to] : {std::pair("X", 'B'), std::pair("Y", 'G'), std::pair("Z", 'R')})
    bytes[bytes.find(std::string(from) + '\0', channels)] = to;
  std::string plain = bytes;
  for (const char* name : {"chromaticities", "whiteLuminance", "photometricUnits"})
    plain[plain.find(name)] = 'q';  // unknown attributes are passed over
  const XyzImage white = readExr(folder.write("rgb.exr", plain).string());
  EXPECT_EQ(white.attributes.at(unitsAttribute), "relative");
  EXPECT_NEAR(white.x[0], 0.3127F / 0.3290F, 1e-5F);
  EXPECT_NEAR(white.y[0], 1, 1e-6F);
  // With the chromaticities of X, Y, Z themselves the numbers stay.
  const XyzImage same = readExr(folder.write("same.exr", bytes).string());
  EXPECT_NEAR(same.x[0], 1, 1e-6F);
  EXPECT_EQ(same.attributes.at(unitsAttribute), "cd/m2");
}

}  // namespace
}  // namespace goniolux::image
