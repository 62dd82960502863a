#include "spectrum/spectral_quadrature.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "spectrum/cie_data.h"

namespace goniolux::spectrum {
namespace {

using Outside = SpectralDistribution::Outside;

std::vector<SpectralDistribution> someSources() {
  auto sodium = SpectralDistribution::flat(0);
  sodium.addLine({589.0, 1});
  auto mercury = blackbody(3000);
  for (const double w : {404.7, 435.8, 546.1, 578.0}) mercury.addLine({w, 20});
  return {illuminant("CIE D65").value(), illuminant("CIE FL11").value(), SpectralDistribution::flat(1), sodium,
          mercury};
}

TEST(SpectralQuadrature, WhiteSceneIsExactForEverySourceWithAnyNumberOfNodes) {
  const auto sources = someSources();
  for (const int count : {1, 2, 3, 4, 9, 31, 80, 81, 471}) {
    const auto quadrature = uniformQuadrature(count, sources);
    ASSERT_EQ(quadrature.wavelengths.size(), static_cast<std::size_t>(count));
    ASSERT_EQ(quadrature.weights.size(), sources.size());
    const std::vector<double> white(quadrature.wavelengths.size(), 1.0);
    for (std::size_t s = 0; s < sources.size(); ++s) {
      const auto [X, Y, Z, melanopic] = responseOf(quadrature.weights[s], white);
      const double luminous = sources[s].integral(cie1931().ybar);
      EXPECT_NEAR(Y, 1, 1e-12) << count << " nodes, source " << s;
      EXPECT_NEAR(X, sources[s].integral(cie1931().xbar) / luminous, 1e-12);
      EXPECT_NEAR(Z, sources[s].integral(cie1931().zbar) / luminous, 1e-12);
      EXPECT_NEAR(melanopic, sources[s].integral(melanopicAction()) / luminous, 1e-12);
    }
  }
}

TEST(SpectralQuadrature, TransmittanceThatIsStraightBetweenNodesIsExact) {
  const auto sources = someSources();
  const auto filter = SpectralDistribution::sampled({{400, 0.1}, {550, 0.9}, {700, 0.3}}, Outside::hold);
  for (const int count : {3, 5, 9, 31}) {
    const auto quadrature = uniformQuadrature(count, sources);
    for (std::size_t s = 0; s < sources.size(); ++s) {
      const auto response = responseOf(quadrature.weights[s], atNodes(filter, quadrature));
      double Y = 0;  // source x filter x ybar, exactly: the filter as one hat of a three-node problem
      const auto exact = uniformQuadrature(3, {sources[s]});
      const double at[] = {0.1, 0.9, 0.3};
      for (std::size_t k = 0; k < 3; ++k) Y += at[k] * exact.weights[0][k][1];
      EXPECT_NEAR(response[1], Y, 1e-9) << count << " nodes, source " << s;
    }
  }
}

TEST(SpectralQuadrature, NodesAreUniformAndWideOnlyWhenThereAreMany) {
  EXPECT_EQ(uniformQuadrature(4, {}).wavelengths, (std::vector<double>{400, 500, 600, 700}));
  EXPECT_EQ(uniformQuadrature(81, {}).wavelengths.front(), 360);
  EXPECT_EQ(uniformQuadrature(81, {}).wavelengths.back(), 830);
  EXPECT_EQ(uniformQuadrature(9, {}).scheme, "uniform:9");
  EXPECT_EQ(flatQuadrature({}).scheme, "flat:1");
}

TEST(SpectralQuadrature, FlatReflectanceIsTheSameAtEveryNode) {
  const auto quadrature = uniformQuadrature(9, {});
  EXPECT_EQ(atNodes(SpectralDistribution::flat(0.37), quadrature), std::vector<double>(9, 0.37));
}

TEST(SpectralQuadrature, NodeValuesOfAReflectanceStayBetweenNoneAndAll) {
  const auto edge =
      SpectralDistribution::sampled({{559, 0.02}, {561, 0.97}}, Outside::hold);  // a fit would overshoot here
  for (const int count : {1, 4, 9, 16, 100}) {
    const auto values = atNodes(edge, uniformQuadrature(count, {}));
    EXPECT_GE(*std::min_element(values.begin(), values.end()), 0) << count;
    EXPECT_LE(*std::max_element(values.begin(), values.end()), 1) << count;
  }
}

TEST(SpectralQuadrature, AReflectanceThatReachesOneStaysANumber) {
  const auto notch = SpectralDistribution::sampled({{588, 1}, {589.3, 0.05}, {591, 1}}, Outside::hold);
  for (const int count : {4, 9, 31, 81, 471}) {
    for (const double value : atNodes(notch, uniformQuadrature(count, {}))) {
      EXPECT_GE(value, 0) << count;
      EXPECT_LE(value, 1) << count;
    }
  }
}

TEST(SpectralQuadrature, NarrowBandsBetweenNodesAreNotSteppedOver) {
  // A 4 nm band at 550 nm lies between the nodes 533.3 and 566.7 of ten; under light of equal energy it passes a known
  // share.
  const auto band = SpectralDistribution::sampled({{546, 0}, {550, 1}, {554, 0}}, Outside::hold);
  const auto white = SpectralDistribution::flat(1);
  const auto quadrature = uniformQuadrature(10, {white});
  const auto [X, Y, Z, melanopic] = responseOf(quadrature.weights[0], atNodes(band, quadrature));
  const auto& observer = cie1931();
  const double exact = band.integral(observer.xbar) + band.integral(observer.ybar) + band.integral(observer.zbar);
  EXPECT_NEAR(X + Y + Z, exact / observer.ybar.integral(), 1e-9) << "what is seen is kept exactly";
  const double luminous = band.integral(observer.ybar) / observer.ybar.integral();
  EXPECT_NEAR(Y, luminous, 0.05 * luminous);
}

TEST(SpectralQuadrature, OneNodeGivesTheLuminousReflectanceUnderEqualEnergy) {
  const auto red = SpectralDistribution::sampled({{580, 0.05}, {620, 0.8}}, Outside::hold);
  const double luminous = red.integral(cie1931().ybar) / cie1931().ybar.integral();
  EXPECT_NEAR(atNodes(red, uniformQuadrature(1, {}))[0], luminous, 1e-12);
}

TEST(SpectralQuadrature, DarkSourceIsRefused) {
  auto infrared = SpectralDistribution::flat(0);
  infrared.addLine({950, 1});
  EXPECT_THROW(uniformQuadrature(3, {infrared}), std::invalid_argument);
}

}  // namespace
}  // namespace goniolux::spectrum
