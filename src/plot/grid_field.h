// GridField: the values of a regular grid as a continuous function, for drawing between the points.
//
// Along each direction a monotone cubic (Fritsch & Butland, SIAM J. Sci. Stat. Comput. 5, 1984): it goes through every
// value and never beyond its neighbours, so that a picture shows no maximum that was not calculated. Within half a cell
// of the grid's edge the outermost value is kept. Immutable, thread safe.
#pragma once

#include <vector>

namespace goniolux::plot {

class GridField {
 public:
  /// `values` run u fastest, nu * nv of them; NaN where a point is excluded (at least one is a number).
  GridField(int nu, int nv, std::vector<double> values);

  /// The value at fractions (a, b) of the grid's edges u and v. Excluded points lend their neighbours' mean.
  [[nodiscard]] double at(double a, double b) const;
  /// True where the cell around the nearest point is excluded.
  [[nodiscard]] bool isExcluded(double a, double b) const;

  [[nodiscard]] int nu() const { return nu_; }
  [[nodiscard]] int nv() const { return nv_; }

 private:
  int nu_, nv_;
  std::vector<double> values_;
  std::vector<bool> excluded_;
  double lowest_ = 0, highest_ = 0;
};

}  // namespace goniolux::plot
