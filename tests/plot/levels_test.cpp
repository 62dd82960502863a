#include "plot/levels.h"

#include <gtest/gtest.h>

#include <limits>

#include "plot/number_text.h"

namespace goniolux::plot {
namespace {

using Levels = std::vector<double>;

TEST(IsoluxLevels, TakeTheStepsOfEn12464WhereEnoughOfThemFit) {
  EXPECT_EQ(isoluxLevels(90, 1100), (Levels{100, 150, 200, 300, 500, 750, 1000}));
}

TEST(IsoluxLevels, AreEvenRoundNumbersInANarrowRange) {
  EXPECT_EQ(isoluxLevels(283, 641), (Levels{300, 350, 400, 450, 500, 550, 600}));
  EXPECT_EQ(isoluxLevels(0.2, 1.3), (Levels{0.4, 0.6000000000000001, 0.8, 1, 1.2000000000000002}));
}

TEST(IsoluxLevels, NeverComeCloserThanTheValuesAreCertain) {
  const Levels levels = isoluxLevels(490, 510, 4);
  ASSERT_GE(levels.size(), 1U);
  for (std::size_t i = 1; i < levels.size(); ++i) EXPECT_GE(levels[i] - levels[i - 1], 4);
  EXPECT_TRUE(isoluxLevels(499, 501, 4).empty()) << "what is the same within its half-width gets no lines";
}

TEST(IsoluxLevels, AreNoneWhereThereIsNoRange) {
  EXPECT_TRUE(isoluxLevels(500, 500).empty());
  EXPECT_TRUE(isoluxLevels(0, 0).empty());
}

TEST(IsoluxLevels, StayStrictlyInsideAndFewForAnyRange) {
  for (double low = 0; low < 3; low += 0.37) {
    for (double high = low * 1.05 + 0.01; high < 1e5; high *= 1.7) {
      const Levels levels = isoluxLevels(low, high);
      EXPECT_GE(levels.size(), 3U) << low << " " << high;
      EXPECT_LE(levels.size(), 21U) << low << " " << high;
      EXPECT_GT(levels.front(), low);
      EXPECT_LT(levels.back(), high);
    }
  }
}

TEST(MapLevels, GiveTheScaleToTheRoomAndNotToOneDarkCorner) {
  std::vector<double> values;
  for (int k = 0; k <= 1000; ++k) values.push_back(400 + 0.3 * k);  // 400 to 700
  values.insert(values.end(), 20, 9.0);                             // fewer than 5 % in a shadow
  EXPECT_EQ(mapLevels(values, 1), (Levels{100, 200, 450, 500, 550, 600, 650}));
  values.insert(values.end(), 10, 4000.0);
  EXPECT_EQ(mapLevels(values, 1), (Levels{100, 200, 450, 500, 550, 600, 650, 1500, 3000}));
}

TEST(AxisTicks, IncludeRoundEnds) {
  EXPECT_EQ(axisTicks(0, 6, 6), (Levels{0, 1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(axisTicks(-0.09, 2.09, 4), (Levels{0, 0.5, 1, 1.5, 2}));
}

TEST(ParseLevels, TakesListsAndRefusesWords) {
  EXPECT_EQ(parseLevels("300, 100;200 100"), (Levels{100, 200, 300}));
  EXPECT_FALSE(parseLevels("100,many"));
  EXPECT_FALSE(parseLevels("100lx"));
  EXPECT_FALSE(parseLevels(" , "));
  EXPECT_FALSE(parseLevels("nan"));
}

TEST(NumberText, WritesAHalfWidthWithItsValueToTheSamePlace) {
  EXPECT_EQ(uncertaintyText(512.34, 4.2), "512 ± 4");
  EXPECT_EQ(uncertaintyText(512.34, 1.23), "512.3 ± 1.2");
  EXPECT_EQ(uncertaintyText(0.56312, 0.0118), "0.563 ± 0.012");
  EXPECT_EQ(uncertaintyText(512.3, 0), "512.3");
  EXPECT_EQ(uncertaintyText(std::numeric_limits<double>::quiet_NaN(), 1), "undefined");
  EXPECT_EQ(levelText(12345), "12345");
  EXPECT_EQ(levelText(0.75), "0.75");
}

}  // namespace
}  // namespace goniolux::plot
