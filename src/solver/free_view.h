// FreeView: proves that nothing stands between a point and a box, so that no shadow ray is needed.
//
// The light that a point gets from an opening passes through the convex hull of the point and the opening's bounding
// box, the shaft (E. Haines and J. Wallace, "Shaft culling for efficient ray-cast radiosity", Eurographics Workshop on
// Rendering 1991). A surface that lies outside one of the shaft's planes, or has the whole shaft on one side of its own
// plane, cannot stand in the way. The test errs on one side only: `true` is a proof, `false` means "maybe not".
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/bounds.h"
#include "scene/world.h"

namespace goniolux::solver {

class FreeView {
 public:
  explicit FreeView(const scene::World& world);

  /// Nothing but the surfaces of emitter `own` itself lies between `point` and `target`. World frame.
  [[nodiscard]] bool isFree(const core::Vec3& point, const geometry::Bounds& target, std::uint32_t own) const;

 private:
  struct Node {
    geometry::Bounds box;
    std::uint32_t first = 0,
                  count = 0;  ///< leaf: blockers_[first ..]; inner (count 0): children first, first+1
  };
  class Shaft;
  /// What may stand in the way, in the order of the leaves.
  struct Blocker {
    geometry::Bounds box;
    core::Vec3 normal{0};  ///< unit normal of a triangle; 0: only its box is looked at (patches, instances)
    double offset = 0;     ///< dot(normal, x) in its plane
    std::array<core::Vec3, 3> corners{};
    std::uint32_t emitter = scene::none;  ///< that it belongs to
  };

  void split(std::uint32_t node, std::uint32_t first, std::uint32_t count, const std::vector<geometry::Bounds>& boxes);

  double tolerance_;
  std::vector<std::uint32_t> order_;  ///< primitives: triangles, then patches, then instances
  std::vector<Node> nodes_;
  std::vector<Blocker> blockers_;
};

}  // namespace goniolux::solver
