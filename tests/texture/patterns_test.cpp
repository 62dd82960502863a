// What every procedure of the registry promises, and how patterns are laid on surfaces.
#include <gtest/gtest.h>

#include <cmath>

#include "core/random.h"
#include "texture/pattern.h"
#include "texture/picture.h"
#include "texture/texture.h"

namespace goniolux::texture {
namespace {

using core::Vec2;
using core::Vec3;

Place at(double u, double v) {
  return {{u, v}, {u, v, 0}};
}

TEST(Patterns, OfTheRegistryStayBetweenNoughtAndOneAndHaveTheMeanThatTheySay) {
  for (const PatternType& type : patternTypes()) {
    SCOPED_TRACE(type.name);
    EXPECT_FALSE(type.title.empty());
    for (const core::Parameter& parameter : type.parameters) EXPECT_FALSE(parameter.help.empty()) << parameter.key;
    const auto pattern = type.make({});
    // Noise has no repeat: 256 of its cells a side stand for all; its cells are independent, sigma some 0.2 / 256.
    const double extent = type.name == "noise" ? 256 : 1;
    double sum = 0;
    constexpr std::uint32_t samples = 1 << 18;
    for (std::uint32_t i = 0; i < samples; ++i) {
      core::Sampler random(5, i);
      const Vec2 u = extent * random.next2();
      const double value = pattern->at(at(u.x, u.y));
      ASSERT_GE(value, 0);
      ASSERT_LE(value, 1);
      sum += value;
    }
    EXPECT_NEAR(sum / samples, pattern->mean(), 4e-3);
  }
}

TEST(Patterns, RepeatAlsoBelowZero) {
  for (const PatternType& type : patternTypes()) {
    if (type.name == "noise") continue;
    const auto pattern = type.make({});
    for (const double u : {0.1, 0.4, 0.6, 0.9})
      for (const double v : {0.2, 0.7}) {
        EXPECT_EQ(pattern->at(at(u, v)), pattern->at(at(u - 3, v))) << type.name;
        EXPECT_EQ(pattern->at(at(u, v)), pattern->at(at(u + 2, v - 2))) << type.name;
      }
  }
}

TEST(Patterns, ABrickworkStaggersItsRows) {
  const auto brick = findPatternType("tiles")->make({{"joint", 0.1}, {"stagger", 0.5}});
  EXPECT_EQ(brick->at(at(0.05, 0.5)), 1) << "an upright joint";
  EXPECT_EQ(brick->at(at(0.05, 1.5)), 0) << "the next row begins half a brick later";
  EXPECT_EQ(brick->at(at(0.55, 1.5)), 1);
  EXPECT_EQ(brick->at(at(0.7, 1.05)), 1) << "a level joint";
}

TEST(Patterns, NoiseIsContinuousAcrossTheEdgesOfABox) {
  const auto noise = findPatternType("noise")->make({});
  const Projection box{.size = {0.3, 0.3}};
  for (int i = 0; i < 50; ++i) {
    const Vec3 edge(1, 0.04 * i, 2);
    const double top = noise->at(box.at({edge, {0, 0, 1}, {}})), side = noise->at(box.at({edge, {1, 0, 0}, {}}));
    EXPECT_EQ(top, side);
  }
}

TEST(Projection, ByBoxCountsMetresAlongTheSurfaceWhicheverWayItFaces) {
  const Projection tiles{.size = {0.6, 0.3}};
  EXPECT_NEAR(tiles.at({{1.2, 0.9, 7}, {0, 0, -1}, {}}).flat.x, 2, 1e-12);
  EXPECT_NEAR(tiles.at({{1.2, 0.9, 7}, {0, 0, -1}, {}}).flat.y, 3, 1e-12);
  EXPECT_NEAR(tiles.at({{7, 1.2, 0.9}, {1, 0, 0}, {}}).flat.x, 2, 1e-12);
  EXPECT_NEAR(tiles.at({{7, 1.2, 0.9}, {1, 0, 0}, {}}).flat.y, 3, 1e-12);
  EXPECT_NEAR(tiles.at({{1.2, 7, 0.9}, {0, 1, 0}, {}}).flat.x, 2, 1e-12);
}

TEST(Projection, TurnsShiftsAndRepeats) {
  Projection uv{.mapping = Projection::Mapping::uv, .size = {0.25, 0.5}, .shift = {0.5, 0}, .turn = core::pi / 2};
  // A quarter turn takes (u, v) to (v, -u).
  const Vec2 flat = uv.at({{}, {0, 0, 1}, {0.1, 0.2}}).flat;
  EXPECT_NEAR(flat.x, 0.2 / 0.25 - 0.5, 1e-12);
  EXPECT_NEAR(flat.y, -0.1 / 0.5, 1e-12);
}

Picture twoByTwo() {
  Picture picture;
  picture.width = picture.height = 2;
  picture.codes = {0, 0, 0, 255, 255, 255, 128, 0, 0, 0, 0, 255};  // black white / dark red blue
  for (int code = 0; code < 256; ++code) picture.linear.push_back(static_cast<float>(code) / 255);
  return picture;
}

TEST(Pictures, StandUprightMeetTheirPixelsAtTheCentresAndGoRound) {
  const Picture picture = twoByTwo();
  EXPECT_NEAR(picture.at({0.25, 0.75})[0], 0, 1e-7) << "upper left";
  EXPECT_NEAR(picture.at({0.75, 0.75})[1], 1, 1e-7) << "upper right";
  EXPECT_NEAR(picture.at({0.25, 0.25})[0], 128.0 / 255, 1e-7) << "lower left";
  EXPECT_NEAR(picture.at({1.75, -0.75})[2], 1, 1e-7) << "lower right, a repeat further";
  EXPECT_NEAR(picture.at({0.5, 0.75})[1], 0.5, 1e-7) << "between two";
  EXPECT_NEAR(picture.at({0, 0.75})[1], 0.5, 1e-7) << "across the edge";
}

TEST(Pictures, MeanOfAPatternIsThatOfItsPixels) {
  const PicturePattern pattern(std::make_shared<const Picture>(twoByTwo()));
  EXPECT_NEAR(pattern.mean(), (1 + 0.2126 * 128 / 255 + 0.0722) / 4, 1e-6);
  double sum = 0;
  for (int i = 0; i < 64; ++i)
    for (int j = 0; j < 64; ++j) sum += pattern.at(at((i + 0.5) / 64, (j + 0.5) / 64)) / 64 / 64;
  EXPECT_NEAR(sum, pattern.mean(), 1e-6);
}

TEST(PatternTexture, SharesAreThePatternsValueAndAddUpToOne) {
  const PatternTexture texture({.size = {1, 1}}, findPatternType("noise")->make({}));
  EXPECT_NEAR(texture.meanShares()[0], 0.5, 1e-12);
  for (int i = 0; i < 100; ++i) {
    const Mixture mixture = texture.at({{0.137 * i, 0.29 * i, 0.4}, {0, 0, 1}, {}});
    float sum = 0;
    for (std::uint32_t k = 0; k < mixture.count; ++k) sum += mixture.share[k];
    EXPECT_NEAR(sum, 1, 1e-6);
  }
}

}  // namespace
}  // namespace goniolux::texture
