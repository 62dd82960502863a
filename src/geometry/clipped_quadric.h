// Where a line meets a quadric within a box: p^T form p = 0 for homogeneous p, in the cube -1 <= x, y, z <= 1, in
// closed form, double precision; and sums over its surface. Thread-safe: no state.
#pragma once

#include <cmath>

#include "core/vector.h"

namespace goniolux::geometry {

/// The value of the form at a point; its half gradient points to where it grows: the outside.
double quadricValue(const core::Mat4& form, const core::Vec3& point);
core::Vec3 quadricHalfGradient(const core::Mat4& form, const core::Vec3& point);

/// Crossings with tMin < t < tMax within the cube (slack 1e-9) in ascending order: returns how many (0, 1 or 2).
int intersectClippedQuadric(const core::Mat4& form, const core::Vec3& origin, const core::Vec3& direction, double tMin,
                            double tMax, double (&t)[4]);

/// True when the quadric is an ellipsoid that lies wholly within the cube: it bounds a volume.
bool isWholeEllipsoid(const core::Mat4& form);

/// Calls visit(point, unit normal, area element) for points spread over the surface: lines parallel to each of the
/// three axes through the middles of `steps`^2 squares. As n_x^2 + n_y^2 + n_z^2 = 1, an element dA is the sum over the
/// axes of |n_k| times its projection along axis k: no silhouette and no pole is singular. Relative error of an area
/// with 256 steps: below 1e-3 (tests/geometry/registry_test.cpp).
template <typename Visit>
void visitSurface(const core::Mat4& form, int steps, const Visit& visit) {
  const double width = 2.0 / steps;
  for (int axis = 0; axis < 3; ++axis) {
    core::Vec3 direction(0);
    direction[axis] = 1;
    for (int i = 0; i < steps; ++i) {
      for (int j = 0; j < steps; ++j) {
        core::Vec3 origin(0);
        origin[(axis + 1) % 3] = -1 + (i + 0.5) * width;
        origin[(axis + 2) % 3] = -1 + (j + 0.5) * width;
        double t[4];
        const int count = intersectClippedQuadric(form, origin, direction, -2, 2, t);
        for (int k = 0; k < count; ++k) {
          const core::Vec3 point = origin + t[k] * direction;
          const core::Vec3 gradient = quadricHalfGradient(form, point);
          const double length = glm::length(gradient);
          if (!(length > 0)) continue;  // the apex of a cone
          const core::Vec3 normal = gradient / length;
          visit(point, normal, width * width * std::abs(normal[axis]));
        }
      }
    }
  }
}

}  // namespace goniolux::geometry
