// Points of surfaces by chance: where a ray begins that is to leave a surface, an element of one that emits.
// Every object type, under every affine map: a shape is triangles and canonical patches (geometry/shape.h), and each of
// these knows its points. Immutable, thread safe.
#pragma once

#include <cstdint>
#include <vector>

#include "core/random.h"
#include "core/vector.h"
#include "geometry/shape.h"

namespace goniolux::geometry {

/// A point of a canonical patch, and the canonical area that it stands for: the inverse of its density.
struct PatchPoint {
  core::Vec3 position, normal;  ///< the normal of unit length, on the patch's front
  double area = 0;              ///< 0: these numbers have no point (quadrics only)
};

/// The point of `u` in [0, 1)^2; neighbours in u are neighbours on the patch but for quadrics. Its area is the same for
/// all u on discs, spheres, cylinders and cones; on a torus it is larger outside. A quadric's points are where lines
/// along the axes of its cube meet it: an element with normal n is met in proportion to |n_x| + |n_y| + |n_z|.
PatchPoint patchPoint(const QuadricPatch& patch, const core::Vec2& u);

/// The largest area of a patchPoint().
double largestPatchPointArea(const QuadricPatch& patch);

/// The cofactor matrix: takes canonical area vectors to mapped ones. det(M) M^-T, also where M is singular.
core::Mat3 cofactor(const core::Mat3& m);

struct SurfacePlace {
  core::Vec3 position, normal;  ///< of unit length, outwards where the shape is closed
  std::uint32_t part = 0;       ///< index into Shape::partNames
};

/// Points spread evenly by area over a placed shape, however unevenly its map stretches it: candidates that stand for
/// too little area are rejected.
class SurfacePoints {
 public:
  /// Throws std::invalid_argument when the shape has no area. The shape must outlive this.
  explicit SurfacePoints(const Shape& shape, const core::Mat4& transform = core::Mat4(1.0));

  [[nodiscard]] SurfacePlace sample(core::Sampler& random) const;
  /// Of any sample, 1/m^2: one over the area, as exact as geometry::area.
  [[nodiscard]] double density() const { return density_; }

 private:
  /// A triangle (index) or, from `mesh.triangles.size()` on, a patch; `most`: m^2 that a point of it can stand for.
  struct Piece {
    core::Mat4 map;    ///< canonical -> world; of triangles: the shape's
    core::Mat3 areas;  ///< cofactor of the map
    double most = 0;
  };
  const Shape& shape_;
  std::vector<Piece> patches_;
  core::Mat4 transform_;
  std::vector<double> cumulative_;  ///< of `most`, over triangles and then patches
  double sign_ = 1, density_ = 0;
};

}  // namespace goniolux::geometry
