// Openings with a volume: sphere, box, cylinder (caps included) and tube (side only). The luminance in a direction is
// the intensity over the projected area of the whole opening in that direction, the same for every element that faces
// it.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "emitter/lambertian_forms.h"
#include "emitter/opening_emitter.h"
#include "emitter/spherical_rectangle.h"

namespace goniolux::emitter {
namespace {

using core::Vec2;
using core::Vec3;

// Nearer to a box than this many of its lengths, directions are sampled instead of places; they cost three times as
// much.
constexpr double nearLengths = 1.5;

class SphereEmitter final : public OpeningEmitter {
 public:
  SphereEmitter(const Opening& opening, const Vec3& center, const Output& output)
      : OpeningEmitter(center, 0.5 * diametersOf(opening).x, output), radius_(0.5 * diametersOf(opening).x) {
    setEmittingArea(4 * core::pi * radius_ * radius_);
  }

  // Uniform over the cone of directions under which the sphere is seen.
  [[nodiscard]] IncidentLight sample(const Vec3& point, const Vec2& u) const override {
    const Vec3 toCenter = center_ - point;
    const double distance = glm::length(toCenter);
    if (distance <= radius_) return {};
    const double sine2 = radius_ * radius_ / (distance * distance);
    const double oneMinusCosMax = sine2 / (1 + std::sqrt(1 - sine2));  // 1 - cos without cancellation
    const double oneMinusCos = u.x * oneMinusCosMax;
    const double cosine = 1 - oneMinusCos;
    const double sine = std::sqrt(std::max(0.0, oneMinusCos * (2 - oneMinusCos)));
    const Vec3 axis = toCenter / distance;
    Vec3 x, y;
    core::perpendiculars(axis, x, y);
    const double angle = 2 * core::pi * u.y;
    const Vec3 direction = axis * cosine + (x * std::cos(angle) + y * std::sin(angle)) * sine;
    const double middle = distance * cosine;
    const double half = std::sqrt(std::max(0.0, radius_ * radius_ - distance * distance * sine * sine));
    const double luminance = intensity(-direction) / projectedArea(direction);
    return {direction, std::max(0.0, middle - half), luminance * 2 * core::pi * oneMinusCosMax};
  }

  [[nodiscard]] Illuminance illuminance(const Vec3& point, const Vec3& normal, double tolerance) const override {
    if (!output_.distribution) return {uniformLuminance_ * sphereFactor(center_, radius_, point, normal), 0};
    return OpeningEmitter::illuminance(point, normal, tolerance);
  }
  [[nodiscard]] bool hasClosedForm() const override { return !output_.distribution; }

 protected:
  [[nodiscard]] double projectedArea(const Vec3&) const override { return core::pi * radius_ * radius_; }
  [[nodiscard]] int patchCount() const override { return 1; }
  // The cap that the point sees, u from its pole to its rim.
  [[nodiscard]] Element element(int, const Vec2& uv, const Vec3& point) const override {
    const Vec3 toPoint = point - center_;
    const double distance = glm::length(toPoint);
    if (distance <= radius_) return {};
    const Vec3 axis = toPoint / distance;
    Vec3 x, y;
    core::perpendiculars(axis, x, y);
    const double rim = 1 - radius_ / distance;
    // cos = 1 - rim s^2 spreads the nodes evenly over the cap
    const double cosine = 1 - rim * uv.x * uv.x, sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
    const double angle = 2 * core::pi * uv.y;
    const Vec3 normal = axis * cosine + (x * std::cos(angle) + y * std::sin(angle)) * sine;
    return {center_ + normal * radius_, normal, radius_ * radius_ * 2 * core::pi * rim * 2 * uv.x};
  }

 private:
  double radius_;
};

class BoxEmitter final : public OpeningEmitter {
 public:
  BoxEmitter(const Opening& opening, const Vec3& center, const Output& output)
      : OpeningEmitter(center, 0.5 * std::hypot(opening.length, opening.width, opening.height), output),
        axes_{axesOf(opening, output.frame).x, axesOf(opening, output.frame).y, axesOf(opening, output.frame).z},
        half_{0.5 * opening.length, 0.5 * opening.width, 0.5 * opening.height},
        size_(std::max({opening.length, opening.width, opening.height})) {
    double area = 0;
    for (int face = 0; face < 6; ++face) {
      const auto axis = static_cast<unsigned>(face / 2);
      faceArea_[static_cast<unsigned>(face)] =
          opening.isCovered(face) ? 0 : 4 * half_[(axis + 1) % 3] * half_[(axis + 2) % 3];
      area += faceArea_[static_cast<unsigned>(face)];
    }
    setEmittingArea(area);
  }

  [[nodiscard]] IncidentLight sample(const Vec3& point, const Vec2& u) const override {
    const Vec3 toCenter = center_ - point;
    const bool near = glm::dot(toCenter, toCenter) < nearLengths * nearLengths * size_ * size_;
    return near ? sampleDirection(point, u) : samplePlace(point, u);
  }

  [[nodiscard]] double luminance(const Vec3& normal, const Vec3& direction) const override {
    return faceArea_[faceTowards(normal)] > 0 ? OpeningEmitter::luminance(normal, direction) : 0;
  }

 protected:
  [[nodiscard]] double projectedArea(const Vec3& direction) const override {
    double area = 0;
    for (unsigned i = 0; i < 3; ++i) {
      const double cosine = glm::dot(axes_[i], direction);
      area += faceArea_[2 * i + (cosine < 0 ? 1 : 0)] * std::abs(cosine);
    }
    return area;
  }
  [[nodiscard]] int patchCount() const override { return 6; }
  [[nodiscard]] Element element(int face, const Vec2& uv, const Vec3& point) const override {
    const Vec3 normal = faceNormal(face);
    if (areaOf(face) == 0 || glm::dot(normal, point - faceCenter(face)) <= 0) return {};
    const auto a = static_cast<unsigned>((face / 2 + 1) % 3), b = static_cast<unsigned>((face / 2 + 2) % 3);
    const Vec3 at = faceCenter(face) + axes_[a] * (half_[a] * (2 * uv.x - 1)) + axes_[b] * (half_[b] * (2 * uv.y - 1));
    return {at, normal, areaOf(face)};
  }

 private:
  /// One of the up to three faces that the point sees, by the projected area seen; then a point of it.
  [[nodiscard]] IncidentLight samplePlace(const Vec3& point, const Vec2& u) const {
    std::array<double, 6> weight{};
    double sum = 0;
    for (int face = 0; face < 6; ++face) {
      const Vec3 normal = faceNormal(face), toPoint = point - faceCenter(face);
      const double height = glm::dot(normal, toPoint);
      if (height > 0) weight[static_cast<unsigned>(face)] = areaOf(face) * height / glm::length(toPoint);
      sum += weight[static_cast<unsigned>(face)];
    }
    if (sum == 0) return {};
    double pick = u.x * sum;
    int face = 0;
    while (face < 5 && pick >= weight[static_cast<unsigned>(face)]) pick -= weight[static_cast<unsigned>(face++)];
    const double chosen = weight[static_cast<unsigned>(face)];
    if (chosen == 0) return {};
    const Element e = element(face, {std::min(pick / chosen, 1.0), u.y}, point);
    return fromElement(point, e.point, e.normal, chosen / sum / areaOf(face));
  }

  /// A direction, evenly over the solid angle of the faces that the point sees. Beside a batten places of a face would
  /// not do: on the ceiling a centimetre away, the inverse square of a few of them is nearly all of the light.
  [[nodiscard]] IncidentLight sampleDirection(const Vec3& point, const Vec2& u) const {
    std::array<std::optional<SphericalRectangle>, 3> seen;
    double sum = 0;
    for (unsigned axis = 0; axis < 3; ++axis) {
      const Vec3 toCenter = center_ - point;
      const double along = glm::dot(axes_[axis], toCenter);
      if (std::abs(along) <= half_[axis] * (1 + 1e-9) || faceArea_[2 * axis + (along > 0 ? 1 : 0)] == 0) continue;
      const unsigned a = (axis + 1) % 3, b = (axis + 2) % 3;
      const Vec3 corner =
          center_ - axes_[axis] * std::copysign(half_[axis], along) - axes_[a] * half_[a] - axes_[b] * half_[b];
      seen[axis].emplace(corner, axes_[a] * (2 * half_[a]), axes_[b] * (2 * half_[b]), point);
      if (!seen[axis]->isSound()) seen[axis].reset();
      if (seen[axis]) sum += seen[axis]->solidAngle();
    }
    // What is left out beside this is a thousandth; a box seen so small is no near one.
    if (!(sum > 1e-3)) return samplePlace(point, u);
    double pick = u.x * sum;
    unsigned chosen = 3;
    for (unsigned axis = 0; axis < 3; ++axis) {
      if (!seen[axis]) continue;
      if (chosen < 3) pick -= seen[chosen]->solidAngle();
      chosen = axis;
      if (pick < seen[axis]->solidAngle()) break;
    }
    const double share = std::clamp(pick / seen[chosen]->solidAngle(), 0.0, 1.0);
    const Vec3 toElement = seen[chosen]->sample({share, u.y}) - point;
    const double distance = glm::length(toElement);
    const Vec3 direction = toElement / distance;
    const double area = projectedArea(-direction);
    return {direction, distance, area > 0 ? intensity(-direction) / area * sum : 0};
  }

  [[nodiscard]] double areaOf(int face) const { return faceArea_[static_cast<unsigned>(face)]; }
  [[nodiscard]] unsigned faceTowards(const Vec3& normal) const {
    const Vec3 local =
        glm::abs(Vec3(glm::dot(axes_[0], normal), glm::dot(axes_[1], normal), glm::dot(axes_[2], normal)));
    const unsigned axis = local.x >= local.y && local.x >= local.z ? 0 : local.y >= local.z ? 1 : 2;
    return 2 * axis + (glm::dot(axes_[axis], normal) < 0 ? 1 : 0);
  }
  [[nodiscard]] Vec3 faceNormal(int face) const {
    const Vec3& axis = axes_[static_cast<unsigned>(face / 2)];
    return face % 2 == 0 ? axis : -axis;
  }
  [[nodiscard]] Vec3 faceCenter(int face) const {
    return center_ + faceNormal(face) * half_[static_cast<unsigned>(face / 2)];
  }

  std::array<Vec3, 3> axes_;
  std::array<double, 3> half_;
  double size_;
  std::array<double, 6> faceArea_;  ///< 0: covered
};

class CylinderEmitter final : public OpeningEmitter {
 public:
  CylinderEmitter(const Opening& opening, const Vec3& center, const Output& output, bool caps)
      : OpeningEmitter(center, 0.5 * std::hypot(caps ? opening.height : opening.length, diametersOf(opening).x),
                       output),
        axis_(caps ? axesOf(opening, output.frame).z : glm::normalize(opening.axis)),
        length_(caps ? opening.height : opening.length),
        radius_(0.5 * (caps ? diametersOf(opening).x : opening.diameter)),
        caps_(caps) {
    for (const int below : {0, 1})
      capArea_[static_cast<unsigned>(below)] = caps && !opening.isCovered(4 + below) ? core::pi * radius_ * radius_ : 0;
    setEmittingArea(2 * core::pi * radius_ * length_ + capArea_[0] + capArea_[1]);
  }

  [[nodiscard]] IncidentLight sample(const Vec3& point, const Vec2& u) const override {
    const Seen seen = look(point);
    const double side =
        seen.visible > 0 ? 2 * radius_ * length_ * seen.distance / std::hypot(seen.distance, seen.along) : 0;
    const double capArea = capArea_[seen.along < 0 ? 1 : 0];
    const double cap = seen.capFaces ? capArea * (std::abs(seen.along) - 0.5 * length_) /
                                           std::hypot(seen.distance, std::abs(seen.along) - 0.5 * length_)
                                     : 0;
    if (side + cap <= 0) return {};
    const double pSide = side / (side + cap);
    if (u.x < pSide) {
      const Place place = along(seen, u.x / pSide);
      const double phi = seen.visible * (2 * u.y - 1);
      const Vec3 normal = seen.x * std::cos(phi) + seen.y * std::sin(phi);
      return fromElement(point, center_ + axis_ * place.z + normal * radius_, normal,
                         pSide / (place.perUnit * 2 * seen.visible * radius_));
    }
    const double r = radius_ * std::sqrt((u.x - pSide) / (1 - pSide)), phi = 2 * core::pi * u.y;
    const Vec3 normal = seen.along > 0 ? axis_ : -axis_;
    const Vec3 at = center_ + normal * (0.5 * length_) + (seen.x * std::cos(phi) + seen.y * std::sin(phi)) * r;
    return fromElement(point, at, normal, (1 - pSide) / capArea);
  }

 protected:
  [[nodiscard]] double projectedArea(const Vec3& direction) const override {
    const double along = glm::dot(axis_, direction), cosine = std::min(1.0, std::abs(along));
    return 2 * radius_ * length_ * std::sqrt(1 - cosine * cosine) + capArea_[along < 0 ? 1 : 0] * cosine;
  }
  [[nodiscard]] int patchCount() const override { return caps_ ? 2 : 1; }
  // Patch 0: the arc of the side that faces the point; patch 1: the cap that faces it.
  [[nodiscard]] Element element(int patch, const Vec2& uv, const Vec3& point) const override {
    const Seen seen = look(point);
    if (patch == 0) {
      if (seen.visible <= 0) return {};
      const Place place = along(seen, uv.x);
      const double phi = seen.visible * (2 * uv.y - 1);
      const Vec3 normal = seen.x * std::cos(phi) + seen.y * std::sin(phi);
      return {center_ + axis_ * place.z + normal * radius_, normal, place.perUnit * radius_ * 2 * seen.visible};
    }
    if (!seen.capFaces) return {};
    const double r = radius_ * uv.x, phi = 2 * core::pi * uv.y;
    const Vec3 normal = seen.along > 0 ? axis_ : -axis_;
    return {center_ + normal * (0.5 * length_) + (seen.x * std::cos(phi) + seen.y * std::sin(phi)) * r, normal,
            2 * core::pi * radius_ * r};
  }

 private:
  /// The cylinder as a point sees it: distance from the axis, place along it, and the half-angle of the arc that faces
  /// the point.
  struct Seen {
    double distance, along, visible;
    bool capFaces;
    Vec3 x, y;
  };
  /// Equiangular places along the axis as seen from the point, for s in [0, 1]: the inverse square's peak is spread
  /// evenly.
  struct Place {
    double z, perUnit;  ///< place along the axis, and dz/ds
  };
  [[nodiscard]] Place along(const Seen& seen, double s) const {
    const double near = std::max(seen.distance - radius_, 1e-9 * radius_);
    const double from = std::atan2(-0.5 * length_ - seen.along, near),
                 to = std::atan2(0.5 * length_ - seen.along, near);
    const double dz = near * std::tan(from + (to - from) * s);
    return {std::clamp(seen.along + dz, -0.5 * length_, 0.5 * length_), (to - from) * (near * near + dz * dz) / near};
  }
  [[nodiscard]] Seen look(const Vec3& point) const {
    const Vec3 d = point - center_;
    const double axial = glm::dot(d, axis_);
    const Vec3 sideways = d - axis_ * axial;
    const double distance = glm::length(sideways);
    const bool capFaces = std::abs(axial) > 0.5 * length_ && capArea_[axial < 0 ? 1 : 0] > 0;
    Seen seen{distance, axial, 0, capFaces, {}, {}};
    if (distance > radius_) {
      seen.visible = std::acos(radius_ / distance);
      seen.x = sideways / distance;
      seen.y = glm::cross(axis_, seen.x);
    } else {
      core::perpendiculars(axis_, seen.x, seen.y);
    }
    return seen;
  }

  Vec3 axis_;
  double length_, radius_;
  std::array<double, 2> capArea_;  ///< towards the axis and opposite; 0: none, or covered
  bool caps_;
};

}  // namespace

std::unique_ptr<Emitter> makeSphereEmitter(const Opening& opening, const Vec3& center, const Output& output) {
  return std::make_unique<SphereEmitter>(opening, center, output);
}

std::unique_ptr<Emitter> makeBoxEmitter(const Opening& opening, const Vec3& center, const Output& output) {
  return std::make_unique<BoxEmitter>(opening, center, output);
}

std::unique_ptr<Emitter> makeCylinderEmitter(const Opening& opening, const Vec3& center, const Output& output) {
  return std::make_unique<CylinderEmitter>(opening, center, output, opening.shape == Opening::Shape::cylinder);
}

}  // namespace goniolux::emitter
