// Triangles that stand for an exactly intersected patch: for programs that know only triangles, for drawings, and as an
// independent twin in tests. Vertices lie on the surface; the error falls with the square of `sides`.
#pragma once

#include "geometry/shape.h"

namespace goniolux::geometry {

/// The patch in object space as triangles whose front is the patch's front. Round patches are cut into `sides` (3 or
/// more) round the axis, a quadric into cells of 2/sides of its box. All triangles have the patch's part.
Mesh tessellate(const QuadricPatch& patch, int sides);

/// The whole shape: its triangles and those of its patches. Neighbouring patches need not share vertices.
Mesh tessellate(const Shape& shape, int sides);

}  // namespace goniolux::geometry
