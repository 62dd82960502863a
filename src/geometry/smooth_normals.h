// Smooth normals: what makes flat triangles look round in pictures. Photometric numbers never see them
// (docs/decisions/0011-smooth-normals.md).
#pragma once

#include "geometry/shape.h"

namespace goniolux::geometry {

/// Fills Mesh::smoothNormals. A corner's normal is the mean of the faces about its vertex, each by its angle there
/// (G. Thuermer and C. Wuethrich, "Computing vertex normals from polygonal facets", Journal of Graphics Tools 3(1),
/// 1998), of those faces that bend from the corner's own by less than `crease` (radians): sharper edges stay edges.
/// Vertices must be shared (mergeVertices).
void addSmoothNormals(Mesh& mesh, double crease);

}  // namespace goniolux::geometry
