// Triangulation of a plane polygon with holes by ear clipping with exact predicates: coordinates are compared on a grid
// of 2^-29 of the polygon's extent (2 nm on a metre), where cross products are exact in 64 bits. Vertices themselves do
// not move.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/vector.h"

namespace goniolux::geometry {

/// `rings[0]` is the outline, the others are holes; either direction. Returns counter-clockwise triangles whose indices
/// count through all rings in order. Every vertex is a corner of some triangle (also those in the middle of a straight
/// edge), so that neighbouring faces meet without gaps; areas add up exactly. Throws std::invalid_argument with a
/// sentence when a ring has fewer than three different corners or no area, edges cross or touch, or a hole is not
/// inside. Cost O(n^2).
std::vector<std::array<std::uint32_t, 3>> triangulate(const std::vector<std::vector<core::Vec2>>& rings);

/// Rings in space: the same on the plane that fits the outline (Newell's normal), counter-clockwise about it. `what`
/// names the polygon in messages, e.g. "the polygon". Throws also when a vertex is farther than 0.1 % of the extent
/// from the plane.
std::vector<std::array<std::uint32_t, 3>> triangulateInSpace(const std::vector<std::vector<core::Vec3>>& rings,
                                                             const std::string& what);

}  // namespace goniolux::geometry
