// Polygon: a flat, open surface with any number of corners, concave or not, with holes.
#pragma once

#include "geometry/objects.h"

namespace goniolux::geometry {

/// One part, "surface"; the front is where the outline turns counter-clockwise. Throws std::invalid_argument as
/// triangulateInSpace does.
Shape makePolygon(const std::vector<core::Vec3>& vertices, const std::vector<std::vector<core::Vec3>>& holes = {});

ObjectType polygonType();

}  // namespace goniolux::geometry
