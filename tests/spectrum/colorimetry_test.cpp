#include "spectrum/colorimetry.h"

#include <gtest/gtest.h>

#include <cmath>

#include "spectrum/cie_data.h"
#include "spectrum/colour_difference.h"
#include "spectrum/smooth_reflectance.h"

namespace goniolux::spectrum {
namespace {

// Chromaticities: CIE 015:2004 Table T.3 and CIE 015:2018, to five digits by recomputation with 5 nm sums;
// temperatures: exact nearest point, checked against an implementation of Ohno's method.
struct Known {
  const char* name;
  double x, y, kelvin, duv;
};
constexpr Known known[] = {{"CIE A", .44758, .40745, 2855.6, .0000},     {"CIE D65", .31272, .32903, 6503.0, .0032},
                           {"CIE FL1", .31306, .33711, 6428, .0071},     {"CIE FL2", .37207, .37512, 4225, .0018},
                           {"CIE FL3", .40909, .39412, 3446, .0007},     {"CIE FL4", .44018, .40309, 2938, -.0008},
                           {"CIE FL5", .31376, .34516, 6345, .0107},     {"CIE FL6", .37788, .38819, 4148, .0060},
                           {"CIE FL7", .31285, .32917, 6495, .0032},     {"CIE FL8", .34581, .35862, 4997, .0032},
                           {"CIE FL9", .37410, .37268, 4149, .0000},     {"CIE FL10", .34579, .35876, 4998, .0033},
                           {"CIE FL11", .38054, .37692, 3999, .0001},    {"CIE FL12", .43702, .40422, 3000, .0000},
                           {"CIE HP1", .53300, .41495, 1959, .0008},     {"CIE LED-B3", .37561, .37229, 4103, -.0007},
                           {"CIE LED-RGB1", .45575, .42112, 2840, .0043}};

TEST(Colorimetry, IlluminantsHaveTheirPublishedChromaticityAndTemperature) {
  for (const auto& [name, x, y, kelvin, duv] : known) {
    const Xyz colour = tristimulus(illuminant(name).value());
    const auto [gotX, gotY] = chromaticity(colour);
    EXPECT_NEAR(gotX, x, 5e-5) << name;
    EXPECT_NEAR(gotY, y, 5e-5) << name;
    const auto [gotKelvin, gotDuv] = colourTemperature(colour);
    EXPECT_NEAR(gotKelvin, kelvin, 1.0) << name;
    EXPECT_NEAR(gotDuv, duv, 7e-5) << name;  // the reference has four decimals: 5e-5, and 2e-5 for the difference
  }
}

TEST(Colorimetry, MelanopicRatioOfIlluminants) {
  // Recomputed from the action spectrum of CIE S 026 with the tables joined at 1 nm; D65 is 1 by definition.
  const std::pair<const char*, double> ratios[] = {{"CIE A", .4958},      {"CIE D65", 1},          {"CIE FL1", .8696},
                                                   {"CIE FL4", .3155},    {"CIE FL11", .5636},     {"CIE HP1", .1543},
                                                   {"CIE LED-B3", .6326}, {"CIE LED-RGB1", .5777}, {"CIE E", .9058}};
  for (const auto& [name, ratio] : ratios) EXPECT_NEAR(melanopicDer(illuminant(name).value()), ratio, 1e-4) << name;
}

TEST(Colorimetry, ScotopicPhotopicRatioOfIlluminantA) {
  EXPECT_NEAR(scotopicPhotopicRatio(illuminant("CIE A").value()), 1.41, 0.01);  // the value that lamp data sheets give
  EXPECT_NEAR(scotopicPhotopicRatio(illuminant("CIE D65").value()), 2.47, 0.01);  // likewise
}

TEST(Colorimetry, TemperatureOfFarColoursIsThatOfTheNearestPoint) {
  struct {
    double u, v, kelvin, duv;
  } constexpr far[] = {
      {.1978, .3122, 6507.5, .003223}, {.4328, .2883, 1041.8, -.067378}, {.2927, .2722, 2445.0, -.084371}};
  for (const auto& [u, v, kelvin, duv] : far) {
    // XYZ of CIE 1960 u, v: x = 3u / (2u - 8v + 4), y = 2v / (2u - 8v + 4).
    const double x = 3 * u / (2 * u - 8 * v + 4), y = 2 * v / (2 * u - 8 * v + 4);
    const auto got = colourTemperature({x / y, 1, (1 - x - y) / y});
    EXPECT_NEAR(got.kelvin, kelvin, 0.3);
    EXPECT_NEAR(got.duv, duv, 2e-6);
  }
}

TEST(Colorimetry, BlackbodyHasItsOwnTemperature) {
  for (const double kelvin : {800.0, 1500.0, 2700.0, 6500.0, 25000.0, 400000.0}) {
    const auto got = colourTemperature(tristimulus(blackbody(kelvin)));
    EXPECT_NEAR(got.kelvin, kelvin, 1e-4 * kelvin);
    EXPECT_NEAR(got.duv, 0, 1e-7);
  }
}

TEST(Colorimetry, ReflectanceIsRelativeToThePerfectDiffuser) {
  for (const char* name : {"CIE A", "CIE D65", "CIE FL11", "CIE E"}) {
    const auto source = illuminant(name).value();
    EXPECT_NEAR(tristimulus(SpectralDistribution::flat(0.4), source).Y, 0.4, 1e-12) << name;
  }
}

TEST(Colorimetry, UnevenTablesAreIntegratedAndLinesAreAdded) {
  auto lamp = SpectralDistribution::sampled({{400, 1}, {500, 1}, {700, 1}}, SpectralDistribution::Outside::zero);
  EXPECT_NEAR(tristimulus(lamp).Y, cie1931().ybar.integral(400, 700), 1e-9);
  lamp.addLine({555, 10});
  EXPECT_NEAR(tristimulus(lamp).Y, cie1931().ybar.integral(400, 700) + 10, 1e-4);
}

TEST(Colorimetry, BlackHasNoChromaticityButNoNanEither) {
  EXPECT_EQ(chromaticity({}).x, 0);
  EXPECT_EQ(uvPrime({}).v, 0);
}

TEST(Colorimetry, UvPrimeOfD65IsThePublishedOne) {
  const auto [u, v] = uvPrime(tristimulus(illuminant("CIE D65").value()));
  EXPECT_NEAR(u, 0.1978, 5e-5);  // CIE 015:2004, Table T.3
  EXPECT_NEAR(v, 0.4683, 5e-5);
}

// G. Sharma, W. Wu, E. N. Dalal, "The CIEDE2000 color-difference formula", Color Res. Appl. 30(1), 2005, Table I.
constexpr double pairs[34][7] = {
    {50.0, 2.6772, -79.7751, 50.0, 0.0, -82.7485, 2.0425},
    {50.0, 3.1571, -77.2803, 50.0, 0.0, -82.7485, 2.8615},
    {50.0, 2.8361, -74.02, 50.0, 0.0, -82.7485, 3.4412},
    {50.0, -1.3802, -84.2814, 50.0, 0.0, -82.7485, 1.0},
    {50.0, -1.1848, -84.8006, 50.0, 0.0, -82.7485, 1.0},
    {50.0, -0.9009, -85.5211, 50.0, 0.0, -82.7485, 1.0},
    {50.0, 0.0, 0.0, 50.0, -1.0, 2.0, 2.3669},
    {50.0, -1.0, 2.0, 50.0, 0.0, 0.0, 2.3669},
    {50.0, 2.49, -0.001, 50.0, -2.49, 0.0009, 7.1792},
    {50.0, 2.49, -0.001, 50.0, -2.49, 0.001, 7.1792},
    {50.0, 2.49, -0.001, 50.0, -2.49, 0.0011, 7.2195},
    {50.0, 2.49, -0.001, 50.0, -2.49, 0.0012, 7.2195},
    {50.0, -0.001, 2.49, 50.0, 0.0009, -2.49, 4.8045},
    {50.0, -0.001, 2.49, 50.0, 0.001, -2.49, 4.8045},
    {50.0, -0.001, 2.49, 50.0, 0.0011, -2.49, 4.7461},
    {50.0, 2.5, 0.0, 50.0, 0.0, -2.5, 4.3065},
    {50.0, 2.5, 0.0, 73.0, 25.0, -18.0, 27.1492},
    {50.0, 2.5, 0.0, 61.0, -5.0, 29.0, 22.8977},
    {50.0, 2.5, 0.0, 56.0, -27.0, -3.0, 31.903},
    {50.0, 2.5, 0.0, 58.0, 24.0, 15.0, 19.4535},
    {50.0, 2.5, 0.0, 50.0, 3.1736, 0.5854, 1.0},
    {50.0, 2.5, 0.0, 50.0, 3.2972, 0.0, 1.0},
    {50.0, 2.5, 0.0, 50.0, 1.8634, 0.5757, 1.0},
    {50.0, 2.5, 0.0, 50.0, 3.2592, 0.335, 1.0},
    {60.2574, -34.0099, 36.2677, 60.4626, -34.1751, 39.4387, 1.2644},
    {63.0109, -31.0961, -5.8663, 62.8187, -29.7946, -4.0864, 1.263},
    {61.2901, 3.7196, -5.3901, 61.4292, 2.248, -4.962, 1.8731},
    {35.0831, -44.1164, 3.7933, 35.0232, -40.0716, 1.5901, 1.8645},
    {22.7233, 20.0904, -46.694, 23.0331, 14.973, -42.5619, 2.0373},
    {36.4612, 47.858, 18.3852, 36.2715, 50.5065, 21.2231, 1.4146},
    {90.8027, -2.0831, 1.441, 91.1528, -1.6435, 0.0447, 1.4441},
    {90.9257, -0.5406, -0.9208, 88.6381, -0.8985, -0.7239, 1.5381},
    {6.7747, -0.2908, -2.4247, 5.8714, -0.0985, -2.2286, 0.6377},
    {2.0776, 0.0795, -1.135, 0.9033, -0.0636, -0.5514, 0.9082},
};

TEST(ColourDifference, PairsOfSharmaEtAlAreReproduced) {
  for (const auto& p : pairs) {
    const Lab first{p[0], p[1], p[2]}, second{p[3], p[4], p[5]};
    EXPECT_NEAR(deltaE2000(first, second), p[6], 5e-5) << p[0] << " " << p[1] << " " << p[2];
    EXPECT_NEAR(deltaE2000(second, first), p[6], 5e-5) << p[0] << " " << p[1] << " " << p[2];
  }
}

TEST(ColourDifference, WhiteIsAHundredAndGreysHaveNoChroma) {
  const Xyz white{0.95047, 1, 1.08883};
  EXPECT_NEAR(lab(white, white).L, 100, 1e-12);
  const Lab grey = lab({0.184 * white.X, 0.184, 0.184 * white.Z}, white);
  EXPECT_NEAR(grey.L, 116 * std::cbrt(0.184) - 16, 1e-12);
  EXPECT_NEAR(std::hypot(grey.a, grey.b), 0, 1e-12);
  EXPECT_NEAR(lab({0, 0, 0}, white).L, 0, 1e-12);
  EXPECT_NEAR(lab({0.001 * white.X, 0.001, 0.001 * white.Z}, white).L, 0.9033, 1e-4);  // kappa Y, kappa = 24389 / 27
}

TEST(ColourDifference, SmoothReflectancesMissTheirColourByLessThanATenth) {
  const auto d65 = illuminant("CIE D65").value();
  const Xyz white = tristimulus(d65);
  const Xyz relative{white.X / white.Y, 1, white.Z / white.Y};
  for (const Xyz& wanted : {Xyz{0.2, 0.15, 0.1}, Xyz{0.3, 0.4, 0.1}, Xyz{0.05, 0.03, 0.2}, Xyz{0.7, 0.75, 0.8}}) {
    const auto got = tristimulus(reflectanceFromXyz({wanted.X, wanted.Y, wanted.Z}).value(), d65);
    EXPECT_LT(deltaE2000(lab(got, relative), lab(wanted, relative)), 0.1);
  }
}

}  // namespace
}  // namespace goniolux::spectrum
