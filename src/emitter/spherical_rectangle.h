// Uniform sampling of the solid angle that a rectangle subtends.
// C. Urena, M. Fajardo, A. King, "An Area-Preserving Parametrization for Spherical Rectangles", EGSR 2013.
#pragma once

#include "core/vector.h"

namespace goniolux::emitter {

class SphericalRectangle {
 public:
  /// Rectangle with a corner and two perpendicular edges, seen from `origin`, which must not lie in its plane.
  SphericalRectangle(const core::Vec3& corner, const core::Vec3& edgeX, const core::Vec3& edgeY,
                     const core::Vec3& origin);
  /// Solid angle, sr.
  [[nodiscard]] double solidAngle() const { return solidAngle_; }
  /// False where it is seen so nearly on edge that rounding (some 1e-8 sr) is of the solid angle's own size.
  [[nodiscard]] bool isSound() const { return solidAngle_ > 1e-6; }
  /// The point of the rectangle for u in [0,1)^2; its density is uniform over the solid angle.
  [[nodiscard]] core::Vec3 sample(const core::Vec2& u) const;

 private:
  core::Vec3 origin_, x_, y_, z_;
  double x0_, x1_, y0_, y1_, z0_, b0_, b1_, k_, solidAngle_;
};

}  // namespace goniolux::emitter
