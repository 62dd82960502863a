// Where labels fit: along isolines, and free-standing, without covering one another. Pixels, y up.
#pragma once

#include <cstddef>
#include <vector>

#include "core/vector.h"
#include "plot/figure.h"

namespace goniolux::plot {

/// A rectangle about its centre, turned anticlockwise by `angle` (rad).
struct LabelBox {
  core::Vec2 center{0};
  double width = 0, height = 0, angle = 0;
};

bool overlap(const LabelBox& a, const LabelBox& b);

/// A label in a line: where it stands, and the part of the line (arc length from its start) that gives way to it.
struct LineLabel {
  LabelBox box;
  double from = 0, to = 0;
};

class LabelPlacement {
 public:
  /// Labels stay inside the rectangle low..high.
  LabelPlacement(core::Vec2 low, core::Vec2 high) : low_(low), high_(high) {}

  /// True if the box is inside and free.
  [[nodiscard]] bool isFree(const LabelBox& box) const { return isFree(box, true, 0); }
  void occupy(const LabelBox& box) { taken_.push_back(box); }
  /// From now on, no label stands on this line; labels of lines may, where `softly` and where there is no other place.
  /// The labels of the line with the same `owner` (not 0) may stand on it.
  void avoidLine(const Polyline& line, bool softly = false, std::size_t owner = 0);

  /// Finds places for a label of the given size along a line: the straightest ones, upright to read, at least `spacing`
  /// apart. Takes them. A line that is too short or too bent everywhere, or runs too near to others, gets none.
  std::vector<LineLabel> alongLine(const Polyline& line, double width, double height, double spacing,
                                   std::size_t owner = 0);

 private:
  core::Vec2 low_, high_;
  std::vector<LabelBox> taken_;
  struct Line {
    core::Vec2 from{0}, to{0};
    bool soft = false;
    std::size_t owner = 0;
  };
  [[nodiscard]] bool isFree(const LabelBox& box, bool mindSoftLines, std::size_t owner) const;

  std::vector<Line> lines_;
};

/// Length of a polyline, and the polyline without the parts from..to (arc lengths) that labels take.
double lengthOf(const Polyline& line);
std::vector<Polyline> withGaps(const Polyline& line, const std::vector<LineLabel>& labels);

}  // namespace goniolux::plot
