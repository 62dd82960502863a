#include "plot/palette.h"

#include <algorithm>
#include <cmath>

namespace goniolux::plot {

const std::vector<Palette>& palettes() {
  static const std::vector<Palette> list = {
      // 16 evenly spaced colours of viridis, Smith and van der Walt (Matplotlib, 2015; CC0).
      {"viridis",
       "even to the eye, safe for colour-blind readers",
       {{0x44, 0x01, 0x54},
        {0x48, 0x1a, 0x6c},
        {0x47, 0x2f, 0x7d},
        {0x41, 0x44, 0x87},
        {0x39, 0x56, 0x8c},
        {0x31, 0x68, 0x8e},
        {0x2a, 0x78, 0x8e},
        {0x23, 0x88, 0x8e},
        {0x1f, 0x98, 0x8b},
        {0x22, 0xa8, 0x84},
        {0x35, 0xb7, 0x79},
        {0x54, 0xc5, 0x68},
        {0x7a, 0xd1, 0x51},
        {0xa5, 0xdb, 0x36},
        {0xd2, 0xe2, 0x1b},
        {0xfd, 0xe7, 0x25}}},
      {"false-colour",
       "blue to red, as lighting programs have it",
       {{0x2b, 0x2f, 0x8f},
        {0x1f, 0x6f, 0xd0},
        {0x2a, 0xb4, 0xd8},
        {0x3f, 0xc3, 0x7a},
        {0xb9, 0xd9, 0x3c},
        {0xfb, 0xd6, 0x2f},
        {0xf4, 0x92, 0x2a},
        {0xd8, 0x35, 0x27}}},
      {"grey", "for print", {{0x38, 0x38, 0x38}, {0xf6, 0xf6, 0xf6}}},
  };
  return list;
}

const Palette* findPalette(const std::string& name) {
  const auto found =
      std::find_if(palettes().begin(), palettes().end(), [&](const Palette& p) { return p.name == name; });
  return found == palettes().end() ? nullptr : &*found;
}

Rgb colourAt(const Palette& palette, double fraction) {
  const double last = static_cast<double>(palette.stops.size() - 1);
  const double position = std::clamp(std::isfinite(fraction) ? fraction : 0.0, 0.0, 1.0) * last;
  const std::size_t i = std::min(static_cast<std::size_t>(position), palette.stops.size() - 2);
  const double f = position - static_cast<double>(i);
  Rgb colour{};
  for (std::size_t c = 0; c < 3; ++c) {
    colour[c] = static_cast<std::uint8_t>(std::lround((1 - f) * palette.stops[i][c] + f * palette.stops[i + 1][c]));
  }
  return colour;
}

double lightness(const Rgb& colour) {
  // IEC 61966-2-1 to linear, Y of its primaries (D65), CIE 15 L*.
  const auto linear = [](std::uint8_t code) {
    const double v = code / 255.0;
    return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
  };
  const double y = 0.2126 * linear(colour[0]) + 0.7152 * linear(colour[1]) + 0.0722 * linear(colour[2]);
  return y > 216.0 / 24389.0 ? 116 * std::cbrt(y) - 16 : y * 24389.0 / 27.0;
}

}  // namespace goniolux::plot
