// Crossing: how a ray passes a place: the gap across it, and how the ray's start changes that.
#pragma once

#include <cmath>

#include "core/vector.h"

namespace goniolux::solver {

/// Two equations in the plane across a ray: the gap to a place, and its derivatives by the two angles of the start.
struct Crossing {
  core::Vec2 byU{0}, byV{0}, error{0};
  [[nodiscard]] double determinant() const { return byU.x * byV.y - byV.x * byU.y; }
  [[nodiscard]] core::Vec2 solution() const {
    const double d = determinant();
    return {(error.x * byV.y - byV.x * error.y) / d, (byU.x * error.y - error.x * byU.y) / d};
  }
};

inline Crossing crossingAt(const core::Vec3& place, const core::Vec3& origin, const core::Vec3& along,
                           const core::Vec3 (&originBy)[2], const core::Vec3 (&alongBy)[2], double t) {
  core::Vec3 a, b;
  core::perpendiculars(along, a, b);
  const core::Vec3 error = place - origin - along * t, u = originBy[0] + alongBy[0] * t,
                   v = originBy[1] + alongBy[1] * t;
  return {{glm::dot(u, a), glm::dot(u, b)}, {glm::dot(v, a), glm::dot(v, b)}, {glm::dot(error, a), glm::dot(error, b)}};
}

}  // namespace goniolux::solver
