#include "spectrum/smooth_reflectance.h"

#include <gtest/gtest.h>

#include <cmath>

#include "spectrum/cie_data.h"
#include "spectrum/product_integral.h"

namespace goniolux::spectrum {
namespace {

std::array<double, 3> underD65(const SpectralDistribution& reflectance) {
  const auto d65 = illuminant("CIE D65").value();
  const Observer& observer = cie1931();
  const double luminous = d65.integral(observer.ybar);
  return {integralOfProduct({&d65, &observer.xbar, &reflectance}, 360, 830) / luminous,
          integralOfProduct({&d65, &observer.ybar, &reflectance}, 360, 830) / luminous,
          integralOfProduct({&d65, &observer.zbar, &reflectance}, 360, 830) / luminous};
}

TEST(SmoothReflectance, MeetsTheColourAndStaysBetweenNoneAndAll) {
  for (const auto& xyz : {std::array{0.2, 0.15, 0.1}, std::array{0.3, 0.4, 0.1}, std::array{0.05, 0.03, 0.2},
                          std::array{0.7, 0.75, 0.8}, std::array{0.002, 0.0021, 0.001}}) {
    const auto reflectance = reflectanceFromXyz(xyz);
    ASSERT_TRUE(reflectance);
    EXPECT_GE(reflectance->range().first, 0);
    EXPECT_LE(reflectance->range().second, 1);
    const auto got = underD65(*reflectance);
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(got[c], xyz[c], 1e-10);
  }
}

TEST(SmoothReflectance, EveryColourOfTheSrgbCubeHasOne) {
  for (int r = 0; r <= 4; ++r) {
    for (int g = 0; g <= 4; ++g) {
      for (int b = 0; b <= 4; ++b) {
        const auto reflectance = reflectanceFromSrgb({r / 4.0, g / 4.0, b / 4.0});
        ASSERT_TRUE(reflectance) << r << g << b;
        EXPECT_GE(reflectance->range().first, 0);
        EXPECT_LE(reflectance->range().second, 1);
      }
    }
  }
}

TEST(SmoothReflectance, SrgbRedHasTheStandardsTristimulusValues) {
  const auto got = underD65(reflectanceFromSrgb({1, 0, 0}).value());  // IEC 61966-2-1: 0.4124 0.2126 0.0193
  EXPECT_NEAR(got[0], 0.4124, 2e-4);
  EXPECT_NEAR(got[1], 0.2126, 2e-4);
  EXPECT_NEAR(got[2], 0.0193, 2e-4);
}

TEST(SmoothReflectance, GreysAreExactlyFlat) {
  for (const double grey : {0.0, 0.2, 0.5, 1.0}) {
    const auto reflectance = reflectanceFromSrgb({grey, grey, grey});
    ASSERT_TRUE(reflectance);
    EXPECT_TRUE(reflectance->isFlat());
  }
  EXPECT_NEAR(reflectanceFromSrgb({0.5, 0.5, 0.5})->continuum(550), std::pow((0.5 + 0.055) / 1.055, 2.4), 1e-9);
}

TEST(SmoothReflectance, CurvesAreSmooth) {
  const auto reflectance = reflectanceFromSrgb({0.8, 0.3, 0.2}).value();
  const auto samples = reflectance.samples();
  int turns = 0;
  for (std::size_t k = 2; k < samples.size(); ++k) {
    const double before = samples[k - 1].value - samples[k - 2].value, after = samples[k].value - samples[k - 1].value;
    if (before * after < 0) ++turns;
  }
  EXPECT_LE(turns, 2);
}

TEST(SmoothReflectance, ColoursThatNoSurfaceCanHaveAreRefused) {
  EXPECT_FALSE(reflectanceFromXyz({0.9, 0.2, 0.1}));  // a red beyond the optimal colours
  EXPECT_FALSE(reflectanceFromXyz({0.2, 0.9, 0.1}));
  EXPECT_FALSE(reflectanceFromXyz({1.1, 1.2, 1.3}));  // more than white
  EXPECT_FALSE(reflectanceFromXyz({0.1, 0, 0.1}));
  EXPECT_FALSE(reflectanceFromXyz({-0.1, 0.2, 0.1}));
  EXPECT_FALSE(reflectanceFromXyz({NAN, 0.2, 0.1}));
  EXPECT_FALSE(reflectanceFromSrgb({1.2, 0, 0}));
}

}  // namespace
}  // namespace goniolux::spectrum
