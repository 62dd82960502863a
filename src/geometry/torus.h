// Torus: a ring of round section, intersected exactly.
#pragma once

#include "geometry/objects.h"

namespace goniolux::geometry {

/// One part, "surface"; closed, outward. `axis` (any length but 0) stands upright on the ring's plane. Throws
/// std::invalid_argument unless 0 < tubeRadius < ringRadius.
Shape makeTorus(const core::Vec3& center, const core::Vec3& axis, double ringRadius, double tubeRadius);

ObjectType torusType();

}  // namespace goniolux::geometry
