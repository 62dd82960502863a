#include "emitter/lambertian_forms.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace goniolux::emitter {

using core::Vec3;

double polygonFactor(std::span<const Vec3> polygon, const Vec3& point, const Vec3& normal) {
  // Clip at the horizon: keep what lies above the receiver's plane.
  std::array<Vec3, 32> corners;
  std::size_t count = 0;
  assert(polygon.size() <= 16);
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3 a = polygon[i] - point, b = polygon[(i + 1) % polygon.size()] - point;
    const double ha = glm::dot(a, normal), hb = glm::dot(b, normal);
    if (ha >= 0) corners[count++] = a;
    if ((ha > 0 && hb < 0) || (ha < 0 && hb > 0)) corners[count++] = a + (b - a) * (ha / (ha - hb));
  }
  if (count < 3) return 0;
  // E / L = 1/2 sum over edges of (angle of the edge seen from the point) * (edge-plane normal . n)
  double sum = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 &a = corners[i], &b = corners[(i + 1) % count];
    const Vec3 across = glm::cross(a, b);
    const double sine = glm::length(across);
    if (sine == 0) continue;
    sum += std::atan2(sine, glm::dot(a, b)) * glm::dot(across, normal) / sine;
  }
  return 0.5 * std::abs(sum);
}

std::optional<double> discFactor(const Vec3& center, const Vec3& axis, double radius, const Vec3& point,
                                 const Vec3& normal) {
  const Vec3 toCenter = center - point;
  // The disc's extent along the receiver's normal, about its centre.
  const double reach = radius * std::sqrt(std::max(0.0, 1 - glm::dot(axis, normal) * glm::dot(axis, normal)));
  const double height = glm::dot(toCenter, normal);
  if (height <= -reach) return 0.0;
  if (height < reach) return std::nullopt;
  const double along = glm::dot(toCenter, axis);
  const Vec3 facing = along >= 0 ? axis : -axis;  // from the point towards the disc's plane
  const double d = std::abs(along);
  if (d == 0) return 0.0;
  const Vec3 sideways = toCenter - axis * along;
  const double r = glm::length(sideways);
  const double r2 = r * r, d2 = d * d, a2 = radius * radius;
  const double s = std::sqrt((r2 + d2 + a2) * (r2 + d2 + a2) - 4 * a2 * r2);
  // 1 - (r2+d2-a2)/s without cancellation: s^2 - (r2+d2-a2)^2 = 4 a2 d2
  const double parallel = 0.5 * core::pi * 4 * a2 * d2 / (s * (s + r2 + d2 - a2));
  double factor = parallel * glm::dot(facing, normal);
  if (r > 0) {
    // (r2+d2+a2)/s - 1 = 4 a2 r2 / (s (r2+d2+a2+s))
    const double perpendicular = 0.5 * core::pi * (d / r) * 4 * a2 * r2 / (s * (r2 + d2 + a2 + s));
    factor += perpendicular * glm::dot(sideways / r, normal);
  }
  return std::max(0.0, factor);
}

double sphereFactor(const Vec3& center, double radius, const Vec3& point, const Vec3& normal) {
  const Vec3 toCenter = center - point;
  const double distance = glm::length(toCenter);
  if (distance <= radius) return core::pi;
  const double sinAlpha = radius / distance;  // half angle under which the sphere is seen
  const double cosTheta = std::clamp(glm::dot(toCenter, normal) / distance, -1.0, 1.0);
  const double sinTheta = std::sqrt(1 - cosTheta * cosTheta);
  if (cosTheta >= sinAlpha) return core::pi * sinAlpha * sinAlpha * cosTheta;  // wholly above the horizon
  if (cosTheta <= -sinAlpha) return 0;
  const double cosAlpha = std::sqrt(1 - sinAlpha * sinAlpha);
  // [howell B-43] with H = distance/radius and theta the tilt
  const double x = std::clamp(cosAlpha / sinTheta, -1.0, 1.0);
  const double cotAlpha = cosAlpha / sinAlpha, cotTheta = cosTheta / sinTheta;
  const double y = std::sqrt(std::max(0.0, 1 - cotAlpha * cotAlpha * cotTheta * cotTheta));
  const double factor = sinAlpha * sinAlpha * cosTheta * std::acos(std::clamp(-cotAlpha * cotTheta, -1.0, 1.0)) -
                        sinAlpha * cosAlpha * sinTheta * y + std::asin(std::sqrt(std::max(0.0, 1 - x * x)));
  return std::max(0.0, factor);
}

}  // namespace goniolux::emitter
