// Parametric: Bezier and B-spline patches, cut into triangles to a stated chord error (docs/methods/geometry.md says
// why).
#pragma once

#include "geometry/objects.h"

namespace goniolux::geometry {

/// Patches with `control[p][i][j]`, each cut into the same number of triangles, so that patches that share an edge
/// share its points; no triangle is farther from its patch than `chordError` (m). One part, "surface". Triangles that
/// turn against their neighbours are turned; closed when every edge then belongs to two triangles. Throws
/// std::invalid_argument for rows of unequal length, fewer control points than degree + 1, or more than 4 million
/// triangles.
Shape makeParametric(const std::vector<std::vector<std::vector<core::Vec3>>>& control, int degreeU, int degreeV,
                     double chordError);

ObjectType parametricType();

}  // namespace goniolux::geometry
