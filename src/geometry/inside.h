// Is a point inside a closed shape? Generalised winding number for triangles, signed crossings for quadric patches.
#pragma once

#include "geometry/bounds.h"
#include "geometry/shape.h"

namespace goniolux::geometry {

/// A closed shape placed in the world, made ready for many questions. Immutable, hence thread-safe. An open shape has
/// no inside. Costs one pass over the shape's faces for a point inside its bounding box. Refers to the shape, which
/// must outlive it: many places of a large mesh cost little.
class InsideTest {
 public:
  InsideTest(const Shape& shape, const core::Mat4& transform);
  InsideTest(Shape&& shape, const core::Mat4& transform) = delete;

  /// True when the point is inside and at least `margin` metres from the surface: a point on a desk's top is not inside
  /// the desk. Faces of the shape may overlap by rounding, the mesh may have cracks (Jacobson et al., "Robust
  /// Inside-Outside Segmentation using Generalized Winding Numbers", ACM TOG 32(4), 2013).
  [[nodiscard]] bool contains(const core::Vec3& point, double margin = 1e-6) const;

 private:
  struct Patch {
    QuadricPatch canonical;
    core::Mat4 toCanonical;
    core::Mat3 normalToWorld;  ///< of the canonical gradient; keeps its scale (inverse transpose)
  };
  [[nodiscard]] double meshWinding(const core::Vec3& point) const;
  [[nodiscard]] double patchWinding(const core::Vec3& point) const;
  [[nodiscard]] bool touchesMesh(const core::Vec3& point, double margin) const;
  [[nodiscard]] bool touchesPatch(const Patch& patch, const core::Vec3& point, double margin) const;

  [[nodiscard]] core::Vec3 corner(std::uint32_t vertex) const;  ///< world space

  const Mesh* mesh_ = nullptr;  ///< object space
  core::Mat4 toWorld_{1.0};
  double winding_ = 1;  ///< -1 where the transform mirrors
  std::vector<Patch> patches_;
  Bounds bounds_;
};

}  // namespace goniolux::geometry
