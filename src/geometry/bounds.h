// Bounds: an axis-aligned bounding box; empty until something is added.
#pragma once

#include <limits>

#include "core/vector.h"

namespace goniolux::geometry {

struct Bounds {
  core::Vec3 min{std::numeric_limits<double>::infinity()};
  core::Vec3 max{-std::numeric_limits<double>::infinity()};

  [[nodiscard]] bool empty() const { return !(min.x <= max.x && min.y <= max.y && min.z <= max.z); }
  [[nodiscard]] core::Vec3 center() const { return 0.5 * (min + max); }
  [[nodiscard]] core::Vec3 extent() const { return max - min; }
  void add(const core::Vec3& point) {
    min = glm::min(min, point);
    max = glm::max(max, point);
  }
  void add(const Bounds& other) {
    min = glm::min(min, other.min);
    max = glm::max(max, other.max);
  }
  [[nodiscard]] bool contains(const core::Vec3& p, double margin = 0) const {
    return p.x >= min.x - margin && p.x <= max.x + margin && p.y >= min.y - margin && p.y <= max.y + margin &&
           p.z >= min.z - margin && p.z <= max.z + margin;
  }
};

}  // namespace goniolux::geometry
