#include "spectrum/cie_data.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

#include "spectrum/product_integral.h"

namespace goniolux::spectrum {
namespace {

using Chromaticity = std::array<double, 2>;

Chromaticity chromaticity(double X, double Y, double Z) {
  return {X / (X + Y + Z), Y / (X + Y + Z)};
}

// The sum over 5 nm steps from 380 to 780 nm, as CIE 015 forms it for the published values.
Chromaticity bySum(const SpectralDistribution& source) {
  double X = 0, Y = 0, Z = 0;
  for (double w = 380; w <= 780; w += 5) {
    X += source.continuum(w) * cie1931().xbar.continuum(w);
    Y += source.continuum(w) * cie1931().ybar.continuum(w);
    Z += source.continuum(w) * cie1931().zbar.continuum(w);
  }
  return chromaticity(X, Y, Z);
}

Chromaticity byIntegral(const SpectralDistribution& source) {
  return chromaticity(source.integral(cie1931().xbar), source.integral(cie1931().ybar),
                      source.integral(cie1931().zbar));
}

// CIE 015:2004, Table T.3 and CIE 015:2018: chromaticity of the illuminants, 5 nm sums (5 digits by recomputation).
struct Published {
  const char* name;
  double x, y;
};
constexpr Published published[] = {
    {"CIE A", .44758, .40745},      {"CIE D65", .31272, .32903},     {"CIE FL1", .31306, .33711},
    {"CIE FL2", .37207, .37512},    {"CIE FL3", .40909, .39412},     {"CIE FL4", .44018, .40309},
    {"CIE FL5", .31376, .34516},    {"CIE FL6", .37788, .38819},     {"CIE FL7", .31285, .32917},
    {"CIE FL8", .34581, .35862},    {"CIE FL9", .37410, .37268},     {"CIE FL10", .34579, .35876},
    {"CIE FL11", .38054, .37692},   {"CIE FL12", .43702, .40422},    {"CIE HP1", .53300, .41495},
    {"CIE LED-B3", .37561, .37229}, {"CIE LED-RGB1", .45575, .42112}};

TEST(CieData, FiveNanometreSumsGiveThePublishedChromaticities) {
  for (const auto& [name, x, y] : published) {
    const auto [gotX, gotY] = bySum(illuminant(name).value());
    EXPECT_NEAR(gotX, x, 5e-5) << name;
    EXPECT_NEAR(gotY, y, 5e-5) << name;
  }
}

// Joining 5 nm values by straight lines spreads each over a 10 nm wide triangle, where the sum sees single wavelengths:
// lamps with mercury and phosphor lines come out a little different. The bound is about a quarter of a just noticeable
// difference.
TEST(CieData, IntegralsOfJoinedValuesStayCloseToTheSums) {
  for (const auto& [name, x, y] : published) {
    const auto [gotX, gotY] = byIntegral(illuminant(name).value());
    EXPECT_NEAR(gotX, x, 3e-4) << name;
    EXPECT_NEAR(gotY, y, 3e-4) << name;
  }
}

TEST(CieData, EqualEnergyIsAtOneThird) {
  const auto [x, y] = byIntegral(SpectralDistribution::flat(1));
  EXPECT_NEAR(x, 1.0 / 3, 5e-5);
  EXPECT_NEAR(y, 1.0 / 3, 5e-5);
}

TEST(CieData, VLambdaPeaksAtOne) {
  EXPECT_NEAR(cie1931().ybar.continuum(555), 1.0, 1e-6);
  EXPECT_EQ(cie1931().ybar.samples().size(), 471U);
  EXPECT_NEAR(cie1931().ybar.integral(), 106.857, 2e-3);  // well-known integral of V(lambda), nm
}

TEST(CieData, MelanopicEfficacyOfD65IsThatOfTheStandard) {
  // CIE S 026: melanopic efficacy of luminous radiation for D65 is 1.3262 mW/lm.
  const auto d65 = illuminant("CIE D65").value();
  const double efficacy = d65.integral(melanopicAction()) / (maximumLuminousEfficacy * d65.integral(cie1931().ybar));
  EXPECT_NEAR(efficacy, 1.3262e-3, 1e-7);
}

TEST(CieData, EveryNamedIlluminantExistsAndShines) {
  const auto names = illuminantNames();
  EXPECT_EQ(names.size(), 32U);
  for (const auto& name : names) {
    const auto source = illuminant(name);
    ASSERT_TRUE(source) << name;
    EXPECT_GT(source->integral(cie1931().ybar), 0) << name;
    EXPECT_GE(source->range().first, 0) << name;
  }
  EXPECT_TRUE(illuminant("cie fl11"));
  EXPECT_FALSE(illuminant("FL11"));
  EXPECT_FALSE(illuminant("CIE FL13"));
}

TEST(CieData, DaylightOf6504KelvinIsD65) {
  // D65 is defined at 6500 K x 1.4388 / 1.4380; its table was made with rounded factors M1, M2.
  const auto made = daylight(6500 * 1.4388 / 1.4380), table = illuminant("CIE D65").value();
  for (double w = 360; w <= 830; w += 5) EXPECT_NEAR(made.continuum(w), table.continuum(w), 0.05) << w;
}

TEST(CieData, ScotopicVisionPeaksAt507Nanometres) {
  EXPECT_EQ(scotopicEfficiency().continuum(507), scotopicEfficiency().range().second);
  EXPECT_EQ(testColours().size(), 14U);
}

TEST(CieData, BlackbodyOf2856KelvinIsIlluminantA) {
  // A's definition is Planck's law with an older c2; at 2855.5 K (2848 K x 1.438776877 / 1.435) today's c2 gives the
  // same curve.
  const auto a = illuminant("CIE A").value();
  const auto planck = blackbody(2848 * 1.438776877 / 1.435);
  for (double w = 380; w <= 780; w += 50) EXPECT_NEAR(100 * planck.continuum(w), a.continuum(w), 1e-9 * a.continuum(w));
}

TEST(CieData, BlackbodyFollowsWienDisplacement) {
  // Peak at 2897.77 um K: 5000 K peaks at 579.55 nm, so 579 and 580 nm are the largest samples.
  const auto planck = blackbody(5000);
  EXPECT_EQ(planck.continuum(580), planck.range().second);
}

TEST(CieData, ColdBlackbodyDoesNotOverflow) {
  const auto cold = blackbody(20);
  EXPECT_TRUE(std::isfinite(cold.range().second));
  EXPECT_GT(cold.range().second, 0);
}

}  // namespace
}  // namespace goniolux::spectrum
