#include "spectrum/colour_rendering.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "spectrum/cie_data.h"
#include "spectrum/colorimetry.h"
#include "spectrum/reference_illuminant.h"

namespace goniolux::spectrum {
namespace {

// CIE 1960 u, v and the quantities c, d of CIE 13.3-1995, 5.7, in which its von Kries adaptation scales.
struct Uv {
  double u, v;
  [[nodiscard]] double c() const { return (4 - u - 10 * v) / v; }
  [[nodiscard]] double d() const { return (1.708 * v + 0.404 - 1.481 * u) / v; }
};

Uv uvOf(const Xyz& colour) {
  const auto [u, v] = uvPrime(colour);
  return {u, v * 2 / 3};
}

// CIE 1964 U*V*W* for a sample of luminous reflectance Y (1 = white) under a white at `white`.
std::array<double, 3> uvw(const Uv& uv, double Y, const Uv& white) {
  const double W = 25 * std::cbrt(100 * Y) - 17;
  return {13 * W * (uv.u - white.u), 13 * W * (uv.v - white.v), W};
}

}  // namespace

ColourRendering colourRendering(const SpectralDistribution& source) {
  const Xyz light = tristimulus(source);
  const double kelvin = colourTemperature(light).kelvin;
  const SpectralDistribution reference =
      atWavelengthsOf(source, kelvin < 5000 ? blackbody(kelvin) : daylight(std::min(kelvin, 25000.0)));
  const Uv k = uvOf(light), r = uvOf(tristimulus(reference));
  ColourRendering result;
  for (std::size_t i = 0; i < result.special.size(); ++i) {
    const Xyz underSource = tristimulus(testColours()[i], source),
              underReference = tristimulus(testColours()[i], reference);
    const Uv ki = uvOf(underSource);
    const double c = r.c() / k.c() * ki.c(), d = r.d() / k.d() * ki.d();
    const double denominator = 16.518 + 1.481 * c - d;
    const Uv adapted{(10.872 + 0.404 * c - 4 * d) / denominator, 5.520 / denominator};
    const auto first = uvw(uvOf(underReference), underReference.Y, r), second = uvw(adapted, underSource.Y, r);
    const double dE = std::hypot(first[0] - second[0], first[1] - second[1], first[2] - second[2]);
    result.special[i] = 100 - 4.6 * dE;
    if (i < 8) result.ra += result.special[i] / 8;
  }
  return result;
}

}  // namespace goniolux::spectrum
