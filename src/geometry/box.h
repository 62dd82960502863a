// Box: an axis-aligned solid between two corners; a room when its object faces inward.
#pragma once

#include "geometry/objects.h"

namespace goniolux::geometry {

/// Parts floor (z = min), ceiling (z = max), xmin, xmax, ymin, ymax; 12 triangles, outward. Throws
/// std::invalid_argument unless min < max in x, y and z.
Shape makeBox(const core::Vec3& min, const core::Vec3& max);

ObjectType boxType();

}  // namespace goniolux::geometry
