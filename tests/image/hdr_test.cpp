#include "image/hdr.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/diagnostics.h"
#include "image/image_file.h"

namespace goniolux::image {
namespace {

// Noise with stretches of one value, as renderings have; colours inside Radiance's primaries.
XyzImage testImage(int width, int height) {
  XyzImage image;
  image.width = width;
  image.height = height;
  std::mt19937 random(7);
  const auto count = static_cast<std::size_t>(width * height);
  for (std::size_t i = 0; i < count; ++i) {
    const bool flat = i / 20 % 2 == 0;
    const float luminance = flat ? 12.5F : std::exp2(static_cast<float>(random() % 1000) / 50 - 8);
    image.y.push_back(luminance);
    image.x.push_back(luminance * (flat ? 1.0F : 0.95F));
    image.z.push_back(luminance * (flat ? 0.4F : 1.08F));
  }
  return image;
}

// One part in 256 of the pixel's largest mantissa, which is at least 128: half a step is 1/256.
void expectClose(const XyzImage& back, const XyzImage& image, float tolerance) {
  ASSERT_EQ(back.width, image.width);
  ASSERT_EQ(back.height, image.height);
  for (std::size_t i = 0; i < image.y.size(); ++i) {
    const float largest = std::max({image.x[i], image.y[i], image.z[i]});
    ASSERT_NEAR(back.x[i], image.x[i], tolerance * largest) << i;
    ASSERT_NEAR(back.y[i], image.y[i], tolerance * largest) << i;
    ASSERT_NEAR(back.z[i], image.z[i], tolerance * largest) << i;
  }
}

TEST(Hdr, XyzeComesBackWithinHalfAStep) {
  for (const int width : {1, 7, 8, 37, 300}) {
    const XyzImage image = testImage(width, 9);
    expectClose(decodeImage(encodeHdr(image, HdrForm::xyze), "a.hdr"), image, 1.0F / 256 + 1e-6F);
  }
}

TEST(Hdr, RgbeComesBackThroughItsPrimaries) {
  // A step of the largest primary, turned back into X, Y, Z, is at most some steps of the largest of these.
  const XyzImage image = testImage(64, 9);
  expectClose(decodeImage(encodeHdr(image, HdrForm::rgbe), "a.hdr"), image, 0.015F);
}

// Equal-energy white of radiance 1 W/(m2 sr) has 179 cd/m2 in Radiance.
TEST(Hdr, WhiteOfRadianceOneHas179Candelas) {
  std::string bytes = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 1\n";
  bytes += std::string("\x80\x80\x80\x81", 4);  // 128.5 / 256 * 2^1
  const XyzImage image = decodeHdr(bytes, "a.hdr");
  const float expected = 179 * 128.5F / 128;
  EXPECT_NEAR(image.y[0], expected, 0.01F);
  EXPECT_NEAR(image.x[0], expected, 0.01F);
  EXPECT_NEAR(image.z[0], expected, 0.01F);
}

TEST(Hdr, ExposureIsUndoneAndTheViewIsKept) {
  std::string bytes = "#?RADIANCE\nVIEW= -vta -vp 1 2 3\nEXPOSURE=2\nEXPOSURE=4\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 1\n";
  bytes += std::string("\x80\x80\x80\x88", 4);
  const XyzImage image = decodeHdr(bytes, "a.hdr");
  EXPECT_NEAR(image.y[0], 128.5F / 8, 1e-4F);
  EXPECT_EQ(image.attributes.at(viewAttribute), "-vta -vp 1 2 3");
  const std::string again = encodeHdr(image, HdrForm::xyze);
  EXPECT_NE(again.find("\nVIEW= -vta -vp 1 2 3\n"), std::string::npos) << "evaluation tools look for this line";
}

TEST(Hdr, OldRunsAreRead) {
  std::string bytes = "#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 300\n";
  bytes += std::string("\x80\x40\x20\x88", 4) + std::string("\x01\x01\x01\x2b", 4) + std::string("\x01\x01\x01\x01", 4);
  const XyzImage image = decodeHdr(bytes, "a.hdr");  // 1 + 43 + 256 pixels
  ASSERT_EQ(image.y.size(), 300U);
  EXPECT_EQ(image.y.front(), image.y.back());
  EXPECT_NEAR(image.y[299], 64.5F, 1e-4F);
}

TEST(Hdr, AttributesTravelAsComments) {
  XyzImage image = testImage(8, 2);
  image.attributes = {{adoptedWhiteAttribute, "0.4476 0.4074"}, {"projectHash", "abc"}};
  const XyzImage back = decodeHdr(encodeHdr(image, HdrForm::xyze), "a.hdr");
  EXPECT_EQ(back.attributes.at(adoptedWhiteAttribute), "0.4476 0.4074");
  EXPECT_EQ(back.attributes.at("projectHash"), "abc");
}

TEST(Hdr, EveryTruncationIsRefused) {
  const std::string whole = encodeHdr(testImage(64, 9), HdrForm::xyze);
  for (std::size_t size = 0; size < whole.size(); size += 7)
    EXPECT_THROW(decodeImage(whole.substr(0, size), "cut.hdr"), core::InputError) << size;
}

TEST(Hdr, FaultsAreNamed) {
  const auto complaint = [](const std::string& bytes) -> std::string {
    try {
      decodeImage(bytes, "a.hdr");
    } catch (const core::InputError& error) {
      return error.what();
    }
    return "";
  };
  const auto says = [&](const std::string& bytes, const char* part) {
    const std::string message = complaint(bytes);
    EXPECT_NE(message.find(part), std::string::npos) << "'" << part << "' is not in: " << message;
  };
  says("#?RADIANCE\n\n-Y 1 +X 1\nabcd", "no line FORMAT=");
  says("#?RADIANCE\nFORMAT=64-bit\n\n-Y 1 +X 1\nabcd", "is not known");
  says("#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n+Y 1 +X 1\nabcd", "pflip");
  says("#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 60000 +X 60000\nabcd", "promises");
  says("#?RADIANCE\nFORMAT=32-bit_rle_xyze\nEXPOSURE=0\n\n-Y 1 +X 1\nabcd", "above 0");
  says("GIF89a", "neither");
}

}  // namespace
}  // namespace goniolux::image
