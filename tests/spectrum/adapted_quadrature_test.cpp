#include "spectrum/adapted_quadrature.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <vector>

#include "spectrum/cie_data.h"
#include "spectrum/colorimetry.h"
#include "spectrum/colour_difference.h"

namespace goniolux::spectrum {
namespace {

using Outside = SpectralDistribution::Outside;

SpectralDistribution curve(const std::function<double(double)>& f) {
  std::vector<SpectralDistribution::Sample> samples;
  for (int i = 3600; i <= 8300; ++i) samples.push_back({i / 10.0, f(i / 10.0)});
  return SpectralDistribution::sampled(std::move(samples), Outside::hold);
}

double step(double wavelength, double centre, double width) {
  return 1 / (1 + std::exp(-(wavelength - centre) / width));
}

std::vector<double> product(const std::vector<SpectralDistribution>& filters, const SpectralQuadrature& quadrature) {
  std::vector<double> result(quadrature.wavelengths.size(), 1.0);
  for (const auto& filter : filters) {
    const auto values = atNodes(filter, quadrature);
    for (std::size_t k = 0; k < result.size(); ++k) result[k] *= values[k];
  }
  return result;
}

std::vector<LightPath> pathsOf(const std::vector<std::vector<SpectralDistribution>>& paths,
                               const SpectralQuadrature& control) {
  std::vector<LightPath> result;
  for (const auto& filters : paths) result.push_back({product(filters, control), {0.01, 0.01, 0.02, 0.05}});
  return result;
}

double colourError(const Response& found, const Response& exact, const Response& white) {
  const Xyz light{white[0], white[1], white[2]};
  return deltaE2000(lab({found[0], found[1], found[2]}, light), lab({exact[0], exact[1], exact[2]}, light));
}

// The overlap of two smooth filters under D65: T1 falls at 565 nm, T2 rises at 515 nm.
struct OverlappingFilters {
  SpectralDistribution first = curve([](double w) { return 0.05 + 0.85 * (1 - step(w, 565, 8)); });
  SpectralDistribution second = curve([](double w) { return 0.05 + 0.85 * step(w, 515, 8); });
  std::vector<std::vector<SpectralDistribution>> paths{{first}, {second}, {first, second}};
};

TEST(ControlQuadrature, GivesTheOverlapOfTwoFiltersAsAnIndependentCalculationDoes) {
  // Figures of a program that is not ours, Y = 100 for the light. It sums products at 1 nm where we integrate them
  // between the nanometres; that makes 1e-4 of the value.
  const auto control = controlQuadrature({illuminant("CIE D65").value()});
  const OverlappingFilters filters;
  const Response overlap = responseOf(control.weights[0], product({filters.first, filters.second}, control));
  EXPECT_NEAR(100 * overlap[0], 16.439, 2e-4 * 16.439);
  EXPECT_NEAR(100 * overlap[1], 36.618, 2e-4 * 36.618);
  EXPECT_NEAR(100 * overlap[2], 6.804, 2e-4 * 6.804);
}

TEST(ControlQuadrature, MovesANanometreOntoEachLine) {
  auto lamp = blackbody(3000);
  for (const double w : {435.83, 546.07, 589.0, 589.6}) lamp.addLine({w, 1});
  const auto control = controlQuadrature({lamp});
  for (const double w : {435.83, 546.07, 589.0, 589.6})
    EXPECT_TRUE(std::binary_search(control.wavelengths.begin(), control.wavelengths.end(), w)) << w;
  EXPECT_FALSE(std::binary_search(control.wavelengths.begin(), control.wavelengths.end(), 436.0));
  EXPECT_EQ(control.wavelengths.size(), 471U) << "589 and 590 are both replaced";
}

TEST(AdaptedQuadrature, WhiteIsExactAndNoWeightIsNegative) {
  auto mercury = blackbody(3000);
  for (const double w : {404.7, 435.8, 546.1, 578.0}) mercury.addLine({w, 20});
  const std::vector<SpectralDistribution> sources{illuminant("CIE D65").value(), illuminant("CIE FL11").value(),
                                                  mercury};
  const auto control = controlQuadrature(sources);
  const auto paths = pathsOf(OverlappingFilters().paths, control);
  for (const int count : {1, 2, 3, 5, 9, 16}) {
    const auto quadrature = adaptedQuadrature(count, control, paths);
    ASSERT_EQ(quadrature.wavelengths.size(), static_cast<std::size_t>(count));
    EXPECT_TRUE(std::is_sorted(quadrature.wavelengths.begin(), quadrature.wavelengths.end()));
    for (std::size_t s = 0; s < sources.size(); ++s) {
      const Response found = responseOf(quadrature.weights[s], std::vector<double>(quadrature.wavelengths.size(), 1.0));
      const Response exact = responseOf(control.weights[s], std::vector<double>(control.wavelengths.size(), 1.0));
      for (std::size_t c = 0; c < found.size(); ++c) EXPECT_NEAR(found[c], exact[c], 1e-9 * exact[c] + 1e-12);
      for (const Response& weight : quadrature.weights[s])
        EXPECT_GE(*std::min_element(weight.begin(), weight.end()), 0);
    }
  }
}

TEST(AdaptedQuadrature, FiveWavelengthsGiveTheOverlapOfTwoFiltersWhereNineEvenOnesDoNot) {
  const OverlappingFilters filters;
  for (const char* name : {"CIE D65", "CIE FL11"}) {
    const std::vector<SpectralDistribution> sources{illuminant(name).value()};
    const auto control = controlQuadrature(sources);
    const Response white = responseOf(control.weights[0], std::vector<double>(control.wavelengths.size(), 1.0));
    const Response exact = responseOf(control.weights[0], product({filters.first, filters.second}, control));
    const auto error = [&](const SpectralQuadrature& q) {
      return colourError(responseOf(q.weights[0], product({filters.first, filters.second}, q)), exact, white);
    };
    EXPECT_LT(error(adaptedQuadrature(5, control, pathsOf(filters.paths, control))), 0.1) << name;
    EXPECT_GT(error(uniformQuadrature(9, sources)), 0.3) << name;
  }
}

TEST(AdaptedQuadrature, SodiumThroughANotchNeedsOneWavelengthItsOwn) {
  auto sodium = SpectralDistribution::flat(0);
  sodium.addLine({589.3, 1});
  const auto notch = curve([](double w) { return 1 - 0.95 * std::exp(-std::pow((w - 589.3) / 5, 2)); });
  const auto control = controlQuadrature({sodium});
  const auto quadrature = adaptedQuadrature(1, control, pathsOf({{notch}}, control));
  ASSERT_EQ(quadrature.wavelengths, std::vector<double>{589.3});
  EXPECT_NEAR(responseOf(quadrature.weights[0], atNodes(notch, quadrature))[1], 0.05, 5e-5);
}

TEST(AdaptedQuadrature, PathsThatWereNotGivenStayBetweenTheirExtremes) {
  const std::vector<SpectralDistribution> sources{illuminant("CIE FL11").value()};
  const auto control = controlQuadrature(sources);
  const auto quadrature = adaptedQuadrature(4, control, pathsOf(OverlappingFilters().paths, control));
  const auto comb = curve([](double w) { return 0.5 + 0.3 * std::sin(w / 7); });
  const Response found = responseOf(quadrature.weights[0], atNodes(comb, quadrature));
  EXPECT_GE(found[1], 0.2);
  EXPECT_LE(found[1], 0.8);
}

}  // namespace
}  // namespace goniolux::spectrum
