// The key "transform" of an object: moves, turns and scalings.
#pragma once

#include "core/document.h"
#include "core/vector.h"
#include "project/reading.h"

namespace goniolux::project {

/// Object -> world, metres. The steps are applied in the order of the list, each in world axes: the first acts on the
/// object as it is drawn, the next on the result.
core::Mat4 readTransform(const core::Value& steps, Reading& reading);

/// Rotation by an angle in radians, right-handed about a unit axis through the origin (Rodrigues' formula).
core::Mat3 rotation(const core::Vec3& axis, double angle);

}  // namespace goniolux::project
