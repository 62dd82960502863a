// Where a ray meets a canonical patch (geometry/shape.h), in double precision: quadrics in closed form, the torus by a
// bracketed root finder.
// Everything here is in the patch's canonical space: map a ray with the inverse of (transform * placement); `t` is the
// same in both spaces, because the map is affine and directions need no unit length. Thread-safe: no state.
#pragma once

#include "core/vector.h"
#include "geometry/bounds.h"
#include "geometry/shape.h"

namespace goniolux::geometry {

/// The smallest t with tMin < t < tMax at which origin + t direction lies on the patch; false when there is none. A ray
/// that lies in the surface (parallel to a disc's plane, to a cylinder's axis) misses it. Rims have a slack of 1e-9
/// (canonical), so that caps and sides overlap and no ray slips between them. The point origin + t direction is within
/// a few units in the last place of max(1, |origin|) of the surface, also for origins many radii away and for grazing
/// rays; at a tangent t itself is only as sharp as the geometry allows (square root of that).
bool intersect(const QuadricPatch& patch, const core::Vec3& origin, const core::Vec3& direction, double tMin,
               double tMax, double& t);

/// The most often that a line meets a patch.
inline constexpr int mostCrossings = 4;

/// All crossings with tMin < t < tMax in ascending order: returns how many were written to `t`.
int intersectAll(const QuadricPatch& patch, const core::Vec3& origin, const core::Vec3& direction, double tMin,
                 double tMax, double (&t)[mostCrossings]);

/// Outward normal (front normal of a disc; the other way for a turned patch) at a canonical point on the patch, not of
/// unit length, never zero. To object
/// or world space: multiply by the inverse transpose of the map's linear part, then normalise.
core::Vec3 canonicalNormal(const QuadricPatch& patch, const core::Vec3& point);

/// Tight bounding box of the patch (of a quadric: its box) under `transform * patch.placement`.
Bounds boundsOf(const QuadricPatch& patch, const core::Mat4& transform = core::Mat4(1.0));

}  // namespace goniolux::geometry
