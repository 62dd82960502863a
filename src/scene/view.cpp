#include "scene/view.h"

#include <algorithm>
#include <cmath>

namespace goniolux::scene {

using core::Vec3;

ViewRay rayThrough(const View& view, double x, double y) {
  const Vec3 forward = glm::normalize(view.target - view.eye);
  Vec3 right = glm::cross(forward, view.up);
  // Looking along `up`: any horizon will do.
  if (glm::length(right) < 1e-9) right = glm::cross(forward, std::abs(forward.x) < 0.9 ? Vec3(1, 0, 0) : Vec3(0, 1, 0));
  right = glm::normalize(right);
  const Vec3 up = glm::cross(right, forward);

  // Image plane coordinates: v from -1 (bottom) to 1 (top), u in the same unit.
  const double v = 1 - 2 * y / view.height;
  const double u = (2 * x - view.width) / view.height;
  ViewRay ray{view.eye, forward, true};
  switch (view.projection) {
    case View::Projection::perspective: {
      const double scale = std::tan(0.5 * view.verticalFov);
      ray.direction = glm::normalize(forward + (right * u + up * v) * scale);
      break;
    }
    case View::Projection::orthographic:
      ray.origin = view.eye + (right * u + up * v) * (0.5 * view.span);
      break;
    case View::Projection::fisheyeEquidistant:
    case View::Projection::fisheyeEquisolid: {
      const double r = std::hypot(u, v), half = 0.5 * view.verticalFov;
      if (r > 1) {
        ray.inside = false;
        break;
      }
      // equidistant: r ~ theta; equisolid: r ~ sin(theta / 2)
      const double theta = view.projection == View::Projection::fisheyeEquidistant
                               ? r * half
                               : 2 * std::asin(std::clamp(r * std::sin(0.5 * half), -1.0, 1.0));
      if (r > 0) ray.direction = forward * std::cos(theta) + (right * (u / r) + up * (v / r)) * std::sin(theta);
      break;
    }
  }
  return ray;
}

}  // namespace goniolux::scene
