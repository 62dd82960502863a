// OpeningEmitter: what the emitters of luminaire openings share: the distribution in its frame, the choice measure, and
// adaptive quadrature over the opening. Each opening is a file of its own that says how its surface is cut into
// elements.
#pragma once

#include <array>
#include <optional>

#include "emitter/emitter.h"

namespace goniolux::emitter {

/// A surface element of an opening, as mapped from the unit square: `area` is the Jacobian, m2.
struct Element {
  core::Vec3 point, normal;
  double area = 0;
};

class OpeningEmitter : public Emitter {
 public:
  OpeningEmitter(const core::Vec3& center, double boundingRadius, Output output);

  [[nodiscard]] Illuminance illuminance(const core::Vec3& point, const core::Vec3& normal,
                                        double tolerance) const override;
  [[nodiscard]] double luminance(const core::Vec3& normal, const core::Vec3& direction) const override;
  [[nodiscard]] double importance(const core::Vec3& point, const core::Vec3& normal) const override;
  [[nodiscard]] double roughSolidAngle(const core::Vec3& point) const override;
  [[nodiscard]] core::Vec3 aim() const override { return output_.frame.aim; }
  [[nodiscard]] double flux() const override { return flux_; }

 protected:
  /// Projected area of the opening in a direction, m2 (for a side-only tube: of its side).
  [[nodiscard]] virtual double projectedArea(const core::Vec3& direction) const = 0;
  /// The opening as a number of patches, each mapped from the unit square; may leave out what `point` cannot see.
  [[nodiscard]] virtual int patchCount() const = 0;
  [[nodiscard]] virtual Element element(int patch, const core::Vec2& uv, const core::Vec3& point) const = 0;

  /// Luminous intensity in a unit world direction, cd.
  [[nodiscard]] double intensity(const core::Vec3& direction) const {
    return output_.distribution ? output_.scale * output_.distribution->intensity(output_.frame.toLocal(direction))
                                : uniformLuminance_ * projectedArea(direction);
  }
  /// Intensity per surface area that an element with unit `normal` sends in a direction: L cos, cd/m2.
  [[nodiscard]] virtual double elementIntensity(const core::Vec3& normal, const core::Vec3& direction) const;
  /// Called by constructors once projectedArea works: sets the uniform luminance from the surface area that emits.
  void setEmittingArea(double area);
  /// The opening is the same on both sides of its centre as far as a direction sees it (flat openings and lines do):
  /// far away its centre may stand for it.
  [[nodiscard]] virtual bool isCentred() const { return false; }
  /// All of the light as if it left the centre, where a bound of that error is within `tolerance` (relative); nothing
  /// elsewhere. It costs one look at the distribution.
  [[nodiscard]] std::optional<Illuminance> fromCentre(const core::Vec3& point, const core::Vec3& normal,
                                                      double tolerance) const;
  /// Light of an element chosen with density `pdf` per area.
  [[nodiscard]] IncidentLight fromElement(const core::Vec3& point, const core::Vec3& elementPoint,
                                          const core::Vec3& elementNormal, double pdf) const;

  /// Largest intensity over C near an angle from the aim, from a coarse table: for choosing among emitters only.
  [[nodiscard]] double roughIntensity(const core::Vec3& direction) const;

  core::Vec3 center_;
  double boundingRadius_, flux_, peakIntensity_;
  Output output_;
  double uniformLuminance_ = 0;     ///< of openings without a distribution
  std::array<double, 33> rough_{};  ///< by the cosine of the angle from the aim, -1 to 1
};

std::unique_ptr<Emitter> makePointEmitter(const core::Vec3& center, const Output& output);
std::unique_ptr<Emitter> makeRectangleEmitter(const Opening& opening, const core::Vec3& center, const Output& output);
std::unique_ptr<Emitter> makeDiscEmitter(const Opening& opening, const core::Vec3& center, const Output& output);
std::unique_ptr<Emitter> makeBoxEmitter(const Opening& opening, const core::Vec3& center, const Output& output);
std::unique_ptr<Emitter> makeSphereEmitter(const Opening& opening, const core::Vec3& center, const Output& output);
std::unique_ptr<Emitter> makeCylinderEmitter(const Opening& opening, const core::Vec3& center, const Output& output);
std::unique_ptr<Emitter> makeEllipsoidEmitter(const Opening& opening, const core::Vec3& center, const Output& output);
std::unique_ptr<Emitter> makeEllipticCylinderEmitter(const Opening& opening, const core::Vec3& center,
                                                     const Output& output);
std::unique_ptr<Emitter> makeRevolutionEmitter(const Opening& opening, const core::Vec3& position,
                                               const Output& output);
std::unique_ptr<Emitter> makeLineEmitter(const Opening& opening, const core::Vec3& center, const Output& output);

}  // namespace goniolux::emitter
