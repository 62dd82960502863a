// Rectangle: a flat, open surface given as grids are: a corner and two full edges.
#pragma once

#include "geometry/objects.h"

namespace goniolux::geometry {

/// Corners origin, origin + u, origin + u + v, origin + v; the front is where u x v points. One part, "surface". Throws
/// std::invalid_argument unless the edges are longer than 0 and perpendicular within 0.1 degrees.
Shape makeRectangle(const core::Vec3& origin, const core::Vec3& u, const core::Vec3& v);

ObjectType rectangleType();

}  // namespace goniolux::geometry
