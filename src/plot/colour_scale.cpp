#include "plot/colour_scale.h"

#include <algorithm>
#include <cmath>

namespace goniolux::plot {

ColourScale::ColourScale(const PlanMap& map)
    : palette_(findPalette(map.palette) ? *findPalette(map.palette) : palettes().front()), banded_(map.banded) {
  edges_.push_back(map.lowest);
  for (const double level : map.levels) {
    if (level > map.lowest && level < map.highest) edges_.push_back(level);
  }
  edges_.push_back(map.highest);
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
  const auto fields = static_cast<double>(edges_.size() - 1);
  if (!banded_) return colourAt(palette_, fraction);
  if (fields < 2) return colourAt(palette_, 0.6);
  const double field = std::clamp(std::floor(fraction * fields + 1e-9), 0.0, fields - 1);
  return colourAt(palette_, field / (fields - 1));
}

}  // namespace goniolux::plot
