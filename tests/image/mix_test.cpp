#include "image/mix.h"

#include <gtest/gtest.h>

#include <cmath>

namespace goniolux::image {
namespace {

XyzImage layer(float luminance, float halfWidth, const char* flux) {
  XyzImage image;
  image.width = image.height = 2;
  image.x.assign(4, luminance);
  image.y.assign(4, luminance);
  image.z.assign(4, luminance);
  image.halfWidth.assign(4, halfWidth);
  image.attributes = {{sourceFluxAttribute, flux}, {systematicAttribute, "0"}, {"view", "door"}, {"layer", flux}};
  return image;
}

TEST(Mix, LightAddsUpAndStatisticalHalfWidthsInSquares) {
  const XyzImage a = layer(100, 3, "1000 1000 1000"), b = layer(50, 8, "400 500 100");
  const XyzImage sum = mixed({{&a, 1}, {&b, 0.5}});
  EXPECT_NEAR(sum.y[0], 125, 1e-4);
  EXPECT_NEAR(sum.halfWidth[0], 5, 1e-5);  // 3 and 0.5 * 8
  EXPECT_EQ(sum.attributes.at("view"), "door");
  EXPECT_FALSE(sum.attributes.contains("layer")) << "what differs is not the sum's";
  EXPECT_EQ(sum.attributes.at(adoptedWhiteAttribute), "0.34286 0.35714");  // 1200 : 1250 : 1050
}

TEST(Mix, SystematicHalfWidthsAddUp) {
  XyzImage a = layer(100, 5, "1 1 1"), b = layer(100, 5, "1 1 1");
  a.attributes[systematicAttribute] = b.attributes[systematicAttribute] = "0.05";  // all of it
  const XyzImage sum = mixed({{&a, 1}, {&b, 1}});
  EXPECT_NEAR(sum.halfWidth[0], 10, 1e-4);
  EXPECT_EQ(sum.attributes.at(systematicAttribute), "0.05");
}

TEST(Mix, LevelZeroTakesALayerAwayWhole) {
  XyzImage a = layer(100, 3, "1 1 1"), b = layer(50, 4, "1 1 1");
  b.y[2] = NAN;
  const XyzImage sum = mixed({{&a, 1}, {&b, 0}});
  EXPECT_EQ(sum.y, a.y);
}

// Two whites in equal parts: the colour between them is known no better than their luminances' ratio allows.
TEST(Mix, ChromaticityHalfWidthFollowsFromBothParts) {
  XyzImage a = layer(100, 10, "1 1 1"), b = layer(100, 10, "1 1 1");
  b.x.assign(4, 50);  // x = 0.2 instead of 1/3
  for (auto* image : {&a, &b}) image->chromaticityX.assign(4, 0), image->chromaticityY.assign(4, 0);
  const XyzImage sum = mixed({{&a, 1}, {&b, 1}});
  // x = 150 / 550; each layer's 10 % moves x by 0.1 |X_k - x S_k| / S = 0.1 * 18.18 / 550; both in squares.
  EXPECT_NEAR(sum.chromaticityX[0], std::sqrt(2.0) * 0.1 * (100 - 300 * 150.0 / 550) / 550, 1e-5);
}

}  // namespace
}  // namespace goniolux::image
