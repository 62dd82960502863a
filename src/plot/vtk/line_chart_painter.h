// LineChartPainter: curves over two axes, drawn on a page.
#pragma once

#include "plot/line_chart.h"
#include "plot/vtk/ink.h"

namespace goniolux::plot {

class LineChartPainter {
 public:
  /// The chart must outlive the painter. A smaller page leaves less room beside words of the same size.
  explicit LineChartPainter(const LineChart& chart, int width = 1100, int height = 800);
  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  void paint(Ink& ink) const;

 private:
  struct Range {
    double low = 0, high = 1;
    bool logarithmic = false;
    [[nodiscard]] double fraction(double value) const;
    [[nodiscard]] std::vector<double> ticks(int wanted) const;
  };
  [[nodiscard]] core::Vec2 at(const core::Vec2& point) const;
  void paintAxes(Ink& ink) const;

  const LineChart& chart_;
  int width_, height_;
  Range x_, y_;
};

}  // namespace goniolux::plot
