// MapLayout: where everything of a plan map stands on the page. Pixels, origin at the lower left, y up.
#pragma once

#include "core/vector.h"
#include "plot/figure.h"

namespace goniolux::plot {

struct Rectangle {
  core::Vec2 low{0}, high{0};
  [[nodiscard]] core::Vec2 size() const { return high - low; }
  [[nodiscard]] bool contains(const core::Vec2& point) const {
    return point.x >= low.x && point.y >= low.y && point.x <= high.x && point.y <= high.y;
  }
};

struct MapLayout {
  int width = 0, height = 0;
  Rectangle shown;   ///< the part of the plan that is shown, metres
  Rectangle frame;   ///< the same on the page; one scale in both directions
  double scale = 1;  ///< pixels per metre
  Rectangle legend;  ///< the colour bar alone
  [[nodiscard]] core::Vec2 toPage(const core::Vec2& metres) const { return frame.low + (metres - shown.low) * scale; }
  [[nodiscard]] core::Vec2 toPlan(const core::Vec2& pixels) const { return shown.low + (pixels - frame.low) / scale; }
};

/// Shows the whole room, or, where the grid fills less than a quarter of it in each direction, the grid and its
/// surroundings. Sizes that the figure leaves open follow from the plan's proportions.
MapLayout layoutOf(const PlanMap& map);

/// The parts of a polyline inside a rectangle.
std::vector<Polyline> clipped(const Polyline& line, const Rectangle& window);

}  // namespace goniolux::plot
