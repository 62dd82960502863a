// Mesh: triangles from a file (OBJ, PLY, STL, glTF). The importer library is used in mesh_import.cpp only.
#pragma once

#include <string>
#include <vector>

#include "core/vector.h"
#include "geometry/objects.h"

namespace goniolux::geometry {

/// Reads a mesh. `scale`: metres per unit of the file; `yIsUp`: the file's y axis becomes our z (x stays).
/// Parts are the file's materials and groups: a part is named by its material where it has one, else by its group;
/// where a material is used in several groups the parts are "group/material" and both names stand in Shape::partGroups.
/// A file without names has one part, "surface". Triangles without area are left out and counted in Shape::remarks.
/// Closed when every edge belongs to two triangles, after turning those that disagree with their neighbours; then
/// outward. Throws std::invalid_argument with file name and reason: unreadable, unknown format, damaged, coordinates
/// not finite, no triangles, or more than 20 million of them or 1 GB.
Shape importMesh(const std::string& file, double scale, bool yIsUp);

/// A picture that gives parts of a mesh their colour: OBJ's map_Kd, glTF's base colour.
struct MeshPicture {
  std::vector<std::string> parts;  ///< as importMesh() names them
  std::string file;                ///< where it is: beside the mesh, or what stands for it in messages
  std::string bytes;               ///< of a picture within the mesh file; else empty
  std::string extension;           ///< with its dot, lower case: .png, .jpg, .tif …
  core::Vec3 factor{1};            ///< linear red, green, blue that its values are to be multiplied by
  bool isMoved = false;            ///< the file turns, moves or repeats it on the surface, which is not read
};

/// The pictures of a mesh that importMesh() reads; a picture that several materials share, with the same factor, comes
/// once. Throws as importMesh() does.
std::vector<MeshPicture> meshPictures(const std::string& file);

ObjectType meshType();

}  // namespace goniolux::geometry
