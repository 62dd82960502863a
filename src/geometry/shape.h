// Shape: what an object manager hands over: triangles, exactly intersected patches, or both, in the object's own space
// (metres).
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "core/vector.h"

namespace goniolux::geometry {

/// Triangles. `parts[i]` is the index into Shape::partNames of triangle i. Counter-clockwise seen from outside.
struct Mesh {
  std::vector<core::Vec3> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::uint32_t> parts;
  /// (u, v) of each triangle's corners for textures, where the shape or its file has them; else empty
  /// (geometry/texture_coordinates.h).
  std::vector<std::array<glm::vec2, 3>> coordinates = {};
  /// Normals of each triangle's corners that make it look round in pictures (geometry/smooth_normals.h); else empty.
  std::vector<std::array<core::Vec3f, 3>> smoothNormals = {};
};

/// A bounded surface in canonical space, placed by an affine map and intersected exactly in canonical space: quadrics
/// in closed form, the torus by a bracketed root finder. disc:     ratio^2 <= x^2 + y^2 <= 1, z = 0, normal +z (a ring
/// when `ratio` is above 0) sphere:   x^2 + y^2 + z^2 = 1 cylinder: x^2 + y^2 = 1, 0 <= z <= 1 (side only) cone: x^2 +
/// y^2 = (1 + (ratio - 1) z)^2, 0 <= z <= 1 (side only; radius 1 at z = 0, `ratio` at z = 1) torus:    (sqrt(x^2 + y^2)
/// - 1)^2 + z^2 = ratio^2, ratio < 1 quadric:  p^T form p = 0 for p = (x, y, z, 1), within -1 <= x, y, z <= 1; its
/// front is where the form grows
struct QuadricPatch {
  enum class Kind { disc, sphere, cylinder, cone, torus, quadric };
  Kind kind = Kind::disc;
  double ratio = 0;
  core::Mat4 placement{1.0};  ///< canonical -> object
  std::uint32_t part = 0;
  bool turned = false;   ///< its front is the other side: towards the axis or the middle
  bool isFacet = false;  ///< one of many that stand for a smooth surface: its rims are no edges of the object
  core::Mat4 form{0.0};  ///< quadric only: symmetric, the largest element of the order of 1
};

struct Shape {
  std::vector<std::string> partNames;  ///< names that "materials" may use; at least one
  Mesh mesh;
  std::vector<QuadricPatch> patches;
  bool closed = false;    ///< bounds a volume: has an inside
  double chordError = 0;  ///< m; largest distance between the true surface and its triangles
  /// Names from a file that stand for several parts (a group with several materials), as ObjectType::partGroups do.
  std::map<std::string, std::vector<std::string>> partGroups = {};
  std::vector<std::string> remarks = {};  ///< what a designer should know: a reader passes them on as warnings
};

}  // namespace goniolux::geometry
