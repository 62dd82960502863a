// Reinhard's local operator: dodging and burning.
#include "display/dodging.h"

#include <gtest/gtest.h>

#include <cmath>

#include "display/display_image.h"
#include "display/mapping.h"

namespace goniolux::display {
namespace {

constexpr int side = 200;

image::XyzImage painted(double (*luminance)(int x, int y)) {
  image::XyzImage image;
  image.width = image.height = side;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) image.y.push_back(static_cast<float>(luminance(x, y)));
  image.x = image.z = image.y;
  return image;
}

/// Displayed luminances, 1 = white.
std::vector<double> shown(const std::string& mapping, const image::XyzImage& image) {
  const MappingChoice choice = mappingNamed(mapping);
  const ToneMap map = choice.type->make({image, luminanceStatistics(image, core::Mat3(1)), 100, 0}, choice.arguments);
  const image::XyzImage& seen = map.seen ? *map.seen : image;
  std::vector<double> values;
  for (const float y : seen.y) values.push_back(static_cast<double>(y * map.curve->factor(y)));
  return values;
}
std::size_t at(int x, int y) {
  return static_cast<std::size_t>(side * y + x);
}

// Without contrast the surroundings of a pixel are like itself, and equation 9 is equation 4.
TEST(Dodging, OfAnEvenFieldIsTheGlobalOperator) {
  const image::XyzImage even = painted([](int, int) { return 300.0; });
  EXPECT_NEAR(shown("reinhard:local,white=900", even)[at(100, 100)], shown("reinhard:white=900", even)[at(100, 100)],
              1e-4);
}

// The neighbourhood ends at an edge: close to a window 1000 times as bright, a wall's surroundings are the wall.
TEST(Dodging, SurroundingsEndAtEdges) {
  std::vector<float> luminance;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) luminance.push_back(x < side / 2 ? 0.05F : 50.0F);
  const std::vector<float> around = localAdaptation(luminance, side, side, {});
  EXPECT_NEAR(around[at(96, 100)], 0.05, 0.005);
  EXPECT_NEAR(around[at(103, 100)], 50, 1);
  EXPECT_NEAR(around[at(10, 10)], 0.05, 1e-5);
  EXPECT_NEAR(around[at(0, 0)], 0.05, 1e-5) << "beyond the picture its edge goes on";
}

// Scales grow where there is no edge: noise of one pixel is averaged away.
TEST(Dodging, SurroundingsAreWideWhereNothingStandsOut) {
  std::vector<float> luminance;
  for (int i = 0; i < side * side; ++i) luminance.push_back(0.2F * ((i + i / side) % 2 == 0 ? 0.95F : 1.05F));
  const std::vector<float> around = localAdaptation(luminance, side, side, {});
  for (int x = 60; x < 140; ++x) ASSERT_NEAR(around[at(x, 100)], 0.2, 1e-4);
}

// What it is for: detail in what is bright. A grating of +- 10 % in a window keeps more of its contrast.
TEST(Dodging, KeepsDetailInWindows) {
  const image::XyzImage room = painted([](int x, int y) {
    const bool window = x > 60 && x < 140 && y > 60 && y < 140;
    return window ? 3000 * (1 + 0.1 * std::sin(x * 2 * core::pi / 5)) : 10.0;
  });
  const auto contrast = [&](const std::string& mapping) {
    const std::vector<double> values = shown(mapping, room);
    double least = 1e9, most = 0;
    for (int x = 90; x < 110; ++x) {
      least = std::min(least, values[at(x, 100)]);
      most = std::max(most, values[at(x, 100)]);
    }
    return (most - least) / (most + least);
  };
  const double global = contrast("reinhard:white=1000000"), local = contrast("reinhard:white=1000000,local");
  EXPECT_GT(local, 3 * global);
  EXPECT_LT(local, 0.105) << "no more than the scene's";
}

TEST(Dodging, PixelsThatAreNoNumbersDoNotSpread) {
  image::XyzImage image = painted([](int, int) { return 100.0; });
  image.y[at(100, 100)] = std::nanf("");
  const std::vector<double> values = shown("reinhard:local", image);
  EXPECT_TRUE(std::isfinite(values[at(101, 100)]));
  EXPECT_TRUE(std::isnan(values[at(100, 100)])) << "shown black and counted";
}

}  // namespace
}  // namespace goniolux::display
