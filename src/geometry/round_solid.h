// What cylinder and cone share: an axis given by two end points or by base, height and direction, and optional caps.
#pragma once

#include <vector>

#include "core/parameter.h"
#include "geometry/shape.h"

namespace goniolux::geometry {

enum class Caps { none, bottom, top, both };

/// A right circular cylinder or frustum from `base` to `top` with parts "side", "bottom", "top" (a cap exists where its
/// radius is above 0 and `caps` has it); closed when nothing is open. Throws std::invalid_argument when base and top
/// coincide, or both radii are 0.
Shape makeRoundSolid(const core::Vec3& base, const core::Vec3& top, double baseRadius, double topRadius, Caps caps);

/// The end points that the keys `base`, `top` or `height` with `axis` give.
struct Axis {
  core::Vec3 base, top;
};
Axis axisArgument(const core::Arguments& arguments);
Caps capsArgument(const core::Arguments& arguments);

std::vector<core::Parameter> axisParameters();
core::Parameter capsParameter();

}  // namespace goniolux::geometry
