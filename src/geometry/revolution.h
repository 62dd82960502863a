// Revolution: a profile turned about an axis, e.g. a reflector, a lens, a vase. A polyline is intersected exactly, as
// cone frusta, cylinders and rings; a spline is cut into frusta to a stated chord error (docs/methods/geometry.md).
#pragma once

#include <vector>

#include "geometry/objects.h"

namespace goniolux::geometry {

/// Points (r, z) of the profile, m: r >= 0 from the axis, z along it from `center`. One part, "surface". The front is
/// on the right of the way along the profile, seen with r to the right and z up: outside for a profile that goes up.
/// Closed when the profile begins and ends on the axis or where it began; then outward whatever its direction. Throws
/// std::invalid_argument with the point's number (from 1) when fewer than two points differ, a radius is negative, two
/// neighbours coincide or the profile crosses or touches itself.
Shape makeRevolution(const std::vector<core::Vec2>& profile, const core::Vec3& center, const core::Vec3& axis);

/// The points of a smooth curve through `points` (centripetal Catmull-Rom; perpendicular to the axis where it meets it,
/// closed smoothly where it ends where it began), so close that the polyline is nowhere farther from it than
/// `chordError`, m. Throws std::invalid_argument when the curve leaves r >= 0 between two points, or
/// `chordError` is so small that more than 1000 points would be needed between two.
std::vector<core::Vec2> splineProfile(const std::vector<core::Vec2>& points, double chordError);

ObjectType revolutionType();

}  // namespace goniolux::geometry
