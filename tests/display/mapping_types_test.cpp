#include <gtest/gtest.h>

#include <cmath>

#include "core/diagnostics.h"
#include "display/mapping.h"
#include "display/seen_image.h"
#include "display/visual_threshold.h"

namespace goniolux::display {
namespace {

// A ramp of luminances in equal steps of the logarithm, grey.
image::XyzImage ramp(double from, double to, int width = 256, int height = 64) {
  image::XyzImage image;
  image.width = width;
  image.height = height;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      image.y.push_back(static_cast<float>(from * std::pow(to / from, x / (width - 1.0))));
  image.x = image.z = image.y;
  return image;
}

ToneMap made(const std::string& text, const image::XyzImage& image, double white = 100, double dark = 0) {
  const MappingChoice choice = mappingNamed(text);
  return choice.type->make({image, luminanceStatistics(image, core::Mat3(1)), white, dark}, choice.arguments);
}

double shown(const ToneMap& map, double luminance) {
  return luminance * static_cast<double>(map.curve->factor(static_cast<float>(luminance)));
}

TEST(Mapping, EveryOneAscendsAndStaysWithinWhite) {
  const image::XyzImage image = ramp(0.5, 5000);
  for (const MappingType& type : mappingTypes()) {
    if (type.name == "linear" || type.name == "none" || type.name == "tumblin-rushmeier") continue;  // may exceed white
    const ToneMap map = made(type.name, image);
    if (map.coloursAreFixed) continue;  // colours, no luminances
    double last = 0;
    for (double luminance = 0.5; luminance <= 5000; luminance *= 1.1) {
      const double now = shown(map, luminance);
      EXPECT_GE(now, last * (1 - 1e-4)) << type.name << " at " << luminance;
      EXPECT_LE(now, 1 + 1e-4) << type.name;
      last = now;
    }
    EXPECT_NEAR(shown(map, 5000), 1, 0.02) << type.name;
  }
}

TEST(Mapping, CameraSettingsAreThoseOfAMeter) {
  // f/8, 1/125 s at ISO 100 is EV 12.97: 0.125 * 2^12.97 = 1000 cd/m2 metered as 18 %.
  const ToneMap map = made("linear:aperture=8,shutter=1/125,iso=100", ramp(1, 100));
  EXPECT_NEAR(shown(map, 1000), 0.18, 1e-6);
  EXPECT_NEAR(shown(made("linear:aperture=8,shutter=1/125,iso=200", ramp(1, 100)), 500), 0.18, 1e-6);
}

TEST(Mapping, ReinhardIsItsEquation) {
  const image::XyzImage image = ramp(1, 10000);  // log-average 100
  const ToneMap map = made("reinhard:key=0.18,white=5000", image);
  const double l = 0.18 * 200 / 100, white = 0.18 * 5000 / 100;
  EXPECT_NEAR(shown(map, 200), l * (1 + l / (white * white)) / (1 + l), 1e-3);
  EXPECT_NEAR(shown(map, 5000), 1, 1e-3);
}

// Adapted to the same luminance there and here, nothing changes: the two brightness functions are one.
TEST(Mapping, TumblinRushmeierIsTheIdentityForEqualAdaptation) {
  const double white = 100;                    // display adaptation: 20 cd/m2
  const image::XyzImage image = ramp(2, 200);  // log-average 20
  const ToneMap map = made("tumblin-rushmeier:contrast=25", image, white);
  EXPECT_NEAR(white * shown(map, 37), 37, 0.05);
  // A night scene stays dark, where a camera would make it grey.
  const ToneMap night = made("tumblin-rushmeier", ramp(0.001, 0.1), white);
  EXPECT_LT(shown(night, 0.01), 0.09) << "a camera shows it as 0.18";
}

// Ward's first condition: nowhere more contrast than in the scene (equation 5).
TEST(Mapping, WardNeverRaisesContrastAboveTheScenes) {
  const image::XyzImage image = ramp(0.5, 5000);
  for (const char* text : {"ward:contrast=linear", "ward"}) {
    const ToneMap map = made(text, image);
    for (double luminance = 0.6; luminance < 4500; luminance *= 1.2) {
      const double ratio = shown(map, luminance * 1.2) / shown(map, luminance);
      EXPECT_LE(ratio, 1.2 * 1.06) << text << " at " << luminance;  // 2.5 % may be left to trim, a bin is 9.6 % wide
    }
  }
}

TEST(Mapping, WardLeavesASceneThatFitsLinear) {
  const ToneMap map = made("ward:contrast=linear", ramp(20, 40));
  EXPECT_NEAR(shown(map, 40) / shown(map, 20), 2, 1e-3);
}

// Ferwerda's thresholds as Ward joins them: continuous where the pieces meet.
TEST(VisualThreshold, PiecesMeet) {
  for (const double a : {-3.94, -1.44, -0.0184, 1.9}) {
    const double below = justNoticeable(std::pow(10, a - 1e-6)), above = justNoticeable(std::pow(10, a + 1e-6));
    EXPECT_NEAR(below / above, 1, 0.04) << a;  // as printed they miss by 2.8 % at -1.44
  }
  EXPECT_NEAR(justNoticeable(100) / 100, 0.0556, 1e-3);  // 10^-1.255: Weber's law
  EXPECT_NEAR(acuity(1000), 50, 2);                      // Shlaer: 50 cycles per degree in daylight
  EXPECT_NEAR(acuity(0.001), 2.5, 0.6);                  // and two to three by starlight
}

// A uniform field of L is seen as L: 0.913 L of itself and 0.087 L of veil.
TEST(SeenImage, UniformFieldKeepsItsLuminance) {
  image::XyzImage image = ramp(50, 50.0001);
  FovealImage foveal = fovealImage(image, 60);
  addVeil(image, foveal);
  for (const float y : image.y) ASSERT_NEAR(y, 50, 0.01F);
}

TEST(SeenImage, LampVeilsItsSurroundings) {
  image::XyzImage image = ramp(1, 1.0001, 240, 240);
  for (int y = 110; y < 130; ++y)
    for (int x = 110; x < 130; ++x)
      for (auto* plane : {&image.x, &image.y, &image.z}) (*plane)[static_cast<std::size_t>(240 * y + x)] = 10000;
  FovealImage foveal = fovealImage(image, 60);
  addVeil(image, foveal);
  const float near = image.y[240 * 120 + 140], far = image.y[240 * 120 + 5];
  EXPECT_GT(near, 20);
  EXPECT_GT(near, 5 * far);
  EXPECT_GT(far, 1);
}

TEST(SeenImage, ColoursFadeInTheDarkAndAreKeptInTheLight) {
  for (const float luminance : {0.003F, 100.0F}) {
    image::XyzImage image = ramp(1, 1.0001, 32, 32);
    for (auto& value : image.x) value = 2 * luminance;
    for (auto& value : image.y) value = luminance;
    for (auto& value : image.z) value = 0.2F * luminance;
    const FovealImage foveal = fovealImage(image, 30);
    fadeColours(image, foveal);
    const bool isGrey = std::abs(image.x[5] - image.z[5]) < 1e-4F * luminance;
    EXPECT_EQ(isGrey, luminance < 1);
  }
}

TEST(SeenImage, FineDetailIsLostInTheDarkOnly) {
  for (const double luminance : {0.01, 200.0}) {
    image::XyzImage image = ramp(luminance, luminance * 1.0001, 600, 60);
    for (std::size_t i = 0; i < image.y.size(); ++i) image.y[i] *= i % 2 == 0 ? 0.5F : 1.5F;  // 15 cycles per degree
    const FovealImage foveal = fovealImage(image, 20);
    blurToAcuity(image, foveal);
    const float contrast = (image.y[18301] - image.y[18300]) / static_cast<float>(luminance);
    if (luminance < 1)
      EXPECT_LT(std::abs(contrast), 0.2F);
    else
      EXPECT_NEAR(contrast, 1, 0.01F);
  }
}

TEST(Mapping, FalseColourHasALegendAndOneColourForOneLuminance) {
  const image::XyzImage image = ramp(1, 1000, 400, 300);
  const ToneMap map = made("false-colour:max=1000,scale=log", image);
  ASSERT_TRUE(map.seen.has_value());
  EXPECT_GT(map.seen->width, image.width);
  EXPECT_EQ(made("false-colour:legend=no", image).seen->width, image.width);
  EXPECT_EQ(map.seen->x[5], map.seen->x[5 + static_cast<std::size_t>(map.seen->width)]);
  EXPECT_NE(map.seen->x[5], map.seen->x[300]);
}

TEST(Mapping, WhatIsNotKnownIsRefusedWithWhatIs) {
  const auto complaint = [](const std::string& text) -> std::string {
    try {
      mappingNamed(text);
    } catch (const core::InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(complaint("wrad").find("did you mean 'ward'"), std::string::npos);
  EXPECT_NE(complaint("ward:glair").find("did you mean 'glare'"), std::string::npos);
  EXPECT_NE(complaint("ward:range=0").find("above 1"), std::string::npos);
  EXPECT_NE(complaint("ward:glare=perhaps").find("yes or no"), std::string::npos);
  EXPECT_NE(complaint("none:x").find("nothing after a colon"), std::string::npos);
  const image::XyzImage image = ramp(1, 10);
  for (const char* text : {"linear:aperture=8", "linear:white=5,ev=9", "linear:aperture=8,shutter=0", "ward:contrast=x",
                           "false-colour:min=5,max=2", "false-colour:palette=pink", "false-colour:scale=cubic"})
    EXPECT_THROW(made(text, image), core::InputError) << text;
}

}  // namespace
}  // namespace goniolux::display
