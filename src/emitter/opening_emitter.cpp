#include "emitter/opening_emitter.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "emitter/quadrature.h"

namespace goniolux::emitter {

using core::Vec3;

namespace {

// From this many radii on an opening is seen under so small an angle that quadrature begins with its centre.
constexpr double farRadii = 8;

}  // namespace

OpeningEmitter::OpeningEmitter(const Vec3& center, double boundingRadius, Output output)
    : center_(center), boundingRadius_(boundingRadius), output_(std::move(output)) {
  flux_ = output_.distribution ? output_.scale * output_.distribution->flux() : output_.flux_lm;
  peakIntensity_ = output_.distribution ? output_.scale * output_.distribution->maximumIntensity() : flux_ / core::pi;
  if (!output_.distribution) return;
  constexpr int planes = 16;
  constexpr auto last = static_cast<double>(std::tuple_size_v<decltype(rough_)> - 1);
  for (std::size_t i = 0; i < rough_.size(); ++i) {
    const double cosine = -1 + 2 * static_cast<double>(i) / last, sine = std::sqrt(1 - cosine * cosine);
    for (int plane = 0; plane < planes; ++plane) {
      const double angle = 2 * core::pi * plane / planes;
      const Vec3 local(sine * std::cos(angle), sine * std::sin(angle), cosine);
      rough_[i] = std::max(rough_[i], output_.scale * output_.distribution->intensity(local));
    }
  }
}

double OpeningEmitter::roughIntensity(const Vec3& direction) const {
  if (!output_.distribution) return intensity(direction);
  constexpr auto last = static_cast<double>(std::tuple_size_v<decltype(rough_)> - 1);
  const double place = (glm::dot(direction, output_.frame.aim) + 1) * 0.5 * last;
  const auto low = static_cast<std::size_t>(std::clamp(place, 0.0, last - 1));
  const double t = std::clamp(place - static_cast<double>(low), 0.0, 1.0);
  return rough_[low] + t * (rough_[low + 1] - rough_[low]);
}

void OpeningEmitter::setEmittingArea(double area) {
  if (!output_.distribution) uniformLuminance_ = flux_ / (core::pi * area);
}

double OpeningEmitter::elementIntensity(const Vec3& normal, const Vec3& direction) const {
  const double cosine = glm::dot(normal, direction);
  if (cosine <= 0) return 0;
  if (!output_.distribution) return uniformLuminance_ * cosine;
  const double area = projectedArea(direction);
  return area > 0 ? intensity(direction) * cosine / area : 0;
}

double OpeningEmitter::luminance(const Vec3& normal, const Vec3& direction) const {
  if (glm::dot(normal, direction) <= 0) return 0;
  if (!output_.distribution) return uniformLuminance_;
  static const double grazing = std::sin(1 * core::degree);
  const double largest = core::pi * boundingRadius_ * boundingRadius_;
  const double area = std::max(projectedArea(direction), grazing * std::min(largest, projectedArea(normal)));
  return area > 0 ? intensity(direction) / area : 0;
}

Illuminance OpeningEmitter::illuminance(const Vec3& point, const Vec3& normal, double tolerance) const {
  if (const auto far = fromCentre(point, normal, tolerance)) return *far;
  Illuminance sum;
  const bool far = glm::length(center_ - point) > farRadii * boundingRadius_;
  for (int patch = 0; patch < patchCount(); ++patch) {
    const auto integrand = [&](const core::Vec2& uv) {
      const Element e = element(patch, uv, point);
      if (e.area == 0) return 0.0;
      const Vec3 toElement = e.point - point;
      const double squared = glm::dot(toElement, toElement);
      const Vec3 direction = toElement / std::sqrt(squared);
      const double cosine = glm::dot(normal, direction);
      if (cosine <= 0) return 0.0;
      return elementIntensity(e.normal, -direction) * cosine / squared * e.area;
    };
    const QuadratureResult part = integrateSquare(integrand, tolerance, far);
    sum.value += part.value;
    sum.bound += part.bound;
  }
  return sum;
}

double OpeningEmitter::importance(const Vec3& point, const Vec3& normal) const {
  const Vec3 toCenter = center_ - point;
  const double distance = glm::length(toCenter);
  const double reach = std::max(distance, boundingRadius_);
  // The largest cosine under which any part of the bounding sphere is seen.
  const double cosine = distance > 0 ? glm::dot(toCenter, normal) / distance : 1.0;
  const double spread = distance > boundingRadius_ ? boundingRadius_ / distance : 1.0;
  if (distance > 0 && cosine <= -spread) return 0;
  const double facing = std::max(cosine, 0.25 * (cosine + spread));
  // A near opening is seen under many directions: its intensity towards the centre alone may be 0 where its edge still
  // shines.
  const double floor = 0.02 + 0.2 * std::min(1.0, spread * spread);
  const double towards = distance > 0 ? roughIntensity(-toCenter / distance) : peakIntensity_;
  return (towards + floor * peakIntensity_) * facing / (reach * reach);
}

double OpeningEmitter::roughSolidAngle(const Vec3& point) const {
  const Vec3 toCenter = center_ - point;
  const double distance = glm::length(toCenter);
  if (!(distance > 0)) return 2 * core::pi;
  const double area = projectedArea(-toCenter / distance), reach = std::max(distance, 0.5 * boundingRadius_);
  return std::min(2 * core::pi, area / (reach * reach));
}

IncidentLight OpeningEmitter::fromElement(const Vec3& point, const Vec3& elementPoint, const Vec3& elementNormal,
                                          double pdf) const {
  const Vec3 toElement = elementPoint - point;
  const double squared = glm::dot(toElement, toElement);
  if (squared == 0 || pdf <= 0) return {};
  const double distance = std::sqrt(squared);
  const Vec3 direction = toElement / distance;
  return {direction, distance, elementIntensity(elementNormal, -direction) / (squared * pdf)};
}

std::unique_ptr<Emitter> makeEmitter(const Opening& opening, const Vec3& center, const Output& output) {
  switch (opening.shape) {
    case Opening::Shape::point:
      return makePointEmitter(center, output);
    case Opening::Shape::rectangle:
      return makeRectangleEmitter(opening, center, output);
    case Opening::Shape::disc:
      return makeDiscEmitter(opening, center, output);
    case Opening::Shape::box:
      return makeBoxEmitter(opening, center, output);
    case Opening::Shape::sphere:
      return isRound(opening) ? makeSphereEmitter(opening, center, output)
                              : makeEllipsoidEmitter(opening, center, output);
    case Opening::Shape::cylinder:
      return isRound(opening) ? makeCylinderEmitter(opening, center, output)
                              : makeEllipticCylinderEmitter(opening, center, output);
    case Opening::Shape::tube:
      return makeCylinderEmitter(opening, center, output);
    case Opening::Shape::revolution:
      return makeRevolutionEmitter(opening, center, output);
    case Opening::Shape::line:
      return makeLineEmitter(opening, center, output);
  }
  return nullptr;
}

}  // namespace goniolux::emitter
