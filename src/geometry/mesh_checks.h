// What triangles promise: no slivers without area, every edge shared by two, all turned the same way.
#pragma once

#include <cstddef>

#include "geometry/bounds.h"
#include "geometry/shape.h"

namespace goniolux::geometry {

/// True when the triangle has no usable normal: its height over the longest edge is below 1e-10 of that edge.
bool isDegenerate(const core::Vec3& a, const core::Vec3& b, const core::Vec3& c);

/// Drops triangles that name a vertex twice; returns how many.
std::size_t removeCollapsedTriangles(Mesh& mesh);
/// Drops degenerate triangles (collapsed ones included); returns how many.
std::size_t removeDegenerateTriangles(Mesh& mesh);

/// Vertices closer than `tolerance` (metres, on a grid of that pitch) become one: readers of formats that repeat each
/// vertex need it before edges can be compared. Triangles that collapse are left for removeDegenerateTriangles.
void mergeVertices(Mesh& mesh, double tolerance);

/// Edges by how many triangles share them.
struct EdgeReport {
  std::size_t boundary = 0;      ///< one triangle: a hole or a free border
  std::size_t nonManifold = 0;   ///< three or more triangles
  std::size_t inconsistent = 0;  ///< two triangles that run along it in the same direction
  std::size_t edges = 0;

  /// Every edge is shared by exactly two triangles that run along it in opposite directions.
  [[nodiscard]] bool watertight() const { return edges > 0 && boundary == 0 && nonManifold == 0 && inconsistent == 0; }
};
EdgeReport checkEdges(const Mesh& mesh);

/// Turns triangles so that neighbours agree and, where the mesh is watertight then, so that its volume is positive.
/// Returns the report afterwards. Meshes that agree already keep the sign of each of their shells (cavities).
EdgeReport orientOutward(Mesh& mesh);

/// Bounding box of the vertices that triangles use.
Bounds boundsOf(const Mesh& mesh);

/// Signed volume that a watertight mesh encloses: positive when its triangles turn counter-clockwise seen from outside.
double signedVolume(const Mesh& mesh);

}  // namespace goniolux::geometry
