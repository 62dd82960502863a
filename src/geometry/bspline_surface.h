// B-spline surface: a tensor-product patch over clamped uniform knots; with as many control points as degree + 1 it is
// a Bezier patch.
#pragma once

#include <vector>

#include "core/vector.h"

namespace goniolux::geometry {

class BsplineSurface {
 public:
  /// `control[i][j]`: i runs along u, j along v; every row has the same length, each more than its degree.
  BsplineSurface(std::vector<std::vector<core::Vec3>> control, int degreeU, int degreeV);

  /// The point at (u, v) in [0, 1]^2. — de Boor's algorithm
  [[nodiscard]] core::Vec3 at(double u, double v) const;

  /// Upper bounds of the second derivatives |S_uu|, |S_uv|, |S_vv| over the whole patch: a derivative is a B-spline
  /// itself, and lies in the hull of its control points.
  struct Bounds {
    double uu = 0, uv = 0, vv = 0;
  };
  [[nodiscard]] Bounds secondDerivatives() const;

  /// Pieces along u and v between which the surface is a polynomial.
  [[nodiscard]] int spansU() const { return static_cast<int>(control_.size()) - degreeU_; }
  [[nodiscard]] int spansV() const { return static_cast<int>(control_.front().size()) - degreeV_; }

 private:
  std::vector<std::vector<core::Vec3>> control_;
  int degreeU_, degreeV_;
};

}  // namespace goniolux::geometry
