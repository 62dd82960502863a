#include "display/exposure.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/diagnostics.h"

namespace goniolux::display {
namespace {

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
