// The near field of luminous openings against closed forms, from a tenth of the opening's size to ten times: facing and
// perpendicular receivers. Issue: 0.1 % without noise. The figures are printed.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>

#include "emitter/emitter.h"

namespace goniolux::emitter {
namespace {

using core::pi;
using core::Vec3;

constexpr double ratios[] = {0.1, 0.2, 0.5, 1, 2, 5, 10};  // distance over the largest dimension
constexpr double tolerance = 1e-4;

Output lambertian(double flux) {
  Output output;
  output.distribution = std::make_shared<photometry::CosinePowerDistribution>(1.0, 1.0);
  output.scale = flux / pi;
  return output;
}

Output diffuse(double flux) {
  Output output;
  output.flux_lm = flux;
  return output;
}

/// Collects the largest relative error and says it at the end.
class Worst {
 public:
  explicit Worst(const char* name) : name_(name) {}
  ~Worst() { std::printf("%-42s largest error %.2e over %d receivers\n", name_, worst_, count_); }
  void compare(const Illuminance& found, double exact) {
    const double error = std::abs(found.value / exact - 1);
    EXPECT_LT(error, 1e-3) << name_ << ": " << found.value << " for " << exact;
    EXPECT_LE(std::abs(found.value - exact), found.bound + 1e-9 * exact + 2e-5 * exact) << "outside its own bound";
    worst_ = std::max(worst_, error);
    ++count_;
  }

 private:
  const char* name_;
  double worst_ = 0;
  int count_ = 0;
};

// E / L of a rectangle a x b seen from a point at distance d before its corner (textbooks; Hamilton & Morgan 1952).
double facingCorner(double a, double b, double d) {
  const double x = a / d, y = b / d;
  return 0.5 * (x / std::sqrt(1 + x * x) * std::atan(y / std::sqrt(1 + x * x)) +
                y / std::sqrt(1 + y * y) * std::atan(x / std::sqrt(1 + y * y)));
}
// The receiver's plane perpendicular to the rectangle, through the edge of length b; the rectangle reaches a from it.
double perpendicularCorner(double a, double b, double d) {
  return 0.5 * (std::atan(b / d) - d / std::hypot(d, a) * std::atan(b / std::hypot(d, a)));
}

TEST(NearField, OfADiscMeetsYamauti) {
  Worst worst("disc, facing and perpendicular");
  const double a = 0.5, luminance = 1000;
  Opening opening{.shape = Opening::Shape::disc, .diameter = 2 * a};
  const auto emitter = makeEmitter(opening, {0, 0, 0}, lambertian(luminance * pi * pi * a * a));
  for (const double q : ratios) {
    const double d = q * 2 * a;
    for (const double r : {0.0, 0.5 * a, a, 3 * a}) {
      const double s = std::sqrt(std::pow(r * r + d * d + a * a, 2) - 4 * a * a * r * r);
      worst.compare(emitter->illuminance({r, 0, -d}, {0, 0, 1}, tolerance),
                    0.5 * pi * luminance * (1 - (r * r + d * d - a * a) / s));
      if (r >= a)
        worst.compare(emitter->illuminance({r, 0, -d}, {-1, 0, 0}, tolerance),
                      0.5 * pi * luminance * d / r * ((r * r + d * d + a * a) / s - 1));
    }
  }
}

TEST(NearField, OfARectangleMeetsItsCornerFormulas) {
  Worst worst("rectangle, facing and perpendicular");
  const double length = 1.2, width = 0.3, luminance = 5000;
  Opening opening{.shape = Opening::Shape::rectangle, .length = length, .width = width};
  const auto emitter = makeEmitter(opening, {0, 0, 0}, lambertian(luminance * pi * length * width));
  for (const double q : ratios) {
    const double d = q * length;
    worst.compare(emitter->illuminance({0, 0, -d}, {0, 0, 1}, tolerance),
                  4 * luminance * facingCorner(length / 2, width / 2, d));
    worst.compare(emitter->illuminance({length / 2, width / 2, -d}, {0, 0, 1}, tolerance),
                  luminance * facingCorner(length, width, d));
    worst.compare(emitter->illuminance({length / 2, width / 2, -d}, {-1, 0, 0}, tolerance),
                  luminance * perpendicularCorner(length, width, d));
    worst.compare(emitter->illuminance({0, width / 2, -d}, {0, -1, 0}, tolerance),
                  2 * luminance * perpendicularCorner(width, length / 2, d));
  }
}

// The same opening with a table instead of the built-in cosine: no closed form, quadrature.
TEST(NearField, OfATabulatedCosineMeetsTheSameFormulas) {
  Worst worst("rectangle with a table, by quadrature");
  const double length = 1.2, width = 0.3;
  std::vector<double> gammas, candelas;
  for (int i = 0; i <= 900; ++i) {
    gammas.push_back(0.1 * i);
    candelas.push_back(i == 900 ? 0 : 1000 * std::cos(0.1 * i * core::degree));
  }
  Output output;
  output.distribution = std::make_shared<photometry::TabulatedDistribution>(photometry::PhotometryType::c,
                                                                            std::vector<double>{0}, gammas, candelas);
  Opening opening{.shape = Opening::Shape::rectangle, .length = length, .width = width};
  const auto emitter = makeEmitter(opening, {0, 0, 0}, output);
  const double luminance = 1000 / (length * width);
  for (const double q : ratios) {
    const double d = q * length;
    worst.compare(emitter->illuminance({0, 0, -d}, {0, 0, 1}, tolerance),
                  4 * luminance * facingCorner(length / 2, width / 2, d));
    worst.compare(emitter->illuminance({length / 2, width / 2, -d}, {-1, 0, 0}, tolerance),
                  luminance * perpendicularCorner(length, width, d));
  }
}

TEST(NearField, OfALineMeetsItsClosedForm) {
  Worst worst("line, facing and perpendicular");
  const double l = 1.2, perMetre = 1000;
  Opening opening{.shape = Opening::Shape::line, .length = l, .axis = {1, 0, 0}};
  const auto emitter = makeEmitter(opening, {0, 0, 0}, diffuse(pi * pi * perMetre * l));
  for (const double q : ratios) {
    const double d = q * l, half = std::atan(0.5 * l / d), whole = std::atan(l / d);
    worst.compare(emitter->illuminance({0, 0, -d}, {0, 0, 1}, tolerance),
                  perMetre / d * (half + std::sin(half) * std::cos(half)));
    worst.compare(emitter->illuminance({l / 2, 0, -d}, {0, 0, 1}, tolerance),
                  perMetre / (2 * d) * (whole + std::sin(whole) * std::cos(whole)));
    worst.compare(emitter->illuminance({l / 2, 0, -d}, {-1, 0, 0}, tolerance),
                  perMetre / (2 * d) * std::sin(whole) * std::sin(whole));
  }
}

// A tube seen under one end, by quadrature over its visible half (independent of the emitter's own mapping).
TEST(NearField, OfATubeMeetsTheIntegralOverItsSurface) {
  Worst worst("tube, facing and perpendicular");
  const double l = 1.2, radius = 0.013, luminance = 1e4;
  Opening opening{.shape = Opening::Shape::tube, .length = l, .diameter = 2 * radius, .axis = {1, 0, 0}};
  const auto emitter = makeEmitter(opening, {0, 0, 0}, diffuse(luminance * pi * 2 * pi * radius * l));
  // Along the axis in closed form: a strip at phi is a line whose Lambertian elements face the point.
  for (const double q : ratios) {
    const double d = q * l;
    double facing = 0, sideways = 0;
    constexpr int strips = 4000;
    const double visible = std::acos(radius / d);
    for (int i = 0; i < strips; ++i) {
      const double phi = visible * (2 * (i + 0.5) / strips - 1), y = radius * std::sin(phi),
                   z = d - radius * std::cos(phi);  // of the strip, from the point
      const double rho2 = y * y + z * z, rho = std::sqrt(rho2);
      // cosine at the tube over the distance: (normal . to point) / r, and at the receiver z / r or x / r.
      const double towards = std::cos(phi) * z - std::sin(phi) * y;
      // Integrals over x from 0 to l of dx / (x^2 + rho^2)^2 and x dx / (x^2 + rho^2)^2.
      const double one = l / (2 * rho2 * (l * l + rho2)) + std::atan(l / rho) / (2 * rho2 * rho);
      const double two = 0.5 * (1 / rho2 - 1 / (l * l + rho2));
      const double area = radius * 2 * visible / strips;
      facing += luminance * area * towards * z * one;
      sideways += luminance * area * towards * two;
    }
    worst.compare(emitter->illuminance({l / 2, 0, -d}, {0, 0, 1}, tolerance), facing);
    worst.compare(emitter->illuminance({l / 2, 0, -d}, {-1, 0, 0}, tolerance), sideways);
  }
}

}  // namespace
}  // namespace goniolux::emitter
