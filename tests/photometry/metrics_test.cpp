// Metrics against closed forms of I = I0 cos^n(gamma), tabulated so finely that interpolation stays below the
// tolerances.
#include "photometry/metrics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace goniolux::photometry {
namespace {

using core::degree;
using core::pi;

TabulatedDistribution cosinePower(double peak, double n, double step = 0.25) {
  std::vector<double> gammas, candelas;
  for (int i = 0; i * step <= 90 + 1e-9; ++i) {
    gammas.push_back(i * step);
    candelas.push_back(peak * std::pow(std::max(0.0, std::cos(i * step * degree)), n));
  }
  return {PhotometryType::c, {0}, gammas, candelas};
}

// Flux within gamma of a cos^n distribution: 2 pi I0 (1 - cos^(n+1)) / (n + 1).
double coneFlux(double peak, double n, double gamma) {
  return 2 * pi * peak * (1 - std::pow(std::cos(gamma * degree), n + 1)) / (n + 1);
}

// Linear interpolation of cos^n between angles 0.25 degrees apart errs by less than (n^2/8) step^2 = 2e-5 for n <= 3.
constexpr double fine = 3e-5;

TEST(Metrics, ZonalLumensOfCosinePowersAreTheClosedForm) {
  for (const double n : {1.0, 2.0, 3.0}) {
    const auto zones = zonalLumens(cosinePower(1000, n));
    for (int i = 0; i < 9; ++i) {
      const double expected = coneFlux(1000, n, 10 * i + 10) - coneFlux(1000, n, 10 * i);
      EXPECT_NEAR(zones[static_cast<std::size_t>(i)], expected, fine * coneFlux(1000, n, 90)) << n << " " << i;
    }
    for (int i = 9; i < 18; ++i) EXPECT_EQ(zones[static_cast<std::size_t>(i)], 0);
  }
}

TEST(Metrics, FluxCodeOfALambertianIs44_75_94_100) {
  // cos(gamma) = 3/4, 1/2, 1/4: 1 - 9/16, 1 - 1/4, 1 - 1/16 of the flux.
  const TabulatedDistribution web = cosinePower(1000, 1);
  const auto code = cieFluxCode(web, web.flux() / 0.8);
  const std::array<double, 5> expected{43.75, 75, 93.75, 100, 80};
  for (std::size_t i = 0; i < 5; ++i) EXPECT_NEAR(code[i], expected[i], 0.003) << i;
  EXPECT_EQ(cieFluxCode(web, std::nullopt)[4], 100);
}

TEST(Metrics, FluxCodeCountsTheLightThatGoesUp) {
  const TabulatedDistribution all(PhotometryType::c, {0}, {0, 180}, {10, 10});
  const auto code = cieFluxCode(all, std::nullopt);
  EXPECT_NEAR(code[0], 25, 1e-9);
  EXPECT_NEAR(code[1], 50, 1e-9);
  EXPECT_NEAR(code[2], 75, 1e-9);
  EXPECT_NEAR(code[3], 50, 1e-9);
}

TEST(Metrics, BeamAndFieldAngleOfCosinePowersAreTheClosedForm) {
  for (const double n : {1.0, 10.0, 80.0}) {
    const TabulatedDistribution web = cosinePower(1000, n);
    for (const double fraction : {0.5, 0.1}) {
      const double expected = 2 * std::acos(std::pow(fraction, 1 / n)) / degree;
      EXPECT_NEAR(*fullWidth(web, PrincipalPlane::c0_180, fraction), expected, 0.01) << n;
      EXPECT_NEAR(*fullWidth(web, PrincipalPlane::c90_270, fraction), expected, 0.01) << n;
    }
  }
}

TEST(Metrics, WidthsFollowEachPrincipalPlane) {
  // Triangular profiles: half at 20 degrees in C0-C180, at 40 degrees in C90-C270.
  const TabulatedDistribution web(PhotometryType::c, {0, 90}, {0, 40, 80, 90}, {100, 0, 0, 0, 100, 50, 0, 0});
  EXPECT_NEAR(*fullWidth(web, PrincipalPlane::c0_180, 0.5), 40, 1e-9);
  EXPECT_NEAR(*fullWidth(web, PrincipalPlane::c90_270, 0.5), 80, 1e-9);
}

TEST(Metrics, TheWingsOfABatwingBelongToOneBeam) {
  const TabulatedDistribution web(PhotometryType::c, {0}, {0, 30, 50, 70, 90}, {20, 100, 100, 0, 0});
  EXPECT_NEAR(*fullWidth(web, PrincipalPlane::c0_180, 0.5), 120, 1e-9);
}

TEST(Metrics, AWallWashersBeamLiesOnItsSide) {
  // Only C0 has light: 0 at 10 degrees, 100 at 30, 0 at 50.
  const TabulatedDistribution web(PhotometryType::c, {0, 180}, {0, 10, 30, 50, 90}, {0, 0, 100, 0, 0, 0, 0, 0, 0, 0});
  EXPECT_NEAR(*fullWidth(web, PrincipalPlane::c0_180, 0.5), 20, 1e-9);
}

TEST(Metrics, UplightIsMeasuredAboutTheZenith) {
  const TabulatedDistribution web(PhotometryType::c, {0}, {90, 140, 180}, {0, 0, 100});
  EXPECT_NEAR(*fullWidth(web, PrincipalPlane::c0_180, 0.5), 40, 1e-9);
  const TabulatedDistribution dark(PhotometryType::c, {0}, {0, 90}, {0, 0});
  EXPECT_FALSE(fullWidth(dark, PrincipalPlane::c0_180, 0.5));
}

TEST(Metrics, LambertianLightHas120DegreesUpOrDown) {
  // cos(60 degrees) = 1/2, on both sides of the axis. The table has 60 degrees, so that no interpolation enters.
  const std::vector<double> gammas{0, 30, 60, 90, 120, 150, 180};
  std::vector<double> down, up, both;
  for (const double gamma : gammas) {
    const double cosine = std::cos(gamma * degree);
    down.push_back(100 * std::max(0.0, cosine));
    up.push_back(100 * std::max(0.0, -cosine));
    both.push_back(cosine > 0 ? 50 * cosine : -100 * cosine);  // twice as much up as down
  }
  for (const auto& candelas : {down, up, both}) {
    const TabulatedDistribution web(PhotometryType::c, {0}, gammas, candelas);
    for (const PrincipalPlane plane : {PrincipalPlane::c0_180, PrincipalPlane::c90_270})
      EXPECT_NEAR(*fullWidth(web, plane, 0.5), 120, 1e-9);
  }
}

TEST(Metrics, TheGreaterHalfOfDirectIndirectLightIsMeasured) {
  // Triangles: half of the downward peak of 100 at 20 degrees from the nadir, of the upward peak of 100 at 30 from the
  // zenith.
  const std::vector<double> gammas{0, 40, 90, 120, 180};
  const TabulatedDistribution down(PhotometryType::c, {0}, gammas, {100, 0, 0, 0, 80});
  EXPECT_NEAR(*fullWidth(down, PrincipalPlane::c0_180, 0.5), 40, 1e-9);
  const TabulatedDistribution up(PhotometryType::c, {0}, gammas, {80, 0, 0, 0, 100});
  EXPECT_NEAR(*fullWidth(up, PrincipalPlane::c0_180, 0.5), 60, 1e-9);
  const TabulatedDistribution alike(PhotometryType::c, {0}, gammas, {100, 0, 0, 0, 100});
  EXPECT_NEAR(*fullWidth(alike, PrincipalPlane::c0_180, 0.5), 40, 1e-9);
}

TEST(Metrics, ABareBattensPlateauReachesPastTheHorizontal) {
  // As bright to 92.5 degrees as below; half of it at 130, a quarter from 150 on: the beam is 2 x 130 degrees wide, the
  // field all around.
  const TabulatedDistribution batten(PhotometryType::c, {0}, {0, 90, 92.5, 130, 150, 180}, {120, 120, 120, 60, 30, 30});
  EXPECT_NEAR(*fullWidth(batten, PrincipalPlane::c0_180, 0.5), 260, 1e-9);
  EXPECT_NEAR(*fullWidth(batten, PrincipalPlane::c0_180, 0.1), 360, 1e-9);
  // Across the rounding of a table in candelas the plateau is still one.
  const TabulatedDistribution rounded(PhotometryType::c, {0}, {0, 90, 92.5, 130, 150, 180},
                                      {120, 120, 120 * (1 + 1e-12), 60, 30, 30});
  EXPECT_NEAR(*fullWidth(rounded, PrincipalPlane::c0_180, 0.5), 260, 1e-6);
}

TEST(Metrics, ATableThatEndsBrightEndsTheBeam) {
  const TabulatedDistribution web(PhotometryType::c, {0}, {0, 90}, {100, 100});
  EXPECT_NEAR(*fullWidth(web, PrincipalPlane::c0_180, 0.5), 180, 1e-5);
  const TabulatedDistribution all(PhotometryType::c, {0}, {0, 180}, {100, 100});
  EXPECT_NEAR(*fullWidth(all, PrincipalPlane::c0_180, 0.5), 360, 1e-9);
}

TEST(Metrics, ThePeakIsGivenInCAndGammaForEveryType) {
  const std::vector<double> angles{-90, 0, 30, 90};
  std::vector<double> candelas(16, 1.0);
  candelas[2 * 4 + 1] = 50;  // H = 30, V = 0: 30 degrees from the aim towards C0
  for (const PhotometryType type : {PhotometryType::a, PhotometryType::b}) {
    const IntensityPeak peak = intensityPeak(TabulatedDistribution(type, angles, angles, candelas));
    EXPECT_EQ(peak.intensity_cd, 50);
    EXPECT_NEAR(peak.c, 0, 1e-9);
    EXPECT_NEAR(peak.gamma, 30, 1e-9);
  }
  const IntensityPeak c =
      intensityPeak(TabulatedDistribution(PhotometryType::c, {0, 90}, {0, 45, 90}, {1, 2, 3, 4, 9, 6}));
  EXPECT_EQ(c.c, 90);
  EXPECT_EQ(c.gamma, 45);
}

TEST(Metrics, ZonesOfTypeBAddUpToItsFlux) {
  std::vector<double> angles, candelas;
  for (int i = -90; i <= 90; i += 5) angles.push_back(i);
  for (const double h : angles) {
    for (const double v : angles) candelas.push_back(std::exp(-h * h / 400 - v * v / 900) * 1000);
  }
  const TabulatedDistribution web(PhotometryType::b, angles, angles, candelas);
  const auto zones = zonalLumens(web);
  EXPECT_NEAR(std::accumulate(zones.begin(), zones.end(), 0.0), web.flux(), 2e-4 * web.flux());
  EXPECT_NEAR(*fullWidth(web, PrincipalPlane::c0_180, 0.5), 2 * 20 * std::sqrt(std::log(2.0)), 0.5);
  EXPECT_NEAR(*fullWidth(web, PrincipalPlane::c90_270, 0.5), 2 * 30 * std::sqrt(std::log(2.0)), 0.5);
}

}  // namespace
}  // namespace goniolux::photometry
