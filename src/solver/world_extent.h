// How large a world is.
#pragma once

#include "geometry/bounds.h"
#include "geometry/quadric_intersect.h"
#include "scene/world.h"

namespace goniolux::solver {

/// The area of all surfaces, m2 (of quadric patches: of half their bounding box, roughly).
inline double areaOf(const scene::World& world) {
  double area = 0;
  for (const auto& t : world.triangles)
    area += 0.5 * glm::length(glm::cross(world.vertices[t[1]] - world.vertices[t[0]],
                                         world.vertices[t[2]] - world.vertices[t[0]]));
  for (const scene::PlacedPatch& patch : world.patches) {
    const geometry::Bounds b = geometry::boundsOf(patch.patch);
    const core::Vec3 d = b.max - b.min;
    area += d.x * d.y + d.y * d.z + d.z * d.x;
  }
  for (const geometry::Bounds& b : scene::instanceBounds(world)) {
    const core::Vec3 d = b.max - b.min;
    area += d.x * d.y + d.y * d.z + d.z * d.x;
  }
  return area;
}

/// The box of all surfaces.
inline geometry::Bounds boundsOf(const scene::World& world) {
  geometry::Bounds box;
  for (const core::Vec3& v : world.vertices) box.add(v);
  for (const scene::PlacedPatch& patch : world.patches) {
    const geometry::Bounds b = geometry::boundsOf(patch.patch);
    box.add(b.min);
    box.add(b.max);
  }
  for (const geometry::Bounds& b : scene::instanceBounds(world)) box.add(b);
  return box;
}

}  // namespace goniolux::solver
