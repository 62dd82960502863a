// Quadric: the surface of a general equation of second degree within a box, intersected exactly.
#pragma once

#include "geometry/objects.h"

namespace goniolux::geometry {

/// The points p of the box min..max with q^T form q = 0, where q = ((p - center) / size, 1) and `form` is symmetric.
/// One part, "surface"; the front is where the equation's left side grows. Closed when it is an ellipsoid wholly within
/// the box; what the box cuts is open. Throws std::invalid_argument when the box is empty, an argument is not finite,
/// or the box holds nothing of the surface.
Shape makeQuadric(const core::Mat4& form, const core::Vec3& center, double size, const core::Vec3& min,
                  const core::Vec3& max);

ObjectType quadricType();

}  // namespace goniolux::geometry
