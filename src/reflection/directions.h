// Directions over the hemisphere, in the local frame of a hit (z = normal).
#pragma once

#include <algorithm>
#include <cmath>

#include "core/vector.h"

namespace goniolux::reflection {

/// Density cos / pi per sr (Malley): uniform over the disc, lifted.
inline core::Vec3 cosineDirection(const core::Vec2& u) {
  const double r = std::sqrt(u.x), angle = 2 * core::pi * u.y;
  return {r * std::cos(angle), r * std::sin(angle), std::sqrt(std::max(0.0, 1 - u.x))};
}

/// Decides with probability p by a number that remains usable: u.x is stretched over what is left. True: the first.
inline bool split(double p, core::Vec2& u) {
  if (u.x < p) {
    u.x = std::min(u.x / p, 1 - 1e-16);
    return true;
  }
  u.x = p < 1 ? std::min((u.x - p) / (1 - p), 1 - 1e-16) : 0.0;
  return false;
}

}  // namespace goniolux::reflection
