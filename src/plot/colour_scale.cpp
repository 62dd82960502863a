#include "plot/colour_scale.h"

#include <algorithm>
#include <cmath>

namespace goniolux::plot {

ColourScale::ColourScale(const PlanMap& map) {
  edges_.push_back(map.lowest);
  for (const double level : map.levels) {
    if (level > map.lowest && level < map.highest) edges_.push_back(level);
  }
  edges_.push_back(map.highest);

  const Palette* named = findPalette(map.palette);
  const Palette& palette = named ? *named : palettes().front();
  const std::size_t count = map.banded ? edges_.size() - 1 : 1024;
  for (std::size_t k = 0; k < count; ++k) {
    colours_.push_back(colourAt(palette, count == 1 ? 0.6 : static_cast<double>(k) / static_cast<double>(count - 1)));
  }
}

double ColourScale::fraction(double value) const {
  const auto above = std::upper_bound(edges_.begin(), edges_.end(), value);
  if (above == edges_.begin()) return 0;
  if (above == edges_.end()) return 1;
  const auto field = static_cast<double>(above - edges_.begin() - 1);
  const double low = *(above - 1), high = *above;
  return (field + (value - low) / (high - low)) / static_cast<double>(edges_.size() - 1);
}

Rgb ColourScale::atFraction(double fraction) const {
  const auto count = static_cast<double>(colours_.size());
  // The little extra: an edge belongs to the field above it, whatever the rounding.
  return colours_[static_cast<std::size_t>(std::clamp(std::floor(fraction * count + 1e-9), 0.0, count - 1))];
}

}  // namespace goniolux::plot
