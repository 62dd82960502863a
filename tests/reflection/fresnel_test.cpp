// Fresnel's equations against tabulated values (catalogue of validation cases, section 4; derived there by an
// independent program, given to 6 digits for dielectrics and 4 for metals).
#include "reflection/fresnel.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/vector.h"

namespace goniolux::reflection {
namespace {

double cosine(double degrees) {
  return std::cos(degrees * core::degree);
}

TEST(Fresnel, AirToGlassAgreesWithTheTable) {
  const struct {
    double angle, r;
  } rows[] = {{0, .04},      {30, .041523}, {45, .050240}, {56.3099, .073965}, {60, .089187},
              {70, .171043}, {75, .253061}, {80, .387704}, {85, .612800},      {89, .904185}};
  for (const auto& row : rows)
    EXPECT_NEAR(dielectricReflectance(cosine(row.angle), 1.5).mean(), row.r, 1e-6) << row.angle;
  EXPECT_NEAR(dielectricReflectance(cosine(30), 1.5).s, .057796, 1e-6);
  EXPECT_NEAR(dielectricReflectance(cosine(30), 1.5).p, .025249, 1e-6);
  EXPECT_NEAR(dielectricReflectance(cosine(45), 1.5).s, .092013, 1e-6);
  // Brewster's angle: no p-polarised light.
  EXPECT_NEAR(dielectricReflectance(std::cos(std::atan(1.5)), 1.5).p, 0, 1e-14);
}

TEST(Fresnel, GlassToAirReflectsTotallyFromTheCriticalAngleOn) {
  const struct {
    double angle, r;
  } rows[] = {{20, .041729}, {33.690, .073965}, {40, .245291}, {41, .379751}, {41.5, .541620}, {41.8, .890772}};
  for (const auto& row : rows)
    EXPECT_NEAR(dielectricReflectance(cosine(row.angle), 1 / 1.5).mean(), row.r, row.angle == 33.690 ? 3e-6 : 1e-6)
        << row.angle;
  for (const double angle : {41.8104, 45.0, 60.0, 89.9, 90.0})
    EXPECT_EQ(dielectricReflectance(cosine(angle), 1 / 1.5).mean(), 1) << angle;
  for (double angle = 41.8102; angle < 41.8105; angle += 1e-7) {
    const double r = dielectricReflectance(cosine(angle), 1 / 1.5).mean();
    ASSERT_TRUE(r >= 0 && r <= 1) << angle;
  }
}

TEST(Fresnel, HemisphericalReflectanceOfGlass) {
  EXPECT_NEAR(diffuseDielectricReflectance(1.5), .091778, 1e-5);
  // From inside: 1 - (1 - R) / n^2.
  EXPECT_NEAR(diffuseDielectricReflectance(1 / 1.5), .596346, 1e-5);
}

TEST(Fresnel, MetalsAgreeWithTheTable) {
  const struct {
    double n, k, r0, r60, r85;
  } rows[] = {{.618, 5.469, .9240, .9116, .9145},  {.959, 6.687, .9210, .9068, .8845},
              {1.475, 7.794, .9118, .8953, .8463}, {1.508, 1.879, .3857, .4170, .7494},
              {.350, 2.714, .8475, .8433, .9357},  {.206, 3.030, .9225, .9173, .9627},
              {1.166, 2.394, .5525, .5620, .8064}, {.217, 3.638, .9411, .9346, .9631}};
  for (const auto& row : rows) {
    // The table's n and k are rounded to three digits after the point, its reflectances to four.
    EXPECT_NEAR(conductorReflectance(1, row.n, row.k).mean(), row.r0, 4e-4) << row.n << " " << row.k;
    EXPECT_NEAR(conductorReflectance(cosine(60), row.n, row.k).mean(), row.r60, 4e-4) << row.n << " " << row.k;
    EXPECT_NEAR(conductorReflectance(cosine(85), row.n, row.k).mean(), row.r85, 4e-4) << row.n << " " << row.k;
  }
}

TEST(Fresnel, MetalWithoutAbsorptionIsADielectric) {
  for (const double angle : {0.0, 20.0, 45.0, 70.0, 89.0})
    EXPECT_NEAR(conductorReflectance(cosine(angle), 1.5, 0).mean(), dielectricReflectance(cosine(angle), 1.5).mean(),
                1e-12);
}

TEST(Slab, AddsUpAllReflectionsInsideAPane) {
  const struct {
    double angle, clear, absorbing;
  } rows[] = {{0, .918318, .679750}, {60, .843471, .581263}, {85, .245646, .127999}};
  for (const auto& row : rows) {
    EXPECT_NEAR(slab(cosine(row.angle), 1.52, 0, 0.006).transmittance, row.clear, 1e-6) << row.angle;
    EXPECT_NEAR(slab(cosine(row.angle), 1.52, 50, 0.006).transmittance, row.absorbing, 1e-6) << row.angle;
  }
  EXPECT_NEAR(slab(cosine(75), 1.52, 0, 0.006).transmittance, .614805, 1e-6);
  EXPECT_NEAR(slab(1, 1.52, 0, 0.006).reflectance, .081682, 1e-6);
  EXPECT_NEAR(slab(1, 1.52, 50, 0.006).reflectance, .064022, 1e-6);
  EXPECT_NEAR(slab(1, 1.5, 0, 0.001).transmittance, 12.0 / 13, 1e-12);
}

// 6 mm clear glass: the polynomial of CIE 171 within 0.4 points (index 1.52, 7.15 /m).
TEST(Slab, ClearGlassOfSixMillimetresIsTheOneOfCie171) {
  const struct {
    double angle, t;
  } rows[] = {{0, .8788}, {30, .8759}, {50, .8476}, {60, .8019}, {70, .6828}, {80, .4233}, {85, .2227}};
  for (const auto& row : rows) EXPECT_NEAR(slab(cosine(row.angle), 1.52, 7.15, 0.006).transmittance, row.t, 0.0045);
}

TEST(Slab, LosesNothingWithoutAbsorption) {
  for (double angle = 0; angle <= 90; angle += 0.5) {
    const Slab pane = slab(cosine(angle), 1.52, 0, 0.006);
    EXPECT_NEAR(pane.reflectance + pane.transmittance, 1, 1e-9) << angle;
  }
}

}  // namespace
}  // namespace goniolux::reflection
