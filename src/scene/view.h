// View: the viewing and image parameters of one picture.
#pragma once

#include <string>

#include "core/diagnostics.h"
#include "core/vector.h"

namespace goniolux::scene {

struct View {
  enum class Projection { perspective, orthographic, fisheyeEquidistant, fisheyeEquisolid };
  std::string name;
  core::Vec3 eye{0}, target{0}, up{0, 0, 1};
  Projection projection = Projection::perspective;
  double verticalFov = 60 * core::degree;  ///< rad, whole angle (perspective and fisheye)
  double span = 1;                         ///< m, height of the image plane (orthographic)
  int width = 640, height = 480;
  core::SourcePosition position;
};

/// A ray of the view through image coordinates x in [0, width), y in [0, height), y down. `inside` is false outside a
/// fisheye circle.
struct ViewRay {
  core::Vec3 origin, direction;
  bool inside = true;
};
ViewRay rayThrough(const View& view, double x, double y);

}  // namespace goniolux::scene
