// Emission: rays that leave an emitter as its light does, for finding out where light lands. Deterministic; world
// frame.
#pragma once

#include <vector>

#include "core/vector.h"
#include "scene/world.h"

namespace goniolux::solver {

struct EmittedRay {
  core::Vec3 origin{0}, direction{0, 0, 1};
  double flux = 0;  ///< lm; its expectation over the choices is the emitter's flux
};

/// Directions of one emitter in proportion to its intensity, from a table that is finest about its aim.
class Emission {
 public:
  /// `far`: m, a distance from which every emitter is small. The source must outlive this.
  Emission(const scene::LightSource& source, double far);

  [[nodiscard]] EmittedRay ray(const core::Vec2& forDirection, const core::Vec2& forPlace) const;

 private:
  [[nodiscard]] double intensity(const core::Vec3& direction, const core::Vec2& place, core::Vec3& origin) const;

  const scene::LightSource& source_;
  core::Frame frame_;
  core::Vec3 center_{0};
  double far_;
  std::vector<double> cumulative_;  ///< over the table, up to 1
};

}  // namespace goniolux::solver
