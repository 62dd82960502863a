// Disc: a flat circular surface, intersected exactly.
#pragma once

#include "geometry/objects.h"

namespace goniolux::geometry {

/// One part, "surface"; the front is where `normal` (any length but 0) points.
Shape makeDisc(const core::Vec3& center, const core::Vec3& normal, double radius);

ObjectType discType();

}  // namespace goniolux::geometry
