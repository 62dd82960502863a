#include "plot/section.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "plot/grid_field.h"
#include "plot/number_text.h"

namespace goniolux::plot {
namespace {

using core::Vec2;

constexpr int samplesOfSection = 240;
constexpr double wantedSteps = 20;

/// 1, 2 or 5 times a power of ten, nearest above.
double roundStep(double width) {
  const double power = std::pow(10, std::floor(std::log10(width)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * power >= width * (1 - 1e-9)) return factor * power;
  return 10 * power;
}

std::string valueTitle(const PlanMap& map) {
  return map.unit.empty() ? map.legendTitle : map.legendTitle + " / " + map.unit;
}

}  // namespace

LineChart sectionOf(const PlanMap& map, const std::vector<double>& halfWidths, const Vec2& from, const Vec2& to) {
  LineChart chart;
  chart.title = map.title;
  chart.subtitle = map.subtitle;
  chart.facts = {fmt::format("section from ({:.2f}, {:.2f}) m to ({:.2f}, {:.2f}) m", from.x, from.y, to.x, to.y)};
  chart.footer = map.footer;
  chart.x.title = "distance along the line / m";
  chart.y.title = valueTitle(map);
  if (!map.grid) return chart;
  const MapGrid& grid = *map.grid;
  const double area = grid.u.x * grid.v.y - grid.u.y * grid.v.x;
  if (area == 0) return chart;
  const bool hasIntervals = halfWidths.size() == map.values.size();
  std::vector<double> low, high;
  if (hasIntervals)
    for (std::size_t i = 0; i < map.values.size(); ++i) {
      low.push_back(map.values[i] - halfWidths[i]);
      high.push_back(map.values[i] + halfWidths[i]);
    }
  const GridField value(grid.nu, grid.nv, map.values);
  const GridField least(grid.nu, grid.nv, hasIntervals ? low : map.values);
  const GridField most(grid.nu, grid.nv, hasIntervals ? high : map.values);
  ChartCurve middle{map.legendTitle}, lower{"lower end"}, upper{"upper end"};
  double smallest = INFINITY, largest = -INFINITY;
  for (int i = 0; i <= samplesOfSection; ++i) {
    const double share = static_cast<double>(i) / samplesOfSection;
    const Vec2 at = from + share * (to - from) - grid.origin;
    const double a = (at.x * grid.v.y - at.y * grid.v.x) / area, b = (grid.u.x * at.y - grid.u.y * at.x) / area;
    if (a < 0 || a > 1 || b < 0 || b > 1 || value.isExcluded(a, b)) continue;
    const double distance = share * glm::length(to - from), found = value.at(a, b);
    middle.points.emplace_back(distance, found);
    lower.points.emplace_back(distance, least.at(a, b));
    upper.points.emplace_back(distance, most.at(a, b));
    smallest = std::min(smallest, found);
    largest = std::max(largest, found);
  }
  if (middle.points.size() < 2) return chart;
  chart.facts.push_back(fmt::format("{} to {} {}", pointText(smallest), pointText(largest), map.unit));
  chart.curves.push_back(std::move(middle));
  if (hasIntervals) {
    chart.curves.push_back(std::move(lower));
    chart.curves.push_back(std::move(upper));
  }
  return chart;
}

LineChart histogramOf(const PlanMap& map) {
  LineChart chart;
  chart.title = map.title;
  chart.subtitle = map.subtitle;
  chart.facts = map.facts;
  chart.footer = map.footer;
  chart.x.title = valueTitle(map);
  chart.y.title = "share of the points / %";
  std::vector<double> values;
  for (const double v : map.values)
    if (std::isfinite(v)) values.push_back(v);
  if (values.empty()) return chart;
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const double range = *high - *low;
  const double step = roundStep(range > 0 ? range / wantedSteps : std::max(std::abs(*high), 1.0) / wantedSteps);
  const double first = std::floor(*low / step);
  std::vector<std::size_t> counts(static_cast<std::size_t>(std::floor(*high / step) - first) + 1);
  for (const double v : values)
    ++counts[std::min(static_cast<std::size_t>(std::max(std::floor(v / step) - first, 0.0)), counts.size() - 1)];
  ChartCurve curve{fmt::format("of {} points, in steps of {} {}", values.size(), levelText(step), map.unit)};
  curve.points.emplace_back(first * step, 0);
  for (std::size_t k = 0; k < counts.size(); ++k) {
    const double share = 100.0 * static_cast<double>(counts[k]) / static_cast<double>(values.size());
    curve.points.emplace_back((first + static_cast<double>(k)) * step, share);
    curve.points.emplace_back((first + static_cast<double>(k) + 1) * step, share);
  }
  curve.points.emplace_back((first + static_cast<double>(counts.size())) * step, 0);
  chart.curves.push_back(std::move(curve));
  return chart;
}

}  // namespace goniolux::plot
