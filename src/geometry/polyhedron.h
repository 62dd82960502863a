// Polyhedron: flat faces over a common list of points.
#pragma once

#include "geometry/objects.h"

namespace goniolux::geometry {

/// One part, "surface". Faces are lists of indices into `vertices`, counted from 0; each face may be concave. Faces
/// that turn against their neighbours are turned; it is closed when every edge then belongs to exactly two faces.
/// Throws std::invalid_argument for an index out of range or a face as in triangulateInSpace, naming the face (from 1).
Shape makePolyhedron(const std::vector<core::Vec3>& vertices, const std::vector<std::vector<int>>& faces);

ObjectType polyhedronType();

}  // namespace goniolux::geometry
