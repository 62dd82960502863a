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

std::optional<double> positionIndexInField(const core::Vec3& forward, const core::Vec3& up,
                                           const core::Vec3& toSource) {
  const double ahead = glm::dot(forward, toSource), height = glm::dot(up, toSource);
  const double aside = glm::dot(glm::cross(forward, up), toSource);
  // A hair more than the limits, so that rounding does not decide about luminaires that stand on them.
  constexpr double hair = 1 + 1e-9;
  if (!(ahead > 0) || std::abs(height) > 1.9 * ahead * hair || std::abs(aside) > 3 * ahead * hair) return std::nullopt;
  if (height >= 0) return positionIndex(forward, up, toSource);
  const double off = std::hypot(height, aside) / ahead;
  return 1 + (off < 0.6 ? 0.8 : 1.2) * off;
}

}  // namespace goniolux::analysis
