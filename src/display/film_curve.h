// Characteristic curves of films: tables of log exposure and density, straight between and beyond their points.
#pragma once

#include <algorithm>

#include "display/film.h"

namespace goniolux::display {

/// Density at a log exposure.
inline double densityAt(const Film::Curve& curve, double logExposure) {
  auto above = std::lower_bound(curve.begin(), curve.end(), logExposure,
                                [](const auto& point, double value) { return point.first < value; });
  above = std::clamp(above, curve.begin() + 1, curve.end() - 1);
  const auto& [x0, y0] = *(above - 1);
  const auto& [x1, y1] = *above;
  return y0 + (logExposure - x0) / (x1 - x0) * (y1 - y0);
}

/// Log exposure that gives a density.
inline double exposureFor(const Film::Curve& curve, double density) {
  auto above = std::lower_bound(curve.begin(), curve.end(), density,
                                [](const auto& point, double value) { return point.second < value; });
  above = std::clamp(above, curve.begin() + 1, curve.end() - 1);
  const auto& [x0, y0] = *(above - 1);
  const auto& [x1, y1] = *above;
  return x0 + (density - y0) / (y1 - y0) * (x1 - x0);
}

}  // namespace goniolux::display
