// Surface detail: what textures, reliefs and smooth normals make of a place of the world.
#pragma once

#include "scene/world.h"
#include "texture/mixture.h"
#include "texture/projection.h"

namespace goniolux::scene {

/// A place of the world's surfaces. World frame.
struct SurfacePoint {
  core::Vec3 position{0};  ///< on the surface, double precision
  core::Vec3 normal{0};    ///< unit geometric normal, outward by winding (not turned towards the ray)
  std::uint32_t surface = none;
  /// Triangle index, or number of triangles + patch index; none on an instanced mesh.
  std::uint32_t primitive = 0;
  std::uint32_t mesh = none;       ///< on an instanced mesh: index into World::instanced
  std::uint32_t place = 0;         ///< then: of InstancedMesh::places
  std::uint32_t meshTriangle = 0;  ///< then: of InstancedMesh::triangles
};

/// What the surface says of `at`, a place on it or beside it in its plane. It must be detailed (Surface::isDetailed).
texture::SurfacePlace placeOn(const World& world, const SurfacePoint& point, const core::Vec3& at);

/// Of which components a textured finish is made at a point.
texture::Mixture mixtureAt(const World& world, const SurfacePoint& point);

/// The unit normal that the surface shows in pictures, on the side of `facing` (the geometric normal towards the eye)
/// and at least a little towards `out`, which points to the eye; `facing` where there is nothing to show.
core::Vec3 shownNormal(const World& world, const SurfacePoint& point, const core::Vec3& facing, const core::Vec3& out);

}  // namespace goniolux::scene
