// What is drawn between the points: interpolation, colours, label places, clipping.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "plot/base64.h"
#include "plot/colour_scale.h"
#include "plot/grid_field.h"
#include "plot/label_placement.h"
#include "plot/map_layout.h"
#include "plot/palette.h"

namespace goniolux::plot {
namespace {

using core::Vec2;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(GridField, GoesThroughEveryValue) {
  const std::vector<double> values{1, 5, 2, 8, 3, 3, 7, 1, 9, 0, 4, 6};
  const GridField field(4, 3, values);
  for (int j = 0; j < 3; ++j) {
    for (int i = 0; i < 4; ++i) {
      EXPECT_NEAR(field.at((i + 0.5) / 4, (j + 0.5) / 3), values[static_cast<std::size_t>(4 * j + i)], 1e-12);
    }
  }
}

TEST(GridField, ShowsNoExtremeBetweenFourPointsThatTheyDoNotHave) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(0, 1000);
  std::vector<double> values(20 * 15);
  for (double& value : values) value = uniform(random);
  const GridField field(20, 15, values);
  for (int k = 0; k < 20000; ++k) {
    const double x = uniform(random) / 1000 * 19, y = uniform(random) / 1000 * 14;  // in steps between centres
    const int i = std::min(static_cast<int>(x), 18), j = std::min(static_cast<int>(y), 13);
    double low = 1e9, high = -1e9;
    for (const int n : {20 * j + i, 20 * j + i + 1, 20 * (j + 1) + i, 20 * (j + 1) + i + 1}) {
      low = std::min(low, values[static_cast<std::size_t>(n)]);
      high = std::max(high, values[static_cast<std::size_t>(n)]);
    }
    const double value = field.at((x + 0.5) / 20, (y + 0.5) / 15);
    EXPECT_GE(value, low - 1e-9);
    EXPECT_LE(value, high + 1e-9);
  }
}

TEST(GridField, IsExactForAPlane) {
  std::vector<double> values;
  for (int j = 0; j < 6; ++j) {
    for (int i = 0; i < 8; ++i) values.push_back(100 + 3 * i - 2 * j);
  }
  const GridField field(8, 6, values);
  for (double a = 1.0 / 16; a < 15.0 / 16; a += 0.03) {
    for (double b = 1.0 / 12; b < 11.0 / 12; b += 0.03) {
      EXPECT_NEAR(field.at(a, b), 100 + 3 * (8 * a - 0.5) - 2 * (6 * b - 0.5), 1e-9);
    }
  }
}

TEST(GridField, KnowsItsExcludedCellsAndStaysFiniteThere) {
  const GridField field(3, 3, {1, 1, 1, 1, nan, 1, 1, 1, 1});
  EXPECT_TRUE(field.isExcluded(0.5, 0.5));
  EXPECT_FALSE(field.isExcluded(0.1, 0.5));
  EXPECT_NEAR(field.at(0.5, 0.5), 1, 1e-12);
}

TEST(GridField, TakesRowsAndSinglePoints) {
  EXPECT_NEAR(GridField(1, 1, {42}).at(0.3, 0.9), 42, 0);
  EXPECT_NEAR(GridField(2, 1, {0, 10}).at(0.5, 0.5), 5, 1e-12);
}

TEST(Palette, ViridisRisesInLightnessFromDarkToBright) {
  const Palette& viridis = palettes().front();
  ASSERT_EQ(viridis.name, "viridis");
  double before = -1, smallest = 1e9, largest = 0;
  for (int k = 0; k <= 32; ++k) {
    const double now = lightness(colourAt(viridis, k / 32.0));
    if (k > 0) {
      smallest = std::min(smallest, now - before);
      largest = std::max(largest, now - before);
    }
    before = now;
  }
  EXPECT_GT(smallest, 0.5) << "each step is brighter than the one before: it can be read without colour";
  EXPECT_LT(largest, 6);
}

TEST(Palette, LightnessIsThatOfCie) {
  EXPECT_NEAR(lightness({255, 255, 255}), 100, 1e-6);
  EXPECT_NEAR(lightness({0, 0, 0}), 0, 1e-12);
  EXPECT_NEAR(lightness({119, 119, 119}), 50.03, 0.01);  // sRGB 119 has Y = 0.1845, L* = 116 Y^(1/3) - 16
}

TEST(ColourScale, GivesEachFieldBetweenLevelsTheSameShareAndOneColour) {
  PlanMap map;
  map.lowest = 80;
  map.highest = 900;
  map.levels = {100, 200, 500};
  const ColourScale scale(map);
  EXPECT_NEAR(scale.fraction(100), 0.25, 1e-12);
  EXPECT_NEAR(scale.fraction(350), 0.625, 1e-12);
  EXPECT_EQ(scale.colour(101), scale.colour(199));
  EXPECT_NE(scale.colour(199), scale.colour(201));
  EXPECT_EQ(scale.colour(10), scale.colour(90));
  EXPECT_EQ(scale.colour(5000), colourAt(palettes().front(), 1));
}

TEST(LabelBoxes, OverlapAlsoWhenTurned) {
  EXPECT_TRUE(overlap({{0, 0}, 40, 10, 0}, {{0, 18}, 40, 10, core::pi / 2}));
  EXPECT_FALSE(overlap({{0, 0}, 40, 10, 0}, {{0, 26}, 40, 10, core::pi / 2}));
  // Two diamonds whose bounding boxes overlap but they do not.
  EXPECT_FALSE(overlap({{0, 0}, 20, 20, core::pi / 4}, {{18, 18}, 20, 20, core::pi / 4}));
}

TEST(LabelPlacement, PutsLabelsInsideApartAndUpright) {
  Polyline circle;
  for (int k = 0; k <= 360; ++k) {
    circle.push_back(Vec2(500, 500) + 300.0 * Vec2(std::cos(k * core::degree), std::sin(k * core::degree)));
  }
  LabelPlacement placement({0, 0}, {1000, 1000});
  const std::vector<LineLabel> labels = placement.alongLine(circle, 50, 16, 400);
  ASSERT_GE(labels.size(), 2U);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    EXPECT_NEAR(glm::distance(labels[i].box.center, Vec2(500, 500)), 300, 2);
    EXPECT_LE(std::abs(labels[i].box.angle), core::pi / 2 + 1e-9);
    for (std::size_t k = 0; k < i; ++k) EXPECT_FALSE(overlap(labels[i].box, labels[k].box));
  }
  double drawn = 0;
  for (const Polyline& part : withGaps(circle, labels)) drawn += lengthOf(part);
  EXPECT_NEAR(drawn, lengthOf(circle) - 50.0 * static_cast<double>(labels.size()), 0.5);
}

TEST(LabelPlacement, LeavesAShortLineAlone) {
  LabelPlacement placement({0, 0}, {100, 100});
  EXPECT_TRUE(placement.alongLine({{10, 10}, {50, 10}}, 40, 12, 100).empty());
}

TEST(Clipping, KeepsThePartsInside) {
  const Rectangle window{{0, 0}, {10, 10}};
  const std::vector<Polyline> parts = clipped({{-5, 5}, {5, 5}, {5, 20}, {8, 20}, {8, 5}}, window);
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_EQ(parts[0], (Polyline{{0, 5}, {5, 5}, {5, 10}}));
  EXPECT_EQ(parts[1], (Polyline{{8, 10}, {8, 5}}));
}

TEST(Joining, MakesARectangleOneClosedLineAndDrawsNothingTwice) {
  const std::vector<Polyline> lines =
      joined({{{0, 0}, {1, 0}}, {{1, 1}, {0, 1}}, {{1, 0}, {1, 1}}, {{0, 1}, {0, 0}}, {{1, 0}, {0, 0}}}, 1e-6);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0].size(), 5U);
  EXPECT_EQ(lines[0].front(), lines[0].back());
}

TEST(MapLayout, KeepsTheProportionsOfThePlan) {
  PlanMap map;
  map.grid = MapGrid{{0, 0}, {6, 0}, {0, 4}, 1, 1};
  map.points = {{3, 2}};
  map.values = {1};
  for (const auto& [width, height] : {std::pair(0, 0), std::pair(1600, 1100), std::pair(600, 1500)}) {
    map.width = width;
    map.height = height;
    const MapLayout layout = layoutOf(map);
    if (width > 0) {
      EXPECT_EQ(layout.width, width);
    }
    const Vec2 edge = layout.toPage({6, 4}) - layout.toPage({0, 0});
    EXPECT_NEAR(edge.x / edge.y, 1.5, 1e-9);
    EXPECT_GT(layout.frame.low.x, 0);
    EXPECT_LT(layout.frame.high.x, layout.width);
    EXPECT_GT(layout.frame.low.y, 0);
    EXPECT_LT(layout.frame.high.y, layout.height);
  }
}

TEST(Base64, FollowsTheTestVectorsOfRfc4648) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
}

}  // namespace
}  // namespace goniolux::plot
