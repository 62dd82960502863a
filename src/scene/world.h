// World: the environment as transport needs it: triangles and quadric patches in one frame, each with its finish, and
// the emitters.
//
// The frame is re-centred: world position = project position - origin, so that single precision serves far from the
// project's origin. Made once from an Environment, then read-only and shared by all threads.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/vector.h"
#include "emitter/emitter.h"
#include "geometry/bounds.h"
#include "geometry/shape.h"
#include "material/material.h"
#include "scene/environment.h"
#include "spectrum/spectral_distribution.h"

namespace goniolux::scene {

inline constexpr std::uint32_t none = 0xffffffffu;

/// What a ray finds where it hits: a finish, and the light that leaves by itself.
struct Surface {
  std::uint32_t material = none;  ///< index into World::materials
  std::uint32_t emitter = none;   ///< the luminaire opening that this is: index into World::emitters
  double luminance = 0;           ///< of an emitting finish, cd/m2 on both sides
  std::uint32_t spectrum = none;  ///< of that luminance: index into World::sourceSpectra
  std::uint32_t object = none;    ///< index into Environment::objects; none for a luminaire
  bool isDetailed = false;        ///< its finish has a texture or a relief, or it is to look round
  std::uint32_t frame = none;     ///< of a detailed one that is not instanced: index into World::frames
};

struct PlacedPatch {
  geometry::QuadricPatch patch;  ///< its placement is canonical -> world
  core::Mat4 toCanonical{1.0};
  std::uint32_t surface = 0;
};

/// What textures and smooth normals need of a triangle's corners; normals in object space, 0 where there are none.
struct Corners {
  std::array<glm::vec2, 3> coordinates{};
  std::array<core::Vec3f, 3> normals{};
};

/// A mesh that stands in many places but is held once. Vertices are about its own middle.
struct InstancedMesh {
  std::vector<core::Vec3> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::uint32_t> triangleSurfaces;
  std::vector<core::Mat4> places;  ///< mesh -> world
  core::Vec3 middle{0};            ///< object space
  std::vector<Corners> corners;    ///< of every triangle, or empty where no surface is detailed
};

struct LightSource {
  std::unique_ptr<emitter::Emitter> emitter;
  std::uint32_t spectrum = 0;             ///< index into World::sourceSpectra
  std::uint32_t luminaire = none;         ///< index into Environment::luminaires; none for an emitting surface
  bool hasGeometry = false;               ///< rays can hit it
  geometry::Bounds bounds{};              ///< of what emits
  std::vector<std::uint32_t> housings{};  ///< objects that do not shade it (scene/housing.h)
  /// A ray may come to its surface.
  [[nodiscard]] bool canBeMet() const { return hasGeometry && housings.empty(); }
};

struct World {
  core::Vec3 origin{0};  ///< project position of the world's zero
  double radius = 1;     ///< m, of the bounding sphere about zero
  std::vector<core::Vec3> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::uint32_t> triangleSurfaces;
  std::vector<std::uint32_t> triangleCorners;  ///< of each triangle: index into corners, or none; empty: none has any
  std::vector<Corners> corners;
  std::vector<core::Mat4> frames;  ///< world -> object
  std::vector<PlacedPatch> patches;
  std::vector<InstancedMesh> instanced;  ///< large arrays; not among `triangles`
  std::vector<Surface> surfaces;
  std::vector<material::Material> materials;
  std::vector<std::shared_ptr<const texture::Texture>> textures;
  std::vector<std::shared_ptr<const texture::Relief>> reliefs;
  std::vector<spectrum::SpectralDistribution> sourceSpectra;
  std::vector<LightSource> emitters;
  double chordError = 0;  ///< m, the largest of the shapes
};

/// Flattens the environment; only the triangles of objects in so many places that these would be more than 100 000
/// altogether stay instanced (not where their finish emits light). Luminaires that are switched off (flux 0) stay as
/// geometry and emit nothing. Zero-area triangles are left out. An opening that lies on a surface is moved towards its
/// aim by 2e-6 of the world's radius, so that it replaces it.
World buildWorld(const Environment& environment);

/// The box about each place of each instanced mesh, in their order.
std::vector<geometry::Bounds> instanceBounds(const World& world);

}  // namespace goniolux::scene
