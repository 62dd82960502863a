#include "emitter/spherical_rectangle.h"

#include <algorithm>
#include <cmath>

namespace goniolux::emitter {

using core::Vec3;

SphericalRectangle::SphericalRectangle(const Vec3& corner, const Vec3& edgeX, const Vec3& edgeY, const Vec3& origin)
    : origin_(origin) {
  const double lengthX = glm::length(edgeX), lengthY = glm::length(edgeY);
  x_ = edgeX / lengthX;
  y_ = edgeY / lengthY;
  z_ = glm::cross(x_, y_);
  const Vec3 d = corner - origin;
  z0_ = glm::dot(d, z_);
  if (z0_ > 0) {
    z_ = -z_;
    z0_ = -z0_;
  }
  x0_ = glm::dot(d, x_);
  y0_ = glm::dot(d, y_);
  x1_ = x0_ + lengthX;
  y1_ = y0_ + lengthY;

  // Normals of the planes through the origin and each edge, and the inner angles between them ([urena13], section 4).
  const Vec3 v00(x0_, y0_, z0_), v01(x0_, y1_, z0_), v10(x1_, y0_, z0_), v11(x1_, y1_, z0_);
  const Vec3 n0 = glm::normalize(glm::cross(v00, v10)), n1 = glm::normalize(glm::cross(v10, v11));
  const Vec3 n2 = glm::normalize(glm::cross(v11, v01)), n3 = glm::normalize(glm::cross(v01, v00));
  const auto inner = [](const Vec3& a, const Vec3& b) { return std::acos(std::clamp(-glm::dot(a, b), -1.0, 1.0)); };
  const double g0 = inner(n0, n1), g1 = inner(n1, n2), g2 = inner(n2, n3), g3 = inner(n3, n0);
  b0_ = n0.z;
  b1_ = n2.z;
  k_ = 2 * core::pi - g2 - g3;
  solidAngle_ = g0 + g1 - k_;
}

Vec3 SphericalRectangle::sample(const core::Vec2& u) const {
  const double au = u.x * solidAngle_ + k_;
  const double fu = (std::cos(au) * b0_ - b1_) / std::sin(au);
  const double cu = std::clamp(std::copysign(1 / std::sqrt(fu * fu + b0_ * b0_), fu), -1.0, 1.0);
  const double xu = std::clamp(-(cu * z0_) / std::sqrt(std::max(1e-300, 1 - cu * cu)), x0_, x1_);
  const double d = std::sqrt(xu * xu + z0_ * z0_);
  const double h0 = y0_ / std::sqrt(d * d + y0_ * y0_), h1 = y1_ / std::sqrt(d * d + y1_ * y1_);
  const double hv = h0 + u.y * (h1 - h0);
  const double yv = hv * hv < 1 - 1e-12 ? hv * d / std::sqrt(1 - hv * hv) : y1_;
  return origin_ + x_ * xu + y_ * std::clamp(yv, y0_, y1_) + z_ * z0_;
}

}  // namespace goniolux::emitter
