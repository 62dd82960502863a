// Palettes: colours for numbers, as X, Y, Z with sRGB's white at Y = 1.
#pragma once

#include <string>
#include <vector>

#include "core/vector.h"

namespace goniolux::display {

class Palette {
 public:
  /// Colours in equal steps, sRGB code values 0..255.
  explicit Palette(const std::vector<core::Vec3>& srgb);
  /// `place`: 0..1; between the colours straight in sRGB.
  [[nodiscard]] core::Vec3 at(double place) const;

 private:
  std::vector<core::Vec3> srgb_;
};

/// "false-colour" (blue, green, yellow, red), "viridis", "grey"; core::InputError for anything else.
Palette paletteNamed(const std::string& name);
/// sRGB's white.
core::Vec3 paletteWhite();
/// X, Y, Z of sRGB code values 0..255.
core::Vec3 fromSrgb(const core::Vec3& codes);

}  // namespace goniolux::display
