// Meshes as Wavefront OBJ text.
#pragma once

#include <string>

#include "geometry/shape.h"

namespace goniolux::geometry {

/// The triangles in metres, z up; parts as materials ("usemtl"), in their order. Coordinates, also those of textures,
/// read back the same.
std::string objText(const Mesh& mesh, const std::vector<std::string>& partNames);

}  // namespace goniolux::geometry
