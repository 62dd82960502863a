#include "plot/section.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

namespace goniolux::plot {
namespace {

/// 8 x 4 points over 4 m x 2 m from (1, 1): the value rises by 100 a metre along x.
PlanMap ramp() {
  PlanMap map;
  map.unit = "lx";
  map.legendTitle = "Illuminance";
  map.grid = MapGrid{{1, 1}, {4, 0}, {0, 2}, 8, 4};
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 8; ++i) map.values.push_back(100 + 100 * (i + 0.5) * 0.5);
  return map;
}

TEST(Section, FollowsTheValuesAlongItsLine) {
  const PlanMap map = ramp();
  const LineChart chart = sectionOf(map, std::vector<double>(map.values.size(), 7), {1.5, 1.2}, {4.5, 2.8});
  ASSERT_EQ(chart.curves.size(), 3U);
  const double length = std::hypot(3, 1.6);
  for (const core::Vec2& p : chart.curves[0].points) EXPECT_NEAR(p.y, 150 + 300 * p.x / length, 1e-6) << p.x;
  EXPECT_NEAR(chart.curves[0].points.back().x, length, 1e-9);
  for (std::size_t i = 0; i < chart.curves[0].points.size(); ++i) {
    EXPECT_NEAR(chart.curves[1].points[i].y, chart.curves[0].points[i].y - 7, 1e-6);
    EXPECT_NEAR(chart.curves[2].points[i].y, chart.curves[0].points[i].y + 7, 1e-6);
  }
}

TEST(Section, LeavesOutWhatIsOffTheGridAndWhatIsExcluded) {
  PlanMap map = ramp();
  for (std::size_t j = 0; j < 4; ++j) map.values[8 * j + 4] = std::numeric_limits<double>::quiet_NaN();
  const LineChart chart = sectionOf(map, {}, {0, 2}, {6, 2});
  ASSERT_EQ(chart.curves.size(), 1U);
  for (const core::Vec2& p : chart.curves[0].points) {
    EXPECT_TRUE(p.x >= 1 && p.x <= 5) << p.x;
    EXPECT_FALSE(p.x > 3.01 && p.x < 3.49) << "the fifth column is excluded";
  }
  EXPECT_TRUE(sectionOf(map, {}, {0, 0}, {6, 0.5}).curves.empty()) << "beside the grid there is nothing";
}

TEST(Histogram, CountsEveryPointOnce) {
  const PlanMap map = ramp();
  const LineChart chart = histogramOf(map);
  ASSERT_EQ(chart.curves.size(), 1U);
  const auto& points = chart.curves[0].points;
  double sum = 0;
  for (std::size_t i = 1; i + 2 < points.size(); i += 2) {
    EXPECT_EQ(points[i].y, points[i + 1].y) << "each step is level";
    sum += points[i].y;
  }
  EXPECT_NEAR(sum, 100, 1e-9);
  EXPECT_LE(points.front().x, 125);
  EXPECT_GE(points.back().x, 475);
}

TEST(Histogram, OfOneValueIsOneStep) {
  PlanMap map = ramp();
  for (double& v : map.values) v = 500;
  const LineChart chart = histogramOf(map);
  ASSERT_EQ(chart.curves.size(), 1U);
  ASSERT_EQ(chart.curves[0].points.size(), 4U);
  EXPECT_EQ(chart.curves[0].points[1].y, 100);
}

}  // namespace
}  // namespace goniolux::plot
