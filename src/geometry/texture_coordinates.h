// Texture coordinates: the (u, v) of a surface's places that a texture with "mapping": "uv" is laid by.
//
// | surface | u | v |
// |---|---|---|
// | rectangle, parametric patch | along the first edge or parameter, 0..1 | along the second |
// | mesh whose file has them | as in the file | as in the file, upwards |
// | other triangles | across the shape's box along the first axis that the face runs along, 0..1 | along the second |
// | sphere | longitude / 360 degrees | latitude, 0 at the lower pole, 1 at the upper |
// | cylinder, cone | angle / 360 degrees | height, 0..1 |
// | disc | angle / 360 degrees | distance from the middle, 0..1 |
// | torus | angle of the ring / 360 degrees | angle of the tube / 360 degrees |
// | quadric | as other triangles, across its box | |
#pragma once

#include <array>

#include "geometry/bounds.h"
#include "geometry/shape.h"

namespace goniolux::geometry {

/// Of a canonical point on a patch (geometry/shape.h).
core::Vec2 surfaceCoordinates(const QuadricPatch& patch, const core::Vec3& canonical);

/// Of a triangle's corners; `box`: bounds of the mesh's shape, object space.
std::array<core::Vec2, 3> cornerCoordinates(const Mesh& mesh, const Bounds& box, std::size_t triangle);

}  // namespace goniolux::geometry
