#include "spectrum/spectral_distribution.h"

#include <gtest/gtest.h>

#include "spectrum/product_integral.h"

namespace goniolux::spectrum {
namespace {

using Outside = SpectralDistribution::Outside;

TEST(SpectralDistribution, ContinuumIsLinearBetweenSamples) {
  const auto s = SpectralDistribution::sampled({{400, 1}, {500, 3}, {600, 0}}, Outside::zero);
  EXPECT_DOUBLE_EQ(s.continuum(400), 1);
  EXPECT_DOUBLE_EQ(s.continuum(450), 2);
  EXPECT_DOUBLE_EQ(s.continuum(575), 0.75);
}

TEST(SpectralDistribution, SourcesStopAndReflectancesContinueOutsideTheirSamples) {
  const auto source = SpectralDistribution::sampled({{400, 1}, {500, 3}}, Outside::zero);
  const auto reflectance = SpectralDistribution::sampled({{400, 0.1}, {500, 0.3}}, Outside::hold);
  EXPECT_EQ(source.continuum(399.9), 0);
  EXPECT_EQ(source.continuum(500.1), 0);
  EXPECT_EQ(reflectance.continuum(360), 0.1);
  EXPECT_EQ(reflectance.continuum(830), 0.3);
}

TEST(SpectralDistribution, IntegralOfSamplesIsTheTrapezoidSumAndStopsAtTheEnds) {
  const auto s = SpectralDistribution::sampled({{400, 1}, {500, 3}, {600, 0}}, Outside::zero);
  EXPECT_NEAR(s.integral(), 200 + 150, 1e-10);
  EXPECT_NEAR(s.integral(450, 550), 0.5 * (2 + 3) * 50 + 0.5 * (3 + 1.5) * 50, 1e-10);
  const auto held = SpectralDistribution::sampled({{400, 1}, {500, 3}, {600, 0}}, Outside::hold);
  EXPECT_NEAR(held.integral(), 40 * 1 + 350 + 230 * 0, 1e-10);
}

TEST(SpectralDistribution, IntegralOfProductOfStraightLinesIsExact) {
  // (w - 400)(700 - w) over 400..700 = 300^3 / 6; the knots of both lie at odd places on purpose.
  const auto rising = SpectralDistribution::sampled({{400, 0}, {433.3, 33.3}, {700, 300}}, Outside::zero);
  const auto falling = SpectralDistribution::sampled({{380, 320}, {611.7, 88.3}, {700, 0}}, Outside::zero);
  EXPECT_NEAR(rising.integral(falling), 300.0 * 300 * 300 / 6, 1e-6);
  EXPECT_NEAR(rising.integral(falling), falling.integral(rising), 1e-6);
}

TEST(SpectralDistribution, IntegralOfThreeStraightLinesIsExact) {
  // x^3 over 0..100 with x = w - 400.
  const auto x = SpectralDistribution::sampled({{400, 0}, {500, 100}}, Outside::zero);
  EXPECT_NEAR(integralOfProduct({&x, &x, &x}, 360, 830), 1e8 / 4, 1e-4);
}

TEST(SpectralDistribution, LinesCountWithTheirPowerThroughTheOtherFactor) {
  auto lamp = SpectralDistribution::flat(0);
  lamp.addLine({546.1, 5});
  lamp.addLine({1014.0, 100});  // infrared: outside the range
  const auto filter = SpectralDistribution::sampled({{500, 0}, {600, 1}}, Outside::hold);
  EXPECT_NEAR(lamp.integral(), 5, 1e-12);
  EXPECT_NEAR(lamp.integral(filter), 5 * 0.461, 1e-12);
  EXPECT_NEAR(filter.integral(lamp), 0, 1e-12) << "lines of the weight do not count";
}

TEST(SpectralDistribution, FlatMeansOneValueEverywhereAndNoLines) {
  EXPECT_TRUE(SpectralDistribution::flat(0.5).isFlat());
  EXPECT_TRUE(SpectralDistribution::sampled({{400, 0.5}, {700, 0.5}}, Outside::hold).isFlat());
  EXPECT_FALSE(SpectralDistribution::sampled({{400, 0.5}, {700, 0.5}}, Outside::zero).isFlat());
  EXPECT_FALSE(SpectralDistribution::sampled({{400, 0.5}, {700, 0.6}}, Outside::hold).isFlat());
  auto lit = SpectralDistribution::flat(0.5);
  lit.addLine({589, 1});
  EXPECT_FALSE(lit.isFlat());
}

TEST(SpectralDistribution, ScalingScalesContinuumAndLines) {
  auto s = SpectralDistribution::sampled({{400, 1}, {500, 3}}, Outside::zero);
  s.addLine({450, 7});
  EXPECT_NEAR(s.scaled(2).integral(), 2 * s.integral(), 1e-10);
  EXPECT_EQ(SpectralDistribution::flat(0.25).scaled(2), SpectralDistribution::flat(0.5));
}

}  // namespace
}  // namespace goniolux::spectrum
