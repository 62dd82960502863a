// PolarPainter: a polar diagram drawn on a page.
#pragma once

#include "plot/polar.h"
#include "plot/vtk/ink.h"

namespace goniolux::plot {

class PolarPainter {
 public:
  /// The diagram must outlive the painter. Only the lower half is drawn where hardly any light goes up.
  explicit PolarPainter(const PolarDiagram& diagram);
  [[nodiscard]] int width() const { return 1000; }
  [[nodiscard]] int height() const { return height_; }
  void paint(Ink& ink) const;

 private:
  /// Page position of an intensity at an angle (degrees, 0 down, positive to the right).
  [[nodiscard]] core::Vec2 at(double degrees, double intensity) const;
  void paintRings(Ink& ink) const;

  const PolarDiagram& diagram_;
  std::vector<double> rings_;  // ascending intensities; the last is the outermost
  double upTo_ = 180;          // degrees shown on each side
  int height_ = 0;
  core::Vec2 center_{0};
  double radius_ = 380;
};

}  // namespace goniolux::plot
