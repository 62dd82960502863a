// Projection: how a pattern is laid on a surface. Object space, metres; angles in radians.
#pragma once

#include "core/vector.h"

namespace goniolux::texture {

/// What a surface says of one of its places.
struct SurfacePlace {
  core::Vec3 position{0};        ///< object space, m
  core::Vec3 normal{0, 0, 1};    ///< unit, object space
  core::Vec2 coordinates{0, 0};  ///< the surface's own (u, v): see geometry/texture_coordinates.h
};

/// A place as a pattern sees it, in repeats of the pattern.
struct Place {
  core::Vec2 flat{0, 0};  ///< u to the right, v up
  core::Vec3 solid{0};    ///< through the body, for what has no seams at edges: noise
};

struct Projection {
  enum class Mapping {
    box,  ///< along the axis that the surface faces most: x and y of floors, y and z or x and z of walls
    uv    ///< the surface's own coordinates
  };
  Mapping mapping = Mapping::box;
  core::Vec2 size{1, 1};   ///< of one repeat: m, or parts of the surface's own coordinates
  core::Vec2 shift{0, 0};  ///< in repeats
  double turn = 0;         ///< of the pattern, anticlockwise

  [[nodiscard]] Place at(const SurfacePlace& place) const;
};

}  // namespace goniolux::texture
