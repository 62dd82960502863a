// Closed forms of the illuminance from surfaces of uniform luminance (Lambertian), with the receiver's horizon
// respected.
#pragma once

#include <optional>
#include <span>

#include "core/vector.h"

namespace goniolux::emitter {

/// Illuminance per luminance (lx per cd/m2, the configuration factor times pi) at `point` on a plane with unit
/// `normal`, from a planar polygon with at most 16 corners, either winding. Lambert's contour formula (J. H. Lambert,
/// Photometria, 1760; Gershun 1939) on the polygon clipped at the receiver's horizon. At a point in the polygon's own
/// plane: 0.
double polygonFactor(std::span<const core::Vec3> polygon, const core::Vec3& point, const core::Vec3& normal);

/// The same from a disc with unit `axis`; nullopt where the receiver's horizon cuts the disc (no simple closed form).
/// Parallel and perpendicular components: Yamauti 1924; Howell's catalogue B-13 and B-17.
std::optional<double> discFactor(const core::Vec3& center, const core::Vec3& axis, double radius,
                                 const core::Vec3& point, const core::Vec3& normal);

/// The same from a sphere, valid wherever the point is outside; the horizon-clipped case in closed form
/// (Howell's catalogue B-43; tilted plane element to a sphere).
double sphereFactor(const core::Vec3& center, double radius, const core::Vec3& point, const core::Vec3& normal);

}  // namespace goniolux::emitter
