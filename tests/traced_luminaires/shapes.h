// Surfaces that the fixtures are made of. Metres, luminaire frame (C0 = +x, C90 = +y, up = +z).
#pragma once

#include <vector>

#include "geometry/shape.h"

namespace goniolux::traced {

/// Frusta about the z axis through (radius, height) points, exact.
geometry::Shape turned(const std::vector<core::Vec2>& profile);
/// A disc perpendicular to z.
geometry::Shape disc(const core::Vec3& center, double radius);
/// Flat quadrilaterals, four corners each.
geometry::Shape quads(const std::vector<core::Vec3>& corners);
/// A rectangle about `center` with half edges u and v.
geometry::Shape rectangle(const core::Vec3& center, const core::Vec3& u, const core::Vec3& v);
/// A trough: the line of points (across, height) drawn out by `length` along x (or y), with flat ends up to z = 0 if
/// asked.
geometry::Shape trough(const std::vector<core::Vec2>& profile, double length, bool alongY, bool ends);
/// A closed cylinder about `center` along `axis` (unit).
geometry::Shape tube(const core::Vec3& center, const core::Vec3& axis, double length, double diameter);
geometry::Shape sphere(const core::Vec3& center, double radius);
/// Points of a parabola with its focus at `focus` and its axis at `degrees` from straight down towards +across, from
/// `from` to `to` degrees about the focus, counted from the axis.
std::vector<core::Vec2> parabola(const core::Vec2& focus, double focalLength, double degrees, double from, double to,
                                 int segments);

}  // namespace goniolux::traced
