#include "spectrum/colour_difference.h"

#include <cmath>

namespace goniolux::spectrum {
namespace {

constexpr double degrees = 180 / 3.14159265358979323846;

double labFunction(double t) {
  constexpr double delta = 6.0 / 29;
  return t > delta * delta * delta ? std::cbrt(t) : t / (3 * delta * delta) + 4.0 / 29;
}

double cosine(double angle) {
  return std::cos(angle / degrees);
}

// C^7 / (C^7 + 25^7), of which several roots are taken.
double seventh(double chroma) {
  const double c7 = std::pow(chroma, 7);
  return c7 / (c7 + 6103515625.0);
}

double hue(double a, double b) {
  if (a == 0 && b == 0) return 0;
  const double angle = std::atan2(b, a) * degrees;
  return angle < 0 ? angle + 360 : angle;
}

}  // namespace

Lab lab(const Xyz& colour, const Xyz& white) {
  const double x = labFunction(colour.X / white.X), y = labFunction(colour.Y / white.Y),
               z = labFunction(colour.Z / white.Z);
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

double deltaE2000(const Lab& first, const Lab& second) {
  // Sharma et al. 2005, equations 2 to 22.
  const double meanC = (std::hypot(first.a, first.b) + std::hypot(second.a, second.b)) / 2;
  const double G = 0.5 * (1 - std::sqrt(seventh(meanC)));
  const double a1 = (1 + G) * first.a, a2 = (1 + G) * second.a;
  const double C1 = std::hypot(a1, first.b), C2 = std::hypot(a2, second.b);
  const double h1 = hue(a1, first.b), h2 = hue(a2, second.b);

  const bool grey = C1 * C2 == 0;
  // Two hues just 180 degrees apart are a discontinuity of the formula; the tolerance keeps rounding from choosing the
  // side.
  constexpr double half = 180 + 1e-10;
  double dh = grey ? 0 : h2 - h1;
  if (dh > half) dh -= 360;
  if (dh < -half) dh += 360;
  double H = h1 + h2;
  if (!grey) H = std::abs(h1 - h2) <= half ? H / 2 : (H < 360 ? H + 360 : H - 360) / 2;

  const double dL = second.L - first.L, dC = C2 - C1, dH = 2 * std::sqrt(C1 * C2) * std::sin(dh / 2 / degrees);
  const double L = (first.L + second.L) / 2, C = (C1 + C2) / 2;
  const double T =
      1 - 0.17 * cosine(H - 30) + 0.24 * cosine(2 * H) + 0.32 * cosine(3 * H + 6) - 0.20 * cosine(4 * H - 63);
  const double turn = 30 * std::exp(-std::pow((H - 275) / 25, 2));
  const double lightness = (L - 50) * (L - 50);
  const double SL = 1 + 0.015 * lightness / std::sqrt(20 + lightness), SC = 1 + 0.045 * C, SH = 1 + 0.015 * C * T;
  const double RT = -std::sin(2 * turn / degrees) * 2 * std::sqrt(seventh(C));
  return std::sqrt(std::pow(dL / SL, 2) + std::pow(dC / SC, 2) + std::pow(dH / SH, 2) + RT * (dC / SC) * (dH / SH));
}

}  // namespace goniolux::spectrum
