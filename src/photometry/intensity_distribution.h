// IntensityDistribution: luminous intensity I(C, gamma) of a luminaire as a function on the sphere, in cd.
//
// Luminaire frame (declared here, once): a direction is given by its components along C0 (x), C90 (y) and gamma = 0, the aim (z).
// In world space C90 = c0 x aim, so that with aim -z and c0 +x the angle C turns anticlockwise seen from above. The triple
// (C0, C90, aim) is therefore left-handed; it is only ever used through dot products.
#pragma once

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "core/vector.h"

namespace goniolux::photometry {

/// World directions of the luminaire frame; all unit, mutually perpendicular.
struct LuminaireFrame {
  core::Vec3 c0{1, 0, 0}, c90{0, 1, 0}, aim{0, 0, -1};
  [[nodiscard]] core::Vec3 toLocal(const core::Vec3& world) const {
    return {glm::dot(world, c0), glm::dot(world, c90), glm::dot(world, aim)};
  }
  [[nodiscard]] core::Vec3 toWorld(const core::Vec3& local) const { return c0 * local.x + c90 * local.y + aim * local.z; }
};

/// Immutable once made, therefore thread safe and shared.
class IntensityDistribution {
 public:
  virtual ~IntensityDistribution() = default;
  /// Luminous intensity in cd in a unit direction of the luminaire frame.
  [[nodiscard]] virtual double intensity(const core::Vec3& local) const = 0;
  /// Exact integral of the interpolant over the sphere, lm.
  [[nodiscard]] virtual double flux() const = 0;
  /// Exact integral over the half sphere of gamma < 90 degrees, lm.
  [[nodiscard]] virtual double forwardFlux() const = 0;
  [[nodiscard]] virtual double maximumIntensity() const = 0;
  /// I(gamma) = I0 cos(gamma) for gamma < 90 and 0 beyond: a flat opening then has uniform luminance, and closed forms apply.
  [[nodiscard]] virtual bool isLambertian() const { return false; }
};

/// I = I0 cos^n(gamma) for gamma <= 90 degrees, 0 beyond; n = 0 with `bothSides` is isotropic over the whole sphere.
class CosinePowerDistribution final : public IntensityDistribution {
 public:
  CosinePowerDistribution(double peak_cd, double exponent) : peak_(peak_cd), exponent_(exponent) {}
  static std::shared_ptr<const IntensityDistribution> isotropic(double intensity_cd);
  [[nodiscard]] double intensity(const core::Vec3& local) const override;
  [[nodiscard]] double flux() const override { return forwardFlux(); }
  [[nodiscard]] double forwardFlux() const override { return 2 * core::pi * peak_ / (exponent_ + 1); }
  [[nodiscard]] double maximumIntensity() const override { return peak_; }
  [[nodiscard]] bool isLambertian() const override { return exponent_ == 1; }

 private:
  double peak_, exponent_;
};

/// Photometry types of LM-63: how the two angles of the table map to directions (docs/formats).
enum class PhotometryType { a, b, c };

/// A table of candelas, bilinear in its two angles ("bilinear in angle"): values at table angles are exact, and never rescaled.
/// Horizontal angles are C (type C) or H (types A, B); vertical angles are gamma (type C) or V.
class TabulatedDistribution final : public IntensityDistribution {
 public:
  /// Angles in degrees, strictly ascending; candelas[h * vertical.size() + v], finite and not negative (readers check).
  /// Symmetry is expressed by the horizontal range, as LM-63 does for type C: {0} = rotational, 0..90 = both planes,
  /// 0..180 = about the C0-C180 plane, 90..270 = about the C90-C270 plane, 0..360 = none. Outside the vertical range: 0 cd.
  TabulatedDistribution(PhotometryType type, std::vector<double> horizontal, std::vector<double> vertical,
                        std::vector<double> candelas);

  [[nodiscard]] double intensity(const core::Vec3& local) const override;
  [[nodiscard]] double flux() const override { return flux_; }
  [[nodiscard]] double forwardFlux() const override { return forwardFlux_; }
  [[nodiscard]] double maximumIntensity() const override { return maximum_; }

  [[nodiscard]] PhotometryType type() const { return type_; }
  [[nodiscard]] const std::vector<double>& horizontalAngles() const { return horizontal_; }
  [[nodiscard]] const std::vector<double>& verticalAngles() const { return vertical_; }
  /// Stored candela at table position (h, v).
  [[nodiscard]] double candela(std::size_t h, std::size_t v) const { return candelas_[h * vertical_.size() + v]; }
  /// Intensity at table angles in degrees, with symmetry applied.
  [[nodiscard]] double atAngles(double horizontalDegrees, double verticalDegrees) const;

 private:
  PhotometryType type_;
  std::vector<double> horizontal_, vertical_, candelas_;
  double flux_ = 0, forwardFlux_ = 0, maximum_ = 0;
};

}  // namespace goniolux::photometry
