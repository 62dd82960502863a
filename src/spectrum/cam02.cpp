#include "spectrum/cam02.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace goniolux::spectrum {
namespace {

using Triple = std::array<double, 3>;
using Matrix = std::array<Triple, 3>;

constexpr Matrix cat02{{{0.7328, 0.4296, -0.1624}, {-0.7036, 1.6975, 0.0061}, {0.0030, 0.0136, 0.9834}}};
constexpr Matrix inverseCat02{
    {{1.096124, -0.278869, 0.182745}, {0.454369, 0.473533, 0.072098}, {-0.009628, -0.005698, 1.015326}}};
constexpr Matrix huntPointerEstevez{
    {{0.38971, 0.68898, -0.07868}, {-0.22981, 1.18340, 0.04641}, {0.00000, 0.00000, 1.00000}}};

Triple operator*(const Matrix& m, const Triple& v) {
  Triple result{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) result[i] += m[i][j] * v[j];
  return result;
}

// Average surround; background and luminance as the header says.
constexpr double c = 0.69, Nc = 1, LA = 100, Yb = 20, Yw = 100;

struct Conditions {
  double FL, n, Nbb, z;
  Conditions() {
    const double k = 1 / (5 * LA + 1), k4 = k * k * k * k;
    FL = 0.2 * k4 * 5 * LA + 0.1 * (1 - k4) * (1 - k4) * std::cbrt(5 * LA);
    n = Yb / Yw;
    Nbb = 0.725 * std::pow(1 / n, 0.2);
    z = 1.48 + std::sqrt(n);
  }
};

// Post-adaptation cone responses R'a, G'a, B'a.
Triple coneResponses(const Xyz& colour, const Triple& whiteRgb, const Conditions& conditions) {
  Triple rgb = cat02 * Triple{colour.X, colour.Y, colour.Z};
  for (std::size_t i = 0; i < 3; ++i) rgb[i] *= Yw / whiteRgb[i];  // complete adaptation, D = 1
  Triple cones = huntPointerEstevez * (inverseCat02 * rgb);
  for (double& cone : cones) {
    const double t = std::pow(conditions.FL * std::abs(cone) / 100, 0.42);
    cone = std::copysign(400 * t / (t + 27.13), cone) + 0.1;
  }
  return cones;
}

double achromatic(const Triple& cones, const Conditions& conditions) {
  return (2 * cones[0] + cones[1] + cones[2] / 20 - 0.305) * conditions.Nbb;
}

}  // namespace

Cam02Ucs cam02Ucs(const Xyz& colour, const Xyz& white) {
  static const Conditions conditions;
  const Triple whiteRgb = cat02 * Triple{white.X, white.Y, white.Z};
  const Triple cones = coneResponses(colour, whiteRgb, conditions);
  const double Aw = achromatic(coneResponses(white, whiteRgb, conditions), conditions);
  const double a = cones[0] - 12 * cones[1] / 11 + cones[2] / 11, b = (cones[0] + cones[1] - 2 * cones[2]) / 9;
  const double h = std::atan2(b, a);
  const double et = (std::cos(h + 2) + 3.8) / 4;
  const double J = 100 * std::pow(std::max(0.0, achromatic(cones, conditions) / Aw), c * conditions.z);
  const double t =
      50000.0 / 13 * Nc * conditions.Nbb * et * std::hypot(a, b) / (cones[0] + cones[1] + 21.0 / 20 * cones[2]);
  const double C = std::pow(t, 0.9) * std::sqrt(J / 100) * std::pow(1.64 - std::pow(0.29, conditions.n), 0.73);
  const double M = C * std::pow(conditions.FL, 0.25);
  const double Mucs = std::log(1 + 0.0228 * M) / 0.0228;
  return {1.7 * J / (1 + 0.007 * J), Mucs * std::cos(h), Mucs * std::sin(h)};
}

}  // namespace goniolux::spectrum
