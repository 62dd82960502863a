// Files seen by programs that this project did not write: ImageMagick, OpenImageIO, Little CMS's own tools.
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "display/display_image.h"
#include "display/icc_profile.h"
#include "display/picture_file.h"
#include "support/program.h"
#include "support/temporary_folder.h"

namespace goniolux::display {
namespace {

bool has(const char* program) {
  return std::system((std::string("command -v ") + program + " >/dev/null 2>&1").c_str()) == 0;
}

CodeImage ramp(int bits) {
  CodeImage image;
  image.width = 64;
  image.height = 8;
  image.bits = bits;
  const int largest = (1 << bits) - 1;
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 64; ++x)
      for (const int code : {x * largest / 63, y * largest / 7, largest - x * largest / 63})
        image.rgb.push_back(static_cast<std::uint16_t>(code));
  return image;
}

struct Case {
  const char* file;
  int bits;
  const char* device;
};

std::string nameOf(const ::testing::TestParamInfo<Case>& info) {
  std::string name = info.param.file;
  for (char& c : name)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  return name;
}

class ForeignTool : public ::testing::TestWithParam<Case> {
 protected:
  test::TemporaryFolder folder_;
  std::string written() {
    const std::string path = (folder_.path() / GetParam().file).string();
    writePicture(path, ramp(GetParam().bits), readDevice(GetParam().device));
    return path;
  }
};

// Every code value of the lossless formats, as ImageMagick sees it.
TEST_P(ForeignTool, ImageMagickReadsEveryCode) {
  if (!has("identify") || !has("convert")) GTEST_SKIP() << "ImageMagick (imagemagick) is not installed";
  const std::string path = written();
  const auto outcome = test::Running({"identify", "-format", "%w %h", path}).wait();
  EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "64 8");
  if (GetParam().bits == 8 && std::string(GetParam().file).ends_with("jpg")) return;
  const std::string raw = (folder_.path() / "raw.rgb").string();
  // "stream" maps no colours: samples as they are stored, widened to 16 bits.
  if (!has("stream")) GTEST_SKIP() << "ImageMagick's stream is not installed";
  ASSERT_EQ(test::Running({"stream", "-map", "rgb", "-storage-type", "short", path, raw}).wait().exitCode, 0);
  const std::string samples = test::contentOf(raw);
  const CodeImage image = ramp(GetParam().bits);
  ASSERT_EQ(samples.size(), 2 * image.rgb.size());
  const double widened = 65535.0 / ((1 << GetParam().bits) - 1);
  for (std::size_t i = 0; i < image.rgb.size(); ++i) {
    const int sample = static_cast<unsigned char>(samples[2 * i]) | static_cast<unsigned char>(samples[2 * i + 1]) << 8;
    ASSERT_NEAR(sample / widened, image.rgb[i], 0.51) << i;
  }
}

TEST_P(ForeignTool, OpenImageIoReadsTheHeader) {
  if (!has("iinfo")) GTEST_SKIP() << "iinfo (openimageio-tools) is not installed";
  const auto outcome = test::Running({"iinfo", "-v", written()}).wait();
  EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("64 x    8"), std::string::npos) << outcome.out;
  if (std::string(GetParam().device) == "film-negative-print") {
    for (const char* expected : {"dpx:Transfer: \"Printing density\"", "dpx:HighQuantity: 2.046", "dpx:LowData: 0",
                                 "printing density, 0.002 D/code", "uint10"})
      EXPECT_NE(outcome.out.find(expected), std::string::npos) << expected << " is not in\n" << outcome.out;
  }
}

INSTANTIATE_TEST_SUITE_P(Every, ForeignTool,
                         ::testing::Values(Case{"eight.png", 8, "srgb"}, Case{"sixteen.png", 16, "display-p3"},
                                           Case{"sixteen.tif", 16, "adobe-rgb"}, Case{"eight.jpg", 8, "srgb"},
                                           Case{"film.dpx", 10, "film-negative-print"},
                                           Case{"video.dpx", 10, "rec709"}),
                         nameOf);

// EXR pictures are linear light: OpenEXR's own tool finds the primaries and the white.
TEST(ForeignTools, ExrheaderReadsPrimariesAndWhite) {
  if (!has("exrheader")) GTEST_SKIP() << "exrheader (openexr) is not installed";
  const test::TemporaryFolder folder;
  const std::string path = (folder.path() / "picture.exr").string();
  writePicture(path, ramp(16), readDevice("srgb"));
  const auto outcome = test::Running({"exrheader", path}).wait();
  EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
  for (const char* expected : {"R, 32-bit floating-point", "red   (0.64 0.33)", "whiteLuminance"})
    EXPECT_NE(outcome.out.find(expected), std::string::npos) << expected << " is not in\n" << outcome.out;
}

// tificc, of Little CMS, turns a TIFF of ours into sRGB through the profile that it carries.
TEST(ForeignTools, TificcUsesTheProfileOfATiff) {
  if (!has("tificc")) GTEST_SKIP() << "tificc (liblcms2-utils) is not installed";
  const test::TemporaryFolder folder;
  const std::string in = (folder.path() / "in.tif").string(), out = (folder.path() / "out.tif").string();
  const Device p3 = readDevice("display-p3"), srgb = readDevice("srgb");
  CodeImage grey = ramp(16);  // greys and colours near them: inside both gamuts
  for (std::size_t i = 0; i < grey.rgb.size(); ++i)
    grey.rgb[i] = static_cast<std::uint16_t>(30000 + grey.rgb[i] / 16 + (i / 3 % 64) * 300);
  writePicture(in, grey, p3);
  const auto outcome = test::Running({"tificc", "-t1", "-w16", in, out}).wait();
  ASSERT_EQ(outcome.exitCode, 0) << outcome.out << outcome.err;
  const CodeImage back = readPicture(out);
  // The same by our own matrices.
  for (std::size_t i = 0; i < grey.rgb.size() / 3; i += 7) {
    core::Vec3 linear;
    for (int c = 0; c < 3; ++c)
      linear[c] = p3.transfer[0].decode(grey.rgb[3 * i + static_cast<std::size_t>(c)] / 65535.0);
    const core::Vec3 there = rgbFromXyz(srgb, std::nullopt) * xyzFromRgb(p3) * linear;
    const double scale = back.bits == 16 ? 65535 : 255;
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(back.rgb[3 * i + static_cast<std::size_t>(c)] / scale, srgb.transfer[0].encode(there[c]), 0.004) << i;
  }
}

}  // namespace
}  // namespace goniolux::display
