// OrbitCamera: where the 3-D view looks from: a point that it turns about, two angles and a distance; z stays up. World
// frame, metres.
#pragma once

#include "core/vector.h"

class vtkCamera;

namespace goniolux::gui {

class OrbitCamera {
 public:
  enum class Preset { perspective, plan, front, back, left, right };

  /// Shows the whole box in the preset's direction, for a picture `aspect` times as wide as high.
  void frame(const core::Vec3& low, const core::Vec3& high, Preset preset, double aspect);
  /// Stands at the eye and looks at the target; `verticalFov` in rad.
  void lookFrom(const core::Vec3& eye, const core::Vec3& target, double verticalFov);

  /// Moves of the mouse in pixels, right and down; `height`: of the view in pixels.
  void orbit(double right, double down, double height);
  void pan(double right, double down, double height);
  /// Closer by a factor above 1, towards `point`.
  void zoom(double factor, const core::Vec3& point);

  [[nodiscard]] bool isParallel() const { return parallel_; }
  [[nodiscard]] core::Vec3 eye() const { return target_ + distance_ * back(); }
  [[nodiscard]] const core::Vec3& target() const { return target_; }
  [[nodiscard]] core::Vec3 forward() const { return -back(); }
  [[nodiscard]] core::Vec3 up() const;
  [[nodiscard]] core::Vec3 right() const { return glm::cross(forward(), up()); }
  /// Metres that the view's height shows at the target's distance.
  [[nodiscard]] double span() const;
  void applyTo(vtkCamera& camera) const;

 private:
  [[nodiscard]] core::Vec3 back() const;

  core::Vec3 target_{0};
  double azimuth_ = -60 * core::degree, elevation_ = 35 * core::degree, distance_ = 10;
  double fov_ = 35 * core::degree;
  bool parallel_ = false;
};

}  // namespace goniolux::gui
