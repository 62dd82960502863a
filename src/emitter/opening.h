// Opening: the luminous opening of a luminaire as geometry, in the luminaire frame (C0, C90, aim). Lengths in metres.
#pragma once

#include "core/vector.h"

namespace goniolux::emitter {

/// The centre of the opening (of a volume: its centre) is the luminaire's position.
/// rectangle: length along C0, width along C90, perpendicular to the aim; disc: diameter; box: height along the aim;
/// cylinder: axis along the aim, caps included; tube: side only, along `axis`; line: along `axis`, no geometry.
struct Opening {
  enum class Shape { point, rectangle, disc, box, cylinder, sphere, tube, line };
  Shape shape = Shape::point;
  double length = 0, width = 0, height = 0, diameter = 0;
  core::Vec3 axis{1, 0, 0};  ///< tube and line: unit, WORLD direction (as in the project file)
};

}  // namespace goniolux::emitter
