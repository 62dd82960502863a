#include "validation/closed_forms.h"

#include <algorithm>
#include <cmath>

namespace goniolux::validation {
namespace {

using core::pi;
using core::Vec3;

double patch(const Vec3& corner, const Vec3& u, const Vec3& v, const Vec3& point, const Vec3& normal, int depth) {
  const Vec3 centre = corner + 0.5 * (u + v);
  const double size = std::max(glm::length(u), glm::length(v));
  if (depth < 24 && size > 0.4 * glm::length(centre - point)) {
    double sum = 0;
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j)
        sum += patch(corner + 0.5 * (static_cast<double>(i) * u + static_cast<double>(j) * v), 0.5 * u, 0.5 * v, point,
                     normal, depth + 1);
    return sum;
  }
  const Vec3 area = glm::cross(u, v);  // not unit: its length is the area
  double sum = 0;
  for (int i = 0; i < 8; ++i)
    for (int j = 0; j < 8; ++j) {
      const double s = i < 4 ? gaussNodes[i] : -gaussNodes[i - 4], t = j < 4 ? gaussNodes[j] : -gaussNodes[j - 4];
      const Vec3 to = corner + 0.5 * (1 + s) * u + 0.5 * (1 + t) * v - point;
      const double d2 = glm::dot(to, to);
      sum += 0.25 * gaussWeights[i % 4] * gaussWeights[j % 4] * std::max(0.0, glm::dot(normal, to)) *
             std::abs(glm::dot(area, to)) / (d2 * d2);
    }
  return sum;
}

}  // namespace

double parallelogramFactor(const Vec3& corner, const Vec3& u, const Vec3& v, const Vec3& point, const Vec3& normal) {
  return patch(corner, u, v, point, normal, 0);
}

double discParallel(double a, double d, double r) {
  const double s = std::sqrt(std::pow(r * r + d * d + a * a, 2) - 4 * a * a * r * r);
  return 0.5 * pi * (1 - (r * r + d * d - a * a) / s);
}

double discPerpendicular(double a, double d, double r) {
  const double s = std::sqrt(std::pow(r * r + d * d + a * a, 2) - 4 * a * a * r * r);
  return 0.5 * pi * d / r * ((r * r + d * d + a * a) / s - 1);
}

double sphereFactor(double halfAngle, double tilt) {
  // At `angle` off the axis the cosine at the receiver is p + q cos(azimuth).
  const auto ring = [&](double angle) {
    const double p = std::cos(tilt) * std::cos(angle), q = std::sin(tilt) * std::sin(angle);
    if (p >= std::abs(q)) return 2 * pi * p * std::sin(angle);
    if (p <= -std::abs(q)) return 0.0;
    const double up = std::acos(-p / q);
    return 2 * (p * up + q * std::sin(up)) * std::sin(angle);
  };
  constexpr int steps = 200000;
  const double h = halfAngle / steps;
  double sum = ring(0) + ring(halfAngle);
  for (int i = 1; i < steps; ++i) sum += (i % 2 == 1 ? 4 : 2) * ring(i * h);
  return sum * h / 3;
}

double lineBeforeCentre(double l, double d, double perMetre) {
  const double half = std::atan(0.5 * l / d);
  return perMetre / d * (half + std::sin(half) * std::cos(half));
}
double lineBeforeEnd(double l, double d, double perMetre) {
  const double whole = std::atan(l / d);
  return perMetre / (2 * d) * (whole + std::sin(whole) * std::cos(whole));
}
double lineAcrossEnd(double l, double d, double perMetre) {
  const double sine = std::sin(std::atan(l / d));
  return perMetre / (2 * d) * sine * sine;
}

double tubeUnderEnd(double radius, double l, double luminance, double h) {
  constexpr int strips = 20000;
  const double visible = std::acos(radius / h);
  double sum = 0;
  for (int i = 0; i < strips; ++i) {
    const double phi = visible * (2 * (i + 0.5) / strips - 1);
    const double y = radius * std::sin(phi), z = h - radius * std::cos(phi);
    const double s2 = y * y + z * z, s = std::sqrt(s2);
    const double facing = std::cos(phi) * z - std::sin(phi) * y;
    // Integral of dx / (x^2 + s^2)^2 from 0 to l.
    const double along = l / (2 * s2 * (l * l + s2)) + std::atan(l / s) / (2 * s2 * s);
    sum += facing * z * along;
  }
  return luminance * radius * 2 * visible / strips * sum;
}

double rectangleSolidAngle(double a, double b, double h) {
  return 4 * std::atan(a * b / (4 * h * std::sqrt(a * a / 4 + b * b / 4 + h * h)));
}

double rectangleSolidAngle(double a, double b, double h, double x, double y) {
  const auto corner = [&](double p, double q) { return std::atan(p * q / (h * std::sqrt(p * p + q * q + h * h))); };
  return corner(x, y) + corner(a - x, y) + corner(x, b - y) + corner(a - x, b - y);
}

}  // namespace goniolux::validation
