// Measures of a placed shape: area, volume, bounds, coplanar faces. `transform` is object -> world (affine); results
// are in world units. Thread-safe: no state.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/bounds.h"
#include "geometry/shape.h"

namespace goniolux::geometry {

/// Area of one side, m^2. Triangles and discs exact under every affine map, curved patches under similarities; under
/// uneven scaling by quadrature (relative error below 1e-6 for scale ratios up to 10); quadrics always by quadrature
/// (below 1e-3).
double area(const Shape& shape, const core::Mat4& transform = core::Mat4(1.0));
/// The same for each part (index into Shape::partNames).
std::vector<double> partAreas(const Shape& shape, const core::Mat4& transform = core::Mat4(1.0));

/// Integral of the outward unit normal over the surface: zero for a closed shape.
core::Vec3 vectorArea(const Shape& shape, const core::Mat4& transform = core::Mat4(1.0));

/// Volume enclosed by a closed shape, m^3, exact under every affine map (quadrics: within 1e-3); negative when the
/// shape is turned inside out (the transform's own reflection does not count). Meaningless for open shapes.
double volume(const Shape& shape, const core::Mat4& transform = core::Mat4(1.0));

/// Tight bounding box.
Bounds bounds(const Shape& shape, const core::Mat4& transform = core::Mat4(1.0));

/// Triangles and disc patches (indices) that lie in the plane through `point` with unit `normal` (either way round):
/// all their corners, or the rim, are within `tolerance` metres of it. World space.
struct CoplanarFaces {
  std::vector<std::uint32_t> triangles, patches;
};
CoplanarFaces facesInPlane(const Shape& shape, const core::Mat4& transform, const core::Vec3& point,
                           const core::Vec3& normal, double tolerance);

}  // namespace goniolux::geometry
