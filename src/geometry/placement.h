// Placements of canonical quadric patches (geometry/shape.h): affine maps from canonical to object space, and back.
#pragma once

#include "core/vector.h"
#include "geometry/shape.h"

namespace goniolux::geometry {

/// Maps the canonical z axis from 0 to 1 onto the segment base..base + axis and the unit circle onto a circle of
/// `radius` perpendicular to it. For a disc pass a unit axis. Right-handed.
core::Mat4 placementAlong(const core::Vec3& base, const core::Vec3& axis, double radius);

QuadricPatch makeDiscPatch(const core::Vec3& center, const core::Vec3& normal, double radius, std::uint32_t part);
QuadricPatch makeSpherePatch(const core::Vec3& center, double radius, std::uint32_t part);
QuadricPatch makeCylinderPatch(const core::Vec3& base, const core::Vec3& top, double radius, std::uint32_t part);
/// Frustum side; at least one radius above 0. The wider end becomes the canonical end of radius 1.
QuadricPatch makeConePatch(const core::Vec3& base, const core::Vec3& top, double baseRadius, double topRadius,
                           std::uint32_t part);

}  // namespace goniolux::geometry
