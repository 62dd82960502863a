#include "photometry/intensity_distribution.h"

#include <gtest/gtest.h>

#include <random>

#include "photometry/arc_tangent.h"
#include "photometry/sphere_quadrature.h"

namespace goniolux::photometry {
namespace {

using core::degree;
using core::pi;
using core::Vec3;

std::vector<double> angles(double first, double last, double step) {
  std::vector<double> list;
  for (int i = 0; first + i * step <= last + 1e-9; ++i) list.push_back(first + i * step);
  return list;
}

Vec3 direction(double c, double gamma) {
  return {std::sin(gamma * degree) * std::cos(c * degree), std::sin(gamma * degree) * std::sin(c * degree),
          std::cos(gamma * degree)};
}

template <typename F>
TabulatedDistribution tabulate(PhotometryType type, const std::vector<double>& h, const std::vector<double>& v,
                               const F& candela) {
  std::vector<double> values;
  for (const double a : h) {
    for (const double b : v) values.push_back(candela(a, b));
  }
  return {type, h, v, values};
}

// An uneven web of no symmetry, in random but fixed numbers.
std::vector<double> randomCandelas(std::size_t count, unsigned seed) {
  std::mt19937 generator(seed);
  std::vector<double> values(count);
  for (double& value : values) value = 1 + 999 * (static_cast<double>(generator()) / 4294967296.0);
  return values;
}

TEST(CosinePower, FluxIsTheClosedForm) {
  EXPECT_DOUBLE_EQ(CosinePowerDistribution(1000, 1).flux(), 1000 * pi);
  EXPECT_DOUBLE_EQ(CosinePowerDistribution(500, 0).flux(), 1000 * pi);
  EXPECT_NEAR(test::quadratureFlux(CosinePowerDistribution(1000, 20), 0, 90), 1000 * 2 * pi / 21, 1e-4);
  EXPECT_TRUE(CosinePowerDistribution(1, 1).isLambertian());
  EXPECT_FALSE(CosinePowerDistribution(1, 2).isLambertian());
}

TEST(CosinePower, IsotropicEmitsToBothSides) {
  const auto isotropic = CosinePowerDistribution::isotropic(10);
  EXPECT_DOUBLE_EQ(isotropic->intensity({0, 0, -1}), 10);
  EXPECT_DOUBLE_EQ(isotropic->flux(), 40 * pi);
  EXPECT_DOUBLE_EQ(isotropic->forwardFlux(), 20 * pi);
}

TEST(Tabulated, ValuesAtTableAnglesAreExact) {
  const std::vector<double> h{0, 17, 90, 91, 200, 360}, v{0, 3, 22.5, 45, 89, 90, 140, 180};
  const std::vector<double> values = randomCandelas(h.size() * v.size(), 1);
  const TabulatedDistribution web(PhotometryType::c, h, v, values);
  for (std::size_t i = 0; i + 1 < h.size(); ++i) {  // the last plane stands where plane 0 does
    for (std::size_t j = 0; j < v.size(); ++j) {
      EXPECT_EQ(web.atAngles(h[i], v[j]), values[i * v.size() + j]);
      if (v[j] > 0 && v[j] < 180) {
        EXPECT_NEAR(web.intensity(direction(h[i], v[j])), values[i * v.size() + j], 1e-8) << h[i] << " " << v[j];
      }
    }
  }
}

TEST(Tabulated, IsBilinearBetweenTableAngles) {
  const TabulatedDistribution web(PhotometryType::c, {0, 90}, {0, 90}, {100, 200, 300, 800});
  EXPECT_DOUBLE_EQ(web.atAngles(30, 45), (100 + 200) / 2. * 2 / 3 + (300 + 800) / 2. / 3);
}

TEST(Tabulated, NothingLeavesOutsideTheVerticalRange) {
  const TabulatedDistribution web(PhotometryType::c, {0}, {0, 45, 90}, {100, 80, 50});
  EXPECT_NEAR(web.intensity({1, 0, 0}), 50, 1e-9);
  EXPECT_EQ(web.intensity({1, 0, -0.001}), 0);
  const TabulatedDistribution up(PhotometryType::c, {0}, {90, 180}, {10, 20});
  EXPECT_EQ(up.intensity({0, 0, 1}), 0);
  EXPECT_EQ(up.forwardFlux(), 0);
  EXPECT_GT(up.flux(), 0);
}

TEST(Tabulated, SymmetryFollowsFromTheHorizontalRange) {
  const std::vector<double> v{0, 90, 180};
  const auto candela = [](double h, double) { return h; };  // shows which stated plane is used
  const auto quadrant = tabulate(PhotometryType::c, angles(0, 90, 10), v, candela);
  EXPECT_NEAR(quadrant.atAngles(130, 60), 50, 1e-9);
  EXPECT_NEAR(quadrant.atAngles(200, 60), 20, 1e-9);
  EXPECT_NEAR(quadrant.atAngles(-35, 60), 35, 1e-9);
  const auto aboutC0 = tabulate(PhotometryType::c, angles(0, 180, 10), v, candela);
  EXPECT_NEAR(aboutC0.atAngles(270, 60), 90, 1e-9);
  EXPECT_NEAR(aboutC0.atAngles(-170, 60), 170, 1e-9);
  const auto aboutC90 = tabulate(PhotometryType::c, angles(90, 270, 10), v, candela);
  EXPECT_NEAR(aboutC90.atAngles(0, 60), 180, 1e-9);
  EXPECT_NEAR(aboutC90.atAngles(300, 60), 240, 1e-9);
  EXPECT_NEAR(aboutC90.atAngles(60, 60), 120, 1e-9);
}

TEST(Tabulated, UnknownHorizontalRangesHaveNoSymmetry) {
  EXPECT_FALSE(horizontalSymmetry(PhotometryType::c, {0, 45}));
  EXPECT_FALSE(horizontalSymmetry(PhotometryType::c, {10, 360}));
  EXPECT_FALSE(horizontalSymmetry(PhotometryType::b, {1, 90}));
  EXPECT_FALSE(horizontalSymmetry(PhotometryType::b, {0}));
  EXPECT_EQ(horizontalSymmetry(PhotometryType::b, {0, 90}), HorizontalSymmetry::lateral);
  EXPECT_EQ(horizontalSymmetry(PhotometryType::a, {-90, 0, 90}), HorizontalSymmetry::none);
}

TEST(Tabulated, APlaneAt360ThatIsLeftOutIsPlaneZero) {
  const std::vector<double> v{0, 90};
  const auto open = tabulate(PhotometryType::c, angles(0, 345, 15), v, [](double h, double) { return h + 1; });
  EXPECT_EQ(open.horizontalAngles().size(), 24u);
  EXPECT_NEAR(open.atAngles(352.5, 45), (346 + 1) / 2., 1e-9);
  EXPECT_NEAR(open.atAngles(359.999999, 45), 1, 0.001);
  const auto closed =
      tabulate(PhotometryType::c, angles(0, 360, 15), v, [](double h, double) { return h == 360 ? 1 : h + 1; });
  EXPECT_DOUBLE_EQ(open.flux(), closed.flux());
}

TEST(Tabulated, FluxOfALinearTableIsTheClosedForm) {
  // I = 1000 (1 - gamma / 90 deg): integral 2 pi int (1 - 2 gamma / pi) sin(gamma) dgamma = 2 pi (1 - 2 / pi).
  const TabulatedDistribution web(PhotometryType::c, {0}, {0, 90}, {1000, 0});
  EXPECT_NEAR(web.flux(), 2000 * pi * (1 - 2 / pi), 1e-9);
  EXPECT_NEAR(web.forwardFlux(), web.flux(), 1e-9);
  const TabulatedDistribution whole(PhotometryType::c, {0, 360}, {0, 180}, {100, 100, 100, 100});
  EXPECT_NEAR(whole.flux(), 400 * pi, 1e-9);
  EXPECT_NEAR(whole.forwardFlux(), 200 * pi, 1e-9);
}

TEST(Tabulated, FluxOfConstantTypesAAndBIsTheirSolidAngle) {
  const std::vector<double> half{-90, 0, 90}, whole{-180, -45, 180};
  for (const PhotometryType type : {PhotometryType::a, PhotometryType::b}) {
    const auto front = tabulate(type, half, half, [](double, double) { return 10.0; });
    EXPECT_NEAR(front.flux(), 20 * pi, 1e-9);
    EXPECT_NEAR(front.forwardFlux(), 20 * pi, 1e-9);
    const auto all = type == PhotometryType::a ? tabulate(type, whole, half, [](double, double) { return 10.0; })
                                               : tabulate(type, half, whole, [](double, double) { return 10.0; });
    EXPECT_NEAR(all.flux(), 40 * pi, 1e-9);
    EXPECT_NEAR(all.forwardFlux(), 20 * pi, 1e-9);
    const auto lateral = tabulate(type, {0, 30, 90}, half, [](double, double) { return 10.0; });
    EXPECT_NEAR(lateral.flux(), 20 * pi, 1e-9);
  }
}

TEST(Tabulated, TypesAAndBPutTheirAnglesWhereTheFrameSays) {
  const std::vector<double> h{-90, 0, 90}, v{-90, 0, 90};
  const auto sideB = tabulate(PhotometryType::b, h, v, [](double a, double) { return a + 90; });
  EXPECT_NEAR(sideB.intensity({1, 0, 0}), 180, 1e-9);  // H = +90 is C0
  EXPECT_NEAR(sideB.intensity({0, 0, 1}), 90, 1e-9);
  const auto upB = tabulate(PhotometryType::b, h, v, [](double, double b) { return b + 90; });
  EXPECT_NEAR(upB.intensity({0, 1, 0}), 180, 1e-9);  // V = +90 is up = C90
  const double c = std::cos(30 * degree), s = std::sin(30 * degree);
  EXPECT_NEAR(upB.intensity({s, c * s, c * c}), 120, 1e-9);  // B: V turns about C0
  const auto sideA = tabulate(PhotometryType::a, h, v, [](double a, double) { return a + 90; });
  EXPECT_NEAR(sideA.intensity({c * s, s, c * c}), 120, 1e-9);  // A: H turns about up
}

TEST(Tabulated, FluxOfEverySymmetryAndTypeAgreesWithQuadrature) {
  struct Case {
    PhotometryType type;
    std::vector<double> h, v;
  };
  const std::vector<Case> cases{
      {PhotometryType::c, {0}, {0, 2, 30, 60, 88, 100, 180}},
      {PhotometryType::c, {0, 20, 90}, {0, 10, 45, 80, 95, 180}},
      {PhotometryType::c, {0, 45, 60, 180}, {0, 10, 45, 90}},
      {PhotometryType::c, {90, 120, 180, 270}, {0, 10, 45, 85, 140}},
      {PhotometryType::c, {0, 30, 170, 300}, {20, 45, 85, 140}},
      {PhotometryType::a, {-90, -10, 5, 60}, {-90, -20, 0, 30, 90}},
      {PhotometryType::a, {0, 10, 50, 120}, {-60, -20, 0, 30, 70}},
      {PhotometryType::b, {-90, -10, 5, 60}, {-90, -20, 0, 30, 90}},
      {PhotometryType::b, {0, 10, 50, 90}, {-120, -20, 0, 30, 70}},
  };
  unsigned seed = 10;
  for (const Case& c : cases) {
    const TabulatedDistribution web(c.type, c.h, c.v, randomCandelas(c.h.size() * c.v.size(), ++seed));
    // The quadrature's cells do not follow the kinks and edges of types A and B: 2e-3 is what 360 x 360 panels give.
    const double tolerance = c.type == PhotometryType::c ? 5e-5 : 2e-3;
    const double whole = test::quadratureFlux(web);
    EXPECT_NEAR(web.flux(), whole, tolerance * whole) << "case " << seed;
    EXPECT_NEAR(web.forwardFlux(), test::quadratureFlux(web, 0, 90), tolerance * whole) << "case " << seed;
  }
}

TEST(Tabulated, BandFluxesAddUpToTheWhole) {
  const std::vector<double> h{0, 20, 90}, v{0, 10, 45, 80, 95, 180};
  const TabulatedDistribution web(PhotometryType::c, h, v, randomCandelas(h.size() * v.size(), 5));
  double sum = 0;
  for (int zone = 0; zone < 18; ++zone) sum += web.verticalBandFlux(10 * zone, 10 * zone + 10);
  EXPECT_NEAR(sum, web.flux(), 1e-9 * web.flux());
  EXPECT_NEAR(web.verticalBandFlux(0, 90), web.forwardFlux(), 1e-9 * web.flux());
}

TEST(AngleAxis, FindsTheIntervalOfEveryAngle) {
  for (const std::vector<double>& list :
       {std::vector<double>{0, 90}, angles(0, 180, 2.5), angles(0, 90, 0.1),
        std::vector<double>{0, 0.001, 0.002, 50, 179.9, 180}, std::vector<double>{-90, -1, 0, 33}}) {
    const AngleAxis axis(list);
    for (int i = 0; i <= 10000; ++i) {
      const double a = list.front() + (list.back() - list.front()) * i / 10000.0;
      const AngleAxis::Place place = axis.find(a);
      ASSERT_LT(place.index + 1, list.size());
      const double back = list[place.index] + place.fraction * (list[place.index + 1] - list[place.index]);
      ASSERT_NEAR(back, a, 1e-9);
      ASSERT_GE(place.fraction, 0);
      ASSERT_LE(place.fraction, 1);
    }
    for (std::size_t i = 0; i < list.size(); ++i) {
      const AngleAxis::Place place = axis.find(list[i]);
      EXPECT_EQ(place.index + (place.fraction == 1 ? 1 : 0), i);
      EXPECT_TRUE(place.fraction == 0 || place.fraction == 1);
    }
  }
}

TEST(AngleAxis, AnglesThatCrowdAreFoundToo) {
  std::vector<double> list{0};
  for (int i = 0; i < 20000; ++i) list.push_back(90 + 1e-7 * i);
  list.push_back(180);
  const AngleAxis axis(list);
  for (std::size_t i = 0; i + 1 < list.size(); ++i) EXPECT_EQ(axis.find(list[i]).index, i);
  EXPECT_EQ(axis.find(45).index, 0u);
  EXPECT_EQ(axis.find(135).index, list.size() - 2);
}

TEST(ArcTangent, AgreesWithTheStandardLibraryInEveryQuadrant) {
  std::mt19937 generator(3);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 100000; ++i) {
    const double x = normal(generator), y = normal(generator) * std::pow(10, -(i % 17));
    ASSERT_NEAR(arcTangent(y, x), std::atan2(y, x), 5e-16 * (1 + std::abs(std::atan2(y, x)))) << y << " " << x;
    ASSERT_NEAR(arcTangent(x, y), std::atan2(x, y), 5e-16 * (1 + std::abs(std::atan2(x, y)))) << x << " " << y;
  }
  EXPECT_EQ(arcTangent(0, 1), 0);
  EXPECT_EQ(arcTangent(0, 0), 0);
  EXPECT_DOUBLE_EQ(arcTangent(1, 0), pi / 2);
  EXPECT_DOUBLE_EQ(arcTangent(0, -1), pi);
  EXPECT_DOUBLE_EQ(arcTangent(-1, -1), -0.75 * pi);
}

}  // namespace
}  // namespace goniolux::photometry
