#include "app/gui/room/orbit_camera.h"

#include <vtkCamera.h>

#include <algorithm>
#include <cmath>

namespace goniolux::gui {

using core::Vec3;

Vec3 OrbitCamera::back() const {
  return {std::cos(elevation_) * std::cos(azimuth_), std::cos(elevation_) * std::sin(azimuth_), std::sin(elevation_)};
}

Vec3 OrbitCamera::up() const {
  return {-std::sin(elevation_) * std::cos(azimuth_), -std::sin(elevation_) * std::sin(azimuth_), std::cos(elevation_)};
}

double OrbitCamera::span() const {
  return 2 * distance_ * std::tan(fov_ / 2);
}

void OrbitCamera::frame(const Vec3& low, const Vec3& high, Preset preset, double aspect) {
  constexpr double quarter = core::pi / 2;
  parallel_ = preset != Preset::perspective;
  fov_ = 35 * core::degree;
  azimuth_ = preset == Preset::perspective ? -62 * core::degree
             : preset == Preset::back      ? quarter
             : preset == Preset::left      ? core::pi
             : preset == Preset::right     ? 0
                                           : -quarter;
  elevation_ = preset == Preset::perspective ? 38 * core::degree : preset == Preset::plan ? quarter : 0;
  target_ = 0.5 * (low + high);
  // Half extents of the box along the picture's axes, with some air around.
  double across = 0, upward = 0, along = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 at = Vec3((corner & 1) != 0 ? high.x : low.x, (corner & 2) != 0 ? high.y : low.y,
                         (corner & 4) != 0 ? high.z : low.z) -
                    target_;
    across = std::max(across, std::abs(glm::dot(at, right())));
    upward = std::max(upward, std::abs(glm::dot(at, up())));
    along = std::max(along, std::abs(glm::dot(at, forward())));
  }
  const double half = std::max({upward, across / std::max(aspect, 0.1), 0.05}) * (parallel_ ? 1.12 : 1.0);
  distance_ = half / std::tan(fov_ / 2) + (parallel_ ? 0.0 : 0.9 * along);
}

void OrbitCamera::lookFrom(const Vec3& eye, const Vec3& target, double verticalFov) {
  const Vec3 away = eye - target;
  distance_ = std::max(glm::length(away), 1e-3);
  target_ = target;
  elevation_ = std::asin(std::clamp(away.z / distance_, -1.0, 1.0));
  azimuth_ = std::abs(away.x) + std::abs(away.y) < 1e-9 ? -core::pi / 2 : std::atan2(away.y, away.x);
  fov_ = std::clamp(verticalFov, 2 * core::degree, 150 * core::degree);
  parallel_ = false;
}

void OrbitCamera::orbit(double rightward, double down, double height) {
  const double turn = core::pi / std::max(height, 100.0);
  azimuth_ -= rightward * turn;
  elevation_ = std::clamp(elevation_ + down * turn, -core::pi / 2, core::pi / 2);
}

void OrbitCamera::pan(double rightward, double down, double height) {
  const double metres = span() / std::max(height, 1.0);
  target_ += metres * (down * up() - rightward * right());
}

void OrbitCamera::zoom(double factor, const Vec3& point) {
  const double before = distance_;
  distance_ = std::clamp(distance_ / factor, 1e-3, 1e6);
  target_ = point + (target_ - point) * (distance_ / before);
}

void OrbitCamera::applyTo(vtkCamera& camera) const {
  const Vec3 from = eye(), upward = up();
  camera.SetParallelProjection(parallel_ ? 1 : 0);
  camera.SetParallelScale(span() / 2);
  camera.SetViewAngle(fov_ / core::degree);
  camera.SetFocalPoint(target_.x, target_.y, target_.z);
  camera.SetPosition(from.x, from.y, from.z);
  camera.SetViewUp(upward.x, upward.y, upward.z);
}

}  // namespace goniolux::gui
