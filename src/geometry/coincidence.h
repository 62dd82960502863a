// Faces of different objects that lie in one another: which of them a ray meets is chance.
#pragma once

#include <cstdint>
#include <vector>

#include "core/vector.h"

namespace goniolux::geometry {

/// A triangle in the world, with the side (or sides) that light reaches.
struct VisibleFace {
  core::Vec3 a{0}, b{0}, c{0};
  core::Vec3 normal{0};      ///< unit; of the visible side
  bool bothSides = false;    ///< of an open surface
  std::uint32_t object = 0;  ///< faces of the same object are not compared
  std::uint32_t finish = 0;  ///< nor of the same finish: light is the same whichever it meets
};

struct Coincidence {
  std::uint32_t first = 0, second = 0;  ///< objects, first < second
  core::Vec3 place{0};                  ///< a point that both cover
  core::Vec3 normal{0};                 ///< unit; of the first object's visible side
};

/// One finding for each pair of objects with faces in the same plane (within `tolerance`, m) that overlap by more than
/// `tolerance` and are seen from the same side. A solid that stands on another is none: its face and the one that it
/// hides look at each other. Cost O(n log n + pairs in the same plane).
std::vector<Coincidence> coincidentFaces(const std::vector<VisibleFace>& faces, double tolerance);

}  // namespace goniolux::geometry
