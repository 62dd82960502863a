// Reference values written for this suite: closed forms from their sources, and plain quadrature where there is none.
// Nothing here uses the code that is being validated. Metres, radians; a luminance of 1 cd/m2 or as said.
#pragma once

#include "core/vector.h"

namespace goniolux::validation {

/// Abscissae in (0, 1) and weights of the eight points of Gauss on [-1, 1]: half of them, the others are their mirror
/// images (Abramowitz and Stegun, table 25.4).
inline constexpr double gaussNodes[] = {0.1834346424956498, 0.5255324099163290, 0.7966664774136267, 0.9602898564975363};
inline constexpr double gaussWeights[] = {0.3626837833783620, 0.3137066458778873, 0.2223810344533745,
                                          0.1012285362903763};

/// E / L at `point` on a plane with unit `normal` from a parallelogram of uniform luminance: the double integral of
/// cos cos' / d^2 by Gauss quadrature on patches that are cut until they are small against their distance. The
/// parallelogram must lie wholly above the receiver's horizon.
double parallelogramFactor(const core::Vec3& corner, const core::Vec3& u, const core::Vec3& v, const core::Vec3& point,
                           const core::Vec3& normal);

/// The same from a disc of radius a at distance d, r off its axis; the receiver is parallel to it (Yamauti 1924).
double discParallel(double a, double d, double r);
/// The receiver is perpendicular to the disc and faces its axis, r >= a.
double discPerpendicular(double a, double d, double r);

/// The same from a sphere that is seen under the half angle `halfAngle`, its centre `tilt` off the normal; what lies
/// under the horizon does not count. Integral over the cone: closed in azimuth, Simpson's rule across it.
double sphereFactor(double halfAngle, double tilt);

/// Illuminance from a Lambertian line of length l with `perMetre` cd/m across: a plane parallel to it and facing it at
/// distance d before its centre, before one end, and a plane perpendicular to it under that end.
double lineBeforeCentre(double l, double d, double perMetre);
double lineBeforeEnd(double l, double d, double perMetre);
double lineAcrossEnd(double l, double d, double perMetre);

/// Illuminance under one end of a tube (radius R, length l, luminance L) at h from its axis, plane facing it: strips
/// of the visible half, each in closed form along its length.
double tubeUnderEnd(double radius, double l, double luminance, double h);

/// Solid angle over one face a x b of a box, seen from `h` before its centre.
double rectangleSolidAngle(double a, double b, double h);
/// The same seen from before the point (x, y) of the face, counted from a corner.
double rectangleSolidAngle(double a, double b, double h, double x, double y);

}  // namespace goniolux::validation
