// IntensityDistribution: luminous intensity I(C, gamma) of a luminaire as a function on the sphere, in cd.
//
// Luminaire frame (declared here, once): a direction is given by its components along C0 (x), C90 (y) and gamma = 0,
// the aim (z). In world space C90 = c0 x aim, so that with aim -z and c0 +x the angle C turns anticlockwise seen from
// above. The triple (C0, C90, aim) is therefore left-handed; it is only ever used through dot products.
#pragma once

#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
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
  [[nodiscard]] core::Vec3 toWorld(const core::Vec3& local) const {
    return c0 * local.x + c90 * local.y + aim * local.z;
  }
};

/// Bounds of how the intensity changes about a direction, cd.
struct IntensityVariation {
  double first = 0;  ///< of the difference to any direction within an angle of it
  double even = 0;   ///< of the mean of the differences to two directions that lie opposite each other about it
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
  /// I(gamma) = I0 cos(gamma) for gamma < 90 and 0 beyond: a flat opening then has uniform luminance, and closed forms
  /// apply.
  [[nodiscard]] virtual bool isLambertian() const { return false; }
  /// Bounds within `angle` (radians, small) of a unit direction of the luminaire frame; nothing where none are known.
  [[nodiscard]] virtual std::optional<IntensityVariation> variation(const core::Vec3& /*local*/,
                                                                    double /*angle*/) const {
    return std::nullopt;
  }
};

/// I = I0 cos^n(gamma) for gamma <= 90 degrees, 0 beyond.
class CosinePowerDistribution final : public IntensityDistribution {
 public:
  CosinePowerDistribution(double peak_cd, double exponent) : peak_(peak_cd), exponent_(exponent) {}
  /// The same intensity in all directions of the whole sphere.
  static std::shared_ptr<const IntensityDistribution> isotropic(double intensity_cd);
  [[nodiscard]] double intensity(const core::Vec3& local) const override;
  [[nodiscard]] double flux() const override { return forwardFlux(); }
  [[nodiscard]] double forwardFlux() const override { return 2 * core::pi * peak_ / (exponent_ + 1); }
  [[nodiscard]] double maximumIntensity() const override { return peak_; }
  [[nodiscard]] bool isLambertian() const override { return exponent_ == 1; }

 private:
  double peak_, exponent_;
};

/// Photometry types of LM-63: how the two angles of the table map to directions of the luminaire frame (x, y, z) = (C0,
/// C90, aim).
///   c: x = sin(gamma) cos(C), y = sin(gamma) sin(C), z = cos(gamma)
///   b: x = sin(H),            y = sin(V) cos(H),     z = cos(V) cos(H)     polar axis along C0
///   a: x = cos(V) sin(H),     y = sin(V),            z = cos(V) cos(H)     polar axis along C90
enum class PhotometryType { a, b, c };

/// How the table's horizontal angles cover the sphere.
enum class HorizontalSymmetry {
  rotational,  ///< type C, one plane
  quadrant,    ///< type C, 0..90: both principal planes are mirrors
  aboutC0,     ///< type C, 0..180: the C0-C180 plane is a mirror
  aboutC90,    ///< type C, 90..270: the C90-C270 plane is a mirror
  none,  ///< type C, from 0 to 360 or to the last plane before it (the gap is closed with plane 0); types A, B: from H
         ///< < 0
  lateral  ///< types A, B: from H = 0, which is a mirror
};

/// How many copies of the stated horizontal range make the whole; 1 for rotational, whose one plane stands for 2 pi.
double symmetryCopies(HorizontalSymmetry symmetry);

/// The symmetry that the horizontal angles (degrees, ascending) of a table stand for; empty when they cover the sphere
/// in no known way.
std::optional<HorizontalSymmetry> horizontalSymmetry(PhotometryType type, const std::vector<double>& horizontal);

/// Ascending angles in degrees with a constant-time search for the interval that holds an angle.
class AngleAxis {
 public:
  struct Place {
    std::size_t index;  ///< of the angle at or below
    double fraction;    ///< 0 at `index`, 1 at `index + 1`
  };
  explicit AngleAxis(std::vector<double> degrees);
  /// Angles outside the range are taken as the nearest end.
  [[nodiscard]] Place find(double degrees) const;
  [[nodiscard]] const std::vector<double>& degrees() const { return degrees_; }
  [[nodiscard]] double first() const { return degrees_.front(); }
  [[nodiscard]] double last() const { return degrees_.back(); }

 private:
  std::vector<double> degrees_, inverseSteps_;
  std::vector<std::uint32_t> firstInterval_;  // per bin of equal width: the interval that holds the bin's lower edge
  double binsPerDegree_ = 0;
};

/// A table of candelas, bilinear in its two angles ("bilinear in angle"): values at table angles are exact, and never
/// rescaled. Horizontal angles are C (type C) or H (types A, B); vertical angles are gamma (type C) or V. Where planes
/// disagree about a pole, the value depends on the plane from which the pole is approached.
class TabulatedDistribution final : public IntensityDistribution {
 public:
  /// Angles in degrees, strictly ascending; candelas[h * vertical.size() + v], finite and not negative; the horizontal
  /// angles have a horizontalSymmetry(). Readers check; here it is asserted. Outside the vertical range: 0 cd; for
  /// types A and B also outside the horizontal range.
  TabulatedDistribution(PhotometryType type, std::vector<double> horizontal, std::vector<double> vertical,
                        std::vector<double> candelas);

  [[nodiscard]] double intensity(const core::Vec3& local) const override;
  [[nodiscard]] double flux() const override { return flux_; }
  [[nodiscard]] double forwardFlux() const override { return forwardFlux_; }
  [[nodiscard]] double maximumIntensity() const override { return maximum_; }
  /// Of type C, from the slopes of the cells that the angle reaches; nothing where it reaches the end of the table.
  [[nodiscard]] std::optional<IntensityVariation> variation(const core::Vec3& local, double angle) const override;

  [[nodiscard]] PhotometryType type() const { return type_; }
  [[nodiscard]] HorizontalSymmetry symmetry() const { return symmetry_; }
  /// The angles as stated, without a closing plane.
  [[nodiscard]] const std::vector<double>& horizontalAngles() const { return stated_; }
  [[nodiscard]] const std::vector<double>& verticalAngles() const { return vertical_.degrees(); }
  /// Stored candela at table position (h, v).
  [[nodiscard]] double candela(std::size_t h, std::size_t v) const {
    return candelas_[h * verticalAngles().size() + v];
  }
  /// Intensity at table angles in degrees, with symmetry applied.
  [[nodiscard]] double atAngles(double horizontalDegrees, double verticalDegrees) const;

  /// Exact integral of the interpolant over vertical angles `from` to `to` (degrees; type C: a zone of gamma), all
  /// horizontal angles, lm.
  [[nodiscard]] double verticalBandFlux(double from, double to) const;

 private:
  /// Horizontal angle brought into the stated range by wrap and symmetry.
  [[nodiscard]] double fold(double horizontalDegrees) const;
  /// Integral over the part of the table within the given angles, symmetric copies included.
  [[nodiscard]] double integrate(double horizontalFrom, double horizontalTo, double verticalFrom,
                                 double verticalTo) const;

  PhotometryType type_;
  HorizontalSymmetry symmetry_;
  std::vector<double> stated_;
  AngleAxis horizontal_, vertical_;  // horizontal with the closing plane at 360, if the file leaves it out
  std::vector<double> candelas_;
  double flux_ = 0, forwardFlux_ = 0, maximum_ = 0;
};

}  // namespace goniolux::photometry
