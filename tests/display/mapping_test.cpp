#include "display/mapping.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/diagnostics.h"
#include "display/exposure.h"

namespace goniolux::display {
namespace {

// One row of pixels with the given linear device colours, white at `white` cd/m2.
image::XyzImage imageOf(const std::vector<core::Vec3>& linear, const Device& device, double white) {
  image::XyzImage image;
  image.width = static_cast<int>(linear.size());
  image.height = 1;
  const auto matrix = xyzFromRgb(device);
  for (const auto& rgb : linear) {
    const auto xyz = matrix * rgb * white;
    image.x.push_back(static_cast<float>(xyz.x));
    image.y.push_back(static_cast<float>(xyz.y));
    image.z.push_back(static_cast<float>(xyz.z));
  }
  return image;
}

CodeImage mapped(const std::vector<core::Vec3>& linear, const Device& device, int bits = 8) {
  MappingSettings settings;
  settings.white_cd_m2 = 250;
  settings.bits = bits;
  return mapToDevice(imageOf(linear, device, 250), device, settings);
}

TEST(Mapping, EveryGreyCodeOfEveryPresetComesBack) {
  for (const auto& name : presetNames()) {
    const Device device = readDevice(name);
    for (const int bits : {8, 16}) {
      const int largest = (1 << bits) - 1, step = bits == 8 ? 1 : 97;
      std::vector<core::Vec3> linear;
      std::vector<int> codes;
      for (int code = 0; code <= largest; code += step) {
        linear.emplace_back(device.transfer.decode(static_cast<double>(code) / largest));
        codes.push_back(code);
      }
      const CodeImage image = mapped(linear, device, bits);
      // Single precision leaves a steep curve's darkest 16-bit codes one step of freedom.
      const int tolerance = bits == 8 ? 0 : 1;
      for (std::size_t i = 0; i < codes.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c)
          EXPECT_NEAR(image.rgb[3 * i + c], codes[i], tolerance) << name << " " << bits;
      }
      EXPECT_EQ(image.clipped, 0U) << name;
      EXPECT_EQ(image.outOfGamut, 0U) << name;
    }
  }
}

TEST(Mapping, ColoursInsideTheGamutComeBackWithinOneCode) {
  const Device device = readDevice("srgb");
  std::vector<core::Vec3> linear;
  std::vector<int> codes;
  for (int r = 0; r <= 255; r += 51) {
    for (int g = 0; g <= 255; g += 51) {
      for (int b = 0; b <= 255; b += 51) {
        linear.emplace_back(device.transfer.decode(r / 255.0), device.transfer.decode(g / 255.0),
                            device.transfer.decode(b / 255.0));
        codes.insert(codes.end(), {r, g, b});
      }
    }
  }
  const CodeImage image = mapped(linear, device);
  for (std::size_t i = 0; i < codes.size(); ++i) EXPECT_NEAR(image.rgb[i], codes[i], 1);
  EXPECT_EQ(image.outOfGamut, 0U) << "the cube's faces are inside";
}

TEST(Mapping, WhatTheDeviceCannotShowIsCountedAndClipped) {
  const Device device = readDevice("srgb");
  const CodeImage image =
      mapped({{0.5, 0.5, 0.5}, {2, 0.5, 0.5}, {0.5, -0.1, 0.5}, {3, -0.2, 0}, {1.0001, 1, 1}}, device);
  EXPECT_EQ(image.clipped, 2U);
  EXPECT_EQ(image.outOfGamut, 2U);
  EXPECT_EQ(image.invalid, 0U);
  EXPECT_EQ(image.rgb[3], 255);        // clipped red
  EXPECT_EQ(image.rgb[3 * 2 + 1], 0);  // clipped green
}

TEST(Mapping, SpectralGreenIsOutsideSrgb) {
  const Device device = readDevice("srgb");
  image::XyzImage image;  // 520 nm: x = 0.0743, y = 0.8338
  image.width = image.height = 1;
  image.x = {10 * 0.0743F / 0.8338F};
  image.y = {10};
  image.z = {10 * 0.0919F / 0.8338F};
  EXPECT_EQ(mapToDevice(image, device, {}).outOfGamut, 1U);
}

TEST(Mapping, NotANumberIsBlackAndCounted) {
  const Device device = readDevice("srgb");
  auto image = imageOf({{0.5, 0.5, 0.5}, {0.5, 0.5, 0.5}}, device, 250);
  image.x[1] = std::numeric_limits<float>::quiet_NaN();
  const CodeImage codes = mapToDevice(image, device, {});
  EXPECT_EQ(codes.invalid, 1U);
  EXPECT_EQ(codes.rgb[3], 0);
  EXPECT_EQ(codes.rgb[5], 0);
}

TEST(Mapping, AdoptedWhiteBecomesTheDevicesNeutral) {
  const Device device = readDevice("srgb");
  const spectrum::Chromaticity warm{0.4476, 0.4074};
  image::XyzImage image;
  image.width = image.height = 1;
  image.x = {static_cast<float>(50 * warm.x / warm.y)};
  image.y = {50};
  image.z = {static_cast<float>(50 * (1 - warm.x - warm.y) / warm.y)};
  MappingSettings settings;
  settings.adoptedWhite = warm;
  const CodeImage adapted = mapToDevice(image, device, settings);
  EXPECT_EQ(adapted.rgb[0], adapted.rgb[1]);
  EXPECT_EQ(adapted.rgb[1], adapted.rgb[2]);
  EXPECT_EQ(adapted.rgb[0], 188);  // half of white: 255 * (1.055 * 0.5^(1/2.4) - 0.055) = 187.5
  settings.adoptedWhite.reset();
  const CodeImage raw = mapToDevice(image, device, settings);
  EXPECT_GT(raw.rgb[0], raw.rgb[2] + 60) << "without adaptation incandescent light looks orange";
}

TEST(Exposure, LogAverageIsTheGeometricMeanOfTheLitPixels) {
  image::XyzImage image;
  image.x = image.z = {1, 1, 1, 1, 1};
  image.y = {1, 100, 0, std::numeric_limits<float>::infinity(), -3};
  EXPECT_NEAR(luminanceStatistics(image, core::Mat3(1)).logAverage_cd_m2, 10, 1e-5);
}

TEST(Exposure, BrightIsWhatFivePercentExceed) {
  image::XyzImage image;
  for (int i = 1; i <= 1000; ++i) image.y.push_back(1);
  for (int i = 1; i <= 1000; ++i)
    image.x.push_back(static_cast<float>(i));  // the largest primary counts, not luminance
  image.z = image.y;
  EXPECT_NEAR(luminanceStatistics(image, core::Mat3(1)).bright_cd_m2, 950,
              950 * 0.011 + 1);  // a 64th of a stop is 1.1 %
}

TEST(Exposure, AutomaticShowsTheLogAverageAsMiddleGrey) {
  const LuminanceStatistics even{10, 30};
  EXPECT_NEAR(automaticExposure(even).white_cd_m2, 10 / 0.18, 1e-9);
  EXPECT_NEAR(exposureFrom("auto+1", even).white_cd_m2, 10 / 0.18 / 2, 1e-9);
  EXPECT_NEAR(exposureFrom("auto-1", even).white_cd_m2, 10 / 0.18 * 2, 1e-9);
}

TEST(Exposure, AutomaticKeepsLightPartsOfADarkPictureWithinTwoStops) {
  EXPECT_NEAR(automaticExposure({10, 100}).white_cd_m2, 100, 1e-9);
  EXPECT_NEAR(automaticExposure({10, 5000}).white_cd_m2, 4 * 10 / 0.18, 1e-9) << "luminaires fill the picture";
}

TEST(Exposure, BlackImageHasAnExposureToo) {
  image::XyzImage image;
  image.x = image.y = image.z = {0, 0};
  EXPECT_EQ(automaticExposure(luminanceStatistics(image, core::Mat3(1))).white_cd_m2, 1);
}

TEST(Exposure, EvNineMetersSixtyFourCandelas) {
  // ISO 2720 with K = 12.5: L = 12.5 * 2^EV / 100; EV 9 is a lit interior.
  EXPECT_NEAR(cameraExposure(9).white_cd_m2 * 0.18, 64, 1e-9);
  EXPECT_NEAR(exposureFrom("9", {}).white_cd_m2 * 0.18, 64, 1e-9);
}

TEST(Exposure, NonsenseIsRefused) {
  for (const char* text : {"", "bright", "auto1", "auto+", "auto+x", "nan", "1e9"}) {
    EXPECT_THROW(exposureFrom(text, {}), core::InputError) << text;
  }
}

}  // namespace
}  // namespace goniolux::display
