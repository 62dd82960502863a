// Palette: the colours of a false-colour map.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace goniolux::plot {

using Rgb = std::array<std::uint8_t, 3>;  ///< sRGB

struct Palette {
  std::string name, title;
  std::vector<Rgb> stops;  ///< evenly spaced from the lowest to the highest value
};

/// viridis (the default: even steps look even, also without colour vision or printed grey), false-colour (blue to red
/// as lighting programs have it; neither even nor safe for colour-blind readers), grey (for print). The first is the
/// default.
const std::vector<Palette>& palettes();
const Palette* findPalette(const std::string& name);

/// Colour at `fraction` of the palette (0..1, clamped), linear between its stops.
Rgb colourAt(const Palette& palette, double fraction);

/// CIE lightness L* (0..100) of an sRGB colour, for choosing ink that can be read on it.
double lightness(const Rgb& colour);

}  // namespace goniolux::plot
