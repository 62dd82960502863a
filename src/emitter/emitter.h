// Emitter: a luminous opening with its intensity distribution, as a source of illuminance at points near and far.
//
// Every element of an opening has the whole distribution's shape: the luminance that leaves it in direction d is
// L(d) = I(d) / A_proj(d), with I the luminaire's luminous intensity and A_proj the projected area of the opening.
// All figures are photometric (lm, cd, lx, cd/m2) and include maintenance and dimming; the spectrum is carried beside
// them. World frame, metres. Immutable, thread safe.
#pragma once

#include <memory>
#include <vector>

#include "core/vector.h"
#include "emitter/opening.h"
#include "photometry/intensity_distribution.h"

namespace goniolux::emitter {

/// Light arriving from one sampled element of an opening.
struct IncidentLight {
  core::Vec3 direction;  ///< unit, from the point to the element
  double distance = 0;   ///< m
  double normalIlluminance =
      0;  ///< lx on a plane facing `direction`; its expectation over samples is the exact integral
};

/// An illuminance without regard to occlusion, and the bound of its quadrature error.
struct Illuminance {
  double value = 0, bound = 0;  ///< lx
};

class Emitter {
 public:
  virtual ~Emitter() = default;

  /// Chooses an element by u in [0,1)^2; the estimate is unbiased for any receiver at `point`.
  [[nodiscard]] virtual IncidentLight sample(const core::Vec3& point, const core::Vec2& u) const = 0;
  /// Illuminance on a plane with unit `normal` at `point`, nothing between; closed form where one exists, otherwise
  /// adaptive quadrature to about `tolerance` (relative).
  [[nodiscard]] virtual Illuminance illuminance(const core::Vec3& point, const core::Vec3& normal,
                                                double tolerance) const = 0;
  /// Luminance in cd/m2 that leaves the opening where its outward normal is `normal`, towards unit `direction`. Within
  /// 1 degree of grazing the projected area is held, so that pictures stay finite (the flux is not touched).
  [[nodiscard]] virtual double luminance(const core::Vec3& normal, const core::Vec3& direction) const = 0;
  /// A rough illuminance at `point`, for choosing among emitters: 0 only where no light of this emitter can arrive.
  [[nodiscard]] virtual double importance(const core::Vec3& point, const core::Vec3& normal) const = 0;
  /// About the solid angle in sr under which `point` sees the opening, for weighing two ways of finding its light; 0:
  /// rays cannot hit it (points, lines).
  [[nodiscard]] virtual double roughSolidAngle(const core::Vec3& point) const {
    (void)point;
    return 0;
  }
  /// The direction about which its light is described: where to look most closely for narrow beams.
  [[nodiscard]] virtual core::Vec3 aim() const = 0;
  /// Luminous flux, lm.
  [[nodiscard]] virtual double flux() const = 0;
  /// True where illuminance() costs little more than a sample (a closed form).
  [[nodiscard]] virtual bool hasClosedForm() const { return false; }
};

/// What an opening emits: the distribution in its frame, times `scale`; or, without a distribution, uniform luminance
/// of the whole opening with `flux_lm`.
struct Output {
  std::shared_ptr<const photometry::IntensityDistribution> distribution;
  photometry::LuminaireFrame frame;
  double scale = 1;
  double flux_lm = 0;
};

/// Makes the emitter for an opening at `center`. Dimensions must be positive (readers check).
std::unique_ptr<Emitter> makeEmitter(const Opening& opening, const core::Vec3& center, const Output& output);

/// A triangle that emits diffusely on both sides with `exitance` lm/m2 a side.
std::unique_ptr<Emitter> makeTriangleEmitter(const core::Vec3& a, const core::Vec3& b, const core::Vec3& c,
                                             double exitance);

}  // namespace goniolux::emitter
