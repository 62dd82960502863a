#include "display/palette.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/closest_name.h"
#include "core/diagnostics.h"
#include "display/device.h"

namespace goniolux::display {

using core::Vec3;

Palette::Palette(const std::vector<Vec3>& srgb) : srgb_(srgb) {}

Vec3 Palette::at(double place) const {
  const double at = std::clamp(place, 0.0, 1.0) * static_cast<double>(srgb_.size() - 1);
  const auto i = std::min(static_cast<std::size_t>(at), srgb_.size() - 2);
  return fromSrgb(srgb_[i] + (srgb_[i + 1] - srgb_[i]) * (at - static_cast<double>(i)));
}

Palette paletteNamed(const std::string& name) {
  if (name == "grey") return Palette({Vec3(0), Vec3(255)});
  if (name == "false-colour")
    return Palette({{10, 10, 60},
                    {20, 60, 200},
                    {0, 170, 210},
                    {30, 180, 60},
                    {200, 215, 30},
                    {255, 170, 0},
                    {225, 40, 20},
                    {255, 215, 230}});
  // matplotlib's viridis (S. van der Walt, N. Smith; CC0) at every eighth
  if (name == "viridis")
    return Palette({{68, 1, 84},
                    {71, 44, 122},
                    {59, 81, 139},
                    {44, 113, 142},
                    {33, 144, 141},
                    {39, 173, 129},
                    {92, 200, 99},
                    {170, 220, 50},
                    {253, 231, 37}});
  throw core::InputError(
      {}, "palette",
      fmt::format("there is no palette '{}'{}", name, core::suggestion(name, {"false-colour", "viridis", "grey"})));
}

Vec3 fromSrgb(const Vec3& codes) {
  static const Device srgb = readDevice("srgb");
  static const core::Mat3 matrix = xyzFromRgb(srgb);
  Vec3 linear;
  for (int c = 0; c < 3; ++c) linear[c] = srgb.transfer[0].decode(codes[c] / 255);
  return matrix * linear;
}

Vec3 paletteWhite() {
  return fromSrgb(Vec3(255));
}

}  // namespace goniolux::display
