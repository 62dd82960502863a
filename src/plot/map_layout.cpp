#include "plot/map_layout.h"

#include <algorithm>
#include <cmath>

namespace goniolux::plot {
namespace {

using core::Vec2;

// Room on the page for what stands around the plan, in pixels.
constexpr double leftMargin = 110, rightMargin = 250;
constexpr double withTitles = 165, withoutTitles = 24, withFooter = 120, withoutFooter = 76;
constexpr double legendGap = 50, legendWidth = 34;

void include(Rectangle& box, const Vec2& point) {
  box.low = glm::min(box.low, point);
  box.high = glm::max(box.high, point);
}

Rectangle shownPart(const PlanMap& map) {
  const Rectangle nothing{Vec2(1e300), Vec2(-1e300)};
  Rectangle values = nothing, room = nothing;
  for (const Vec2& point : map.points) include(values, point);
  if (map.grid) {
    const MapGrid& g = *map.grid;
    for (const Vec2& corner : {g.origin, g.origin + g.u, g.origin + g.v, g.origin + g.u + g.v}) include(values, corner);
  }
  for (const std::vector<Polyline>* lines : {&map.roomLines, &map.objectLines}) {
    for (const Polyline& line : *lines) {
      for (const Vec2& point : line) include(room, point);
    }
  }
  for (const MapLuminaire& luminaire : map.luminaires) include(room, luminaire.position);
  Rectangle shown = values;
  const double margin = 0.5 * std::max({values.size().x, values.size().y, 0.5});
  const Rectangle around{values.low - margin, values.high + margin};
  if (room.low.x <= room.high.x) {
    const bool small = values.size().x < 0.25 * room.size().x && values.size().y < 0.25 * room.size().y;
    shown = small ? Rectangle{glm::max(glm::min(room.low, values.low), around.low),
                              glm::min(glm::max(room.high, values.high), around.high)}
                  : Rectangle{glm::min(room.low, values.low), glm::max(room.high, values.high)};
  } else if (!map.grid) {
    shown = around;
  }
  // A plan without extent in one direction (a single line of points) is given some.
  const double least = std::max(0.02 * std::max(shown.size().x, shown.size().y), 1e-3);
  for (int k = 0; k < 2; ++k) {
    if (shown.high[k] - shown.low[k] < least) {
      const double middle = (shown.low[k] + shown.high[k]) / 2;
      shown.low[k] = middle - least;
      shown.high[k] = middle + least;
    }
  }
  const double rim = 0.015 * std::max(shown.size().x, shown.size().y);
  return {shown.low - rim, shown.high + rim};
}

}  // namespace

MapLayout layoutOf(const PlanMap& map) {
  MapLayout layout;
  layout.shown = shownPart(map);
  const double topMargin = map.title.empty() && map.subtitle.empty() ? withoutTitles : withTitles;
  const double bottomMargin = map.footer.empty() ? withoutFooter : withFooter;
  const Vec2 plan = layout.shown.size();
  const double largest = std::max(plan.x, plan.y);
  constexpr double wide = 1240, high = 860;  // the largest plan on a page whose size is left open
  const double open = std::min(wide / plan.x, high / plan.y);
  layout.width = map.width > 0
                     ? map.width
                     : static_cast<int>(std::lround(std::max(plan.x * open, 700.0) + leftMargin + rightMargin));
  layout.height = map.height > 0
                      ? map.height
                      : static_cast<int>(std::lround(std::max(plan.y * open, 330.0) + topMargin + bottomMargin));

  const Vec2 space(std::max(layout.width - leftMargin - rightMargin, 50.0),
                   std::max(layout.height - topMargin - bottomMargin, 50.0));
  layout.scale = std::min(space.x / plan.x, space.y / plan.y);
  if (!(largest * layout.scale > 0)) layout.scale = 1;
  const Vec2 drawn = plan * layout.scale;
  // The plan and its legend together stand in the middle of the page; the plan hangs from the titles.
  const double left = leftMargin + (space.x - drawn.x) / 2;
  const double top = layout.height - topMargin;
  layout.frame = {{std::round(left), std::round(top - drawn.y)}, {}};
  layout.frame.high = layout.frame.low + drawn;

  const double barHeight = std::clamp(drawn.y, 300.0, 620.0);
  const double barLeft = std::round(layout.frame.high.x + legendGap);
  const double barTop = layout.frame.high.y - 60;
  layout.legend = {{barLeft, std::max(barTop - barHeight + 60, bottomMargin - 60)}, {barLeft + legendWidth, barTop}};
  return layout;
}

std::vector<Polyline> clipped(const Polyline& line, const Rectangle& window) {
  std::vector<Polyline> parts;
  for (std::size_t i = 1; i < line.size(); ++i) {
    // Liang & Barsky, ACM Trans. Graph. 3(1), 1984: the part t0..t1 of the segment inside the window.
    const Vec2 a = line[i - 1], d = line[i] - a;
    double t0 = 0, t1 = 1;
    bool inside = true;
    for (int k = 0; k < 2 && inside; ++k) {
      for (const auto& [slope, room] :
           {std::pair(-d[k], a[k] - window.low[k]), std::pair(d[k], window.high[k] - a[k])}) {
        if (slope == 0) {
          inside = inside && room >= 0;
        } else if (slope < 0) {
          t0 = std::max(t0, room / slope);
        } else {
          t1 = std::min(t1, room / slope);
        }
      }
    }
    if (!inside || !(t1 > t0)) continue;
    if (parts.empty() || t0 > 0 || i == 1 || parts.back().back() != a) parts.push_back({a + d * t0});
    parts.back().push_back(a + d * t1);
  }
  return parts;
}

}  // namespace goniolux::plot
