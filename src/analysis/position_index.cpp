#include "analysis/position_index.h"

#include <algorithm>
#include <cmath>

namespace goniolux::analysis {

double positionIndex(const core::Vec3& forward, const core::Vec3& up, const core::Vec3& toSource) {
  // sigma: angle off the line of sight; tau: of the plane of source and line of sight from the vertical; degrees.
  const double sigma = std::acos(std::clamp(glm::dot(forward, toSource), -1.0, 1.0)) / core::degree;
  const core::Vec3 across = toSource - forward * glm::dot(forward, toSource);
  const double tau =
      std::acos(std::clamp(glm::dot(across, up) / std::max(glm::length(across), 1e-12), -1.0, 1.0)) / core::degree;
  return std::exp((35.2 - 0.31889 * tau - 1.22 * std::exp(-2 * tau / 9)) * 1e-3 * sigma +
                  (21 + 0.26667 * tau - 0.002963 * tau * tau) * 1e-5 * sigma * sigma);
}

}  // namespace goniolux::analysis
