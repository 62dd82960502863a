#include "image/patch.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "image/comparison.h"

namespace goniolux::image {
namespace {

// Illuminant A at `luminance`, with half-widths.
XyzImage uniform(int width, int height, float luminance) {
  XyzImage image;
  image.width = width;
  image.height = height;
  const auto count = static_cast<std::size_t>(width * height);
  const float x = 0.44757F, y = 0.40745F;
  image.x.assign(count, luminance * x / y);
  image.y.assign(count, luminance);
  image.z.assign(count, luminance * (1 - x - y) / y);
  image.halfWidth.assign(count, 0.05F * luminance);
  image.chromaticityX.assign(count, 0.002F);
  image.chromaticityY.assign(count, 0.001F);
  return image;
}

TEST(Patch, IlluminantAHasItsColourTemperature) {
  XyzImage image = uniform(9, 9, 80);
  const PatchReading reading = readPatch(image, 4, 4, 0);
  EXPECT_EQ(reading.pixels, 1U);
  EXPECT_NEAR(reading.luminance.value, 80, 1e-4);
  EXPECT_NEAR(reading.luminance.halfWidth, 4, 1e-5);
  EXPECT_NEAR(reading.x.value, 0.44757, 1e-5);
  EXPECT_NEAR(reading.x.halfWidth, 0.002, 1e-6);
  ASSERT_TRUE(reading.colourTemperature.has_value());
  EXPECT_NEAR(reading.colourTemperature->value, 2856, 3);  // CIE 015: 2855.5 K with today's c2
  // McCamy's slope at 2856 K: about 33 K per 0.002 in x, and as much again for y.
  EXPECT_GT(reading.colourTemperature->halfWidth, 20);
  EXPECT_LT(reading.colourTemperature->halfWidth, 80);
}

TEST(Patch, StatisticalPartsOfPixelsAddInSquaresAndSystematicOnesDoNot) {
  XyzImage image = uniform(21, 21, 100);
  image.attributes[systematicAttribute] = "0.01";  // 1 of the 5 cd/m2
  const PatchReading reading = readPatch(image, 10, 10, 5);
  EXPECT_EQ(reading.pixels, 81U);  // lattice points in a circle of radius 5
  EXPECT_NEAR(reading.luminance.halfWidth, 1 + 4 / std::sqrt(81.0), 1e-4);
  EXPECT_NEAR(reading.x.halfWidth, 0.002 / 9, 1e-6);
  image.attributes.clear();
  EXPECT_NEAR(readPatch(image, 10, 10, 5).luminance.halfWidth, 5, 1e-4) << "not parted: all of it is common";
}

TEST(Patch, CornersAreCutAndPixelsThatAreNoNumbersLeftOut) {
  XyzImage image = uniform(5, 5, 10);
  image.y[1] = std::numeric_limits<float>::quiet_NaN();
  image.y[6] = 20;
  const PatchReading reading = readPatch(image, 0, 0, 1.5);  // (0,0), (1,0), (0,1), (1,1)
  EXPECT_EQ(reading.pixels, 3U);
  EXPECT_EQ(reading.invalid, 1U);
  EXPECT_NEAR(reading.luminance.value, 40.0 / 3, 1e-5);
  EXPECT_EQ(reading.most, 20);
}

TEST(Patch, BlackHasNoColour) {
  XyzImage image = uniform(2, 2, 0);
  const PatchReading reading = readPatch(image, 0, 0, 0);
  EXPECT_EQ(reading.luminance.value, 0);
  EXPECT_FALSE(reading.colourTemperature.has_value());
}

TEST(Patch, SpectralChannelsAreAveraged) {
  XyzImage image = uniform(2, 1, 10);
  image.spectrum = {{500, {1, 3}, {}}, {600, {2, 2}, {}}};
  const PatchReading reading = readPatch(image, 0, 0, 1);
  ASSERT_EQ(reading.spectrum.size(), 2U);
  EXPECT_EQ(reading.spectrum[0].second, 2);
}

TEST(Comparison, EqualImagesDoNotDiffer) {
  const XyzImage image = uniform(8, 8, 50);
  const Comparison result = compare(image, image, {95, 100, 109});
  EXPECT_EQ(result.luminanceRmse, 0);
  EXPECT_EQ(result.deltaMax, 0);
  EXPECT_EQ(result.within, 1.0);
}

TEST(Comparison, FiguresAreThoseOfTheDefinition) {
  const XyzImage first = uniform(10, 10, 50);
  XyzImage second = first;
  second.y[3] += 30;                                       // one pixel of a hundred
  for (std::size_t i = 50; i < 60; ++i) second.y[i] += 1;  // ten of a hundred, within 5 % half-widths
  const Comparison result = compare(first, second, {95, 100, 109});
  EXPECT_NEAR(result.luminanceRmse, std::sqrt((900.0 + 10) / 100), 1e-5);
  EXPECT_NEAR(result.luminanceBias, 0.4, 1e-5);
  EXPECT_NEAR(result.largestDifference, 30, 1e-4);
  EXPECT_NEAR(*result.within, 0.99, 1e-12);
  EXPECT_GT(result.deltaP95, 0.5) << "eleven per cent of the pixels differ: the 95th centile is one of them";
  EXPECT_GT(result.deltaMax, result.deltaP95);
  const XyzImage apart = difference(first, second);
  EXPECT_NEAR(apart.y[3], 30, 1e-4);
  EXPECT_EQ(apart.y[4], 0);
}

TEST(Patch, PolygonHoldsThePixelsWhoseCentresLieInsideIt) {
  XyzImage image;
  image.width = 8;
  image.height = 6;
  for (std::vector<float>* channel : {&image.x, &image.y, &image.z}) channel->resize(48);
  for (std::size_t i = 0; i < 48; ++i) image.y[i] = static_cast<float>(i % 8);
  // Columns 2 to 4, rows 1 and 2.
  const PatchReading box = readPolygon(image, {{2, 1}, {5, 1}, {5, 3}, {2, 3}});
  EXPECT_EQ(box.pixels, 6u);
  EXPECT_DOUBLE_EQ(box.luminance.value, 3);
  EXPECT_EQ(box.least, 2);
  EXPECT_EQ(box.most, 4);
  EXPECT_EQ(readPolygon(image, {{5, 3}, {2, 3}, {2, 1}, {5, 1}}).pixels, 6u) << "either way round, from any corner";
  EXPECT_EQ(readPolygon(image, {{0, 0}, {6, 0}, {0, 6}}).pixels, 15u) << "half a square, without its diagonal";
  EXPECT_EQ(readPolygon(image, {{-5, -5}, {50, -5}, {50, 50}, {-5, 50}}).pixels, 48u) << "the image's own at most";
  EXPECT_EQ(readPolygon(image, {{2.1, 2.1}, {2.4, 2.1}, {2.4, 2.4}}).pixels, 0u);
  EXPECT_EQ(readPolygon(image, {}).pixels, 0u);
}

}  // namespace
}  // namespace goniolux::image
