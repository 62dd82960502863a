// Tracer: the nearest hit of a ray, and whether two points see each other. The only room that knows Embree.
// World frame of scene::World, metres. Immutable once made; queries are thread safe.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "core/vector.h"
#include "scene/surface_detail.h"
#include "scene/world.h"

namespace goniolux::tracer {

struct Hit : scene::SurfacePoint {
  double distance = 0;
};

class Tracer {
 public:
  /// The world must outlive the tracer. Throws core::RunError when the acceleration structure cannot be built.
  explicit Tracer(const scene::World& world);
  ~Tracer();
  Tracer(const Tracer&) = delete;
  Tracer& operator=(const Tracer&) = delete;

  /// Nearest hit along a unit direction; false: none.
  bool intersect(const core::Vec3& origin, const core::Vec3& direction, Hit& hit) const;
  /// True when something lies within `distance` along a unit direction.
  [[nodiscard]] bool occluded(const core::Vec3& origin, const core::Vec3& direction, double distance) const;

  /// A start for rays that leave a surface at `point` on the side of `normal`: moved by a distance that scales with the
  /// rounding of single-precision coordinates there (no fixed epsilon).
  [[nodiscard]] core::Vec3 leave(const core::Vec3& point, const core::Vec3& normal) const {
    return point + normal * offset_;
  }
  /// `point` on a surface with this normal, moved along it until no other surface is nearer than two offsets: in a
  /// corner single precision would put starts beyond the next wall.
  [[nodiscard]] core::Vec3 clearOfCorners(core::Vec3 point, const core::Vec3& normal) const;
  /// How far before an aimed-at point on a surface a shadow ray ends: the rounding of both ends.
  [[nodiscard]] double slack() const { return 2 * offset_; }

 private:
  void finishInstanceHit(std::uint32_t instance, std::uint32_t triangle, Hit& hit) const;

  struct Embree;
  std::unique_ptr<Embree> embree_;
  const scene::World& world_;
  std::vector<core::Vec3> triangleNormals_;
  struct Instance {
    std::uint32_t mesh, place;
  };
  std::vector<Instance> instances_;
  double offset_;
};

/// The tracing library and its instruction set, e.g. "Embree 3.13.5", for provenance.
std::string tracingLibrary();

}  // namespace goniolux::tracer
