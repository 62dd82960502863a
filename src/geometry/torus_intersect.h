// Where a line meets the torus (sqrt(x^2 + y^2) - 1)^2 + z^2 = tube^2, 0 < tube < 1: a bracketed root finder, double
// precision. Thread-safe: no state.
#pragma once

#include "core/vector.h"

namespace goniolux::geometry {

/// All crossings of origin + t direction with tMin < t < tMax in ascending order: returns how many (0 to 4) were
/// written. Each lies between two points of opposite sign, so that a line from inside always comes out; where the line
/// only touches the torus there is none. The distance of a crossing from the surface is below 1e-15 times
/// max(1, |origin|) (tests/geometry/torus_intersect_test.cpp).
int intersectTorus(double tube, const core::Vec3& origin, const core::Vec3& direction, double tMin, double tMax,
                   double (&t)[4]);

}  // namespace goniolux::geometry
