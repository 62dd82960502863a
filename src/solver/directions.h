// Directions about a normal, as paths choose them.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/vector.h"

namespace goniolux::solver {

/// A frame with its z along the unit `normal`.
inline core::Frame frameAbout(const core::Vec3& normal) {
  core::Frame frame;
  frame.z = normal;
  core::perpendiculars(normal, frame.x, frame.y);
  return frame;
}

/// Density cos / pi over the hemisphere of the frame (Malley); u in [0, 1)^2.
inline core::Vec3 cosineDirection(const core::Frame& frame, const core::Vec2& u) {
  const double r = std::sqrt(u.x), angle = 2 * core::pi * u.y;
  return frame.toWorld({r * std::cos(angle), r * std::sin(angle), std::sqrt(std::max(0.0, 1 - u.x))});
}

}  // namespace goniolux::solver
