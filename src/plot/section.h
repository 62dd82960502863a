// Section and histogram of a plan map: its values along a line, and how they are spread, as line charts.
#pragma once

#include <vector>

#include "plot/figure.h"
#include "plot/line_chart.h"

namespace goniolux::plot {

/// The values of the map's grid along the straight line from `from` to `to` (drawing coordinates, m): one curve of the
/// value and, where half-widths are given (one per point), one at each end of the intervals. Between the points runs
/// the curve that the map's colours follow (GridField). The part of the line off the grid, or where points are
/// excluded, is left out; no curves when nothing is left, or the map has no regular grid.
LineChart sectionOf(const PlanMap& map, const std::vector<double>& halfWidths, const core::Vec2& from,
                    const core::Vec2& to);

/// Share of the points, in %, in each of some twenty equal steps of round width, as a stepped curve.
LineChart histogramOf(const PlanMap& map);

}  // namespace goniolux::plot
