// Receiver: a small body that light falls on, and how its mean illuminance answers to light from a direction.
//
// Each of these illuminances is the mean over the body's surface of the illuminance on the plane that touches it there
// (CIE S 017, 17-21-060 ff.): so a normal chosen evenly over the body turns any of them into the planar one.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/vector.h"

namespace goniolux::solver {

enum class ReceiverBody { plane, cylinder, halfCylinder, hemisphere, sphere };

struct Receiver {
  core::Vec3 point, normal;  ///< unit: of the plane; where half cylinder and hemisphere face
  ReceiverBody body = ReceiverBody::plane;
  core::Vec3 axis{0, 0, 1};  ///< unit, of cylinder and half cylinder; perpendicular to the half cylinder's normal
  bool directLight = true;   ///< false: without the light that comes straight from the luminaires

  [[nodiscard]] bool isPlane() const { return body == ReceiverBody::plane; }

  /// Illuminance over the illuminance on a plane that faces the light, which comes from the unit `direction`.
  [[nodiscard]] double response(const core::Vec3& direction) const {
    switch (body) {
      case ReceiverBody::plane:
        return std::max(0.0, glm::dot(normal, direction));
      case ReceiverBody::cylinder:
        return acrossAxis(direction) / core::pi;
      case ReceiverBody::halfCylinder:
        return (acrossAxis(direction) + glm::dot(normal, direction)) / core::pi;
      case ReceiverBody::hemisphere:
        return 0.25 * (1 + glm::dot(normal, direction));
      case ReceiverBody::sphere:
        return 0.25;
    }
    return 0;
  }

  /// A normal of the body's surface, evenly over its area by u in [0, 1)^2.
  [[nodiscard]] core::Vec3 surfaceNormal(const core::Vec2& u) const {
    const double z = body == ReceiverBody::hemisphere ? u.y : 1 - 2 * u.y;
    const double r = std::sqrt(std::max(0.0, 1 - z * z)), turn = 2 * core::pi * u.x;
    core::Vec3 x, y;
    switch (body) {
      case ReceiverBody::plane:
        break;
      case ReceiverBody::cylinder:
        core::perpendiculars(axis, x, y);
        return x * std::cos(turn) + y * std::sin(turn);
      case ReceiverBody::halfCylinder:
        return normal * std::sin(0.5 * turn) + glm::cross(axis, normal) * std::cos(0.5 * turn);
      case ReceiverBody::hemisphere:
      case ReceiverBody::sphere:
        core::perpendiculars(normal, x, y);
        return (x * std::cos(turn) + y * std::sin(turn)) * r + normal * z;
    }
    return normal;
  }

 private:
  /// Sine of the angle to the axis.
  [[nodiscard]] double acrossAxis(const core::Vec3& direction) const {
    return glm::length(glm::cross(axis, direction));
  }
};

}  // namespace goniolux::solver
