// LineChart: curves over two axes, as a figure (kind "line-chart" of "goniolux-figure", version 1) for the drawing
// helper: intensities over an angle, errors over a distance.
#pragma once

#include <string>
#include <vector>

#include "core/document.h"
#include "core/vector.h"

namespace goniolux::plot {

struct ChartCurve {
  std::string name;
  std::vector<core::Vec2> points{};  ///< ascending in x
  bool marked = false;               ///< with a dot at every point: single measurements
};

/// Words beside a point, with a ring about it or without.
struct ChartNote {
  std::string text;
  core::Vec2 point{0};
  bool ring = true;
};

/// A dotted line at a height, from x on (0: all across), with words on it: a limit, a plateau.
struct ChartLevel {
  std::string text;
  double y = 0, from = 0;
};

struct ChartAxis {
  std::string title;  ///< with its unit: "gamma / degrees"
  bool logarithmic = false;
};

struct LineChart {
  std::string title, subtitle, footer;
  std::vector<std::string> facts;
  ChartAxis x, y;
  std::vector<ChartCurve> curves;  ///< one to six
  std::vector<ChartNote> notes{};
  std::vector<double> guides{};  ///< values of y that are drawn as grey lines: limits
  std::vector<ChartLevel> levels{};
  std::vector<core::Vec2> front{};  ///< a broad pale line behind the curves, ascending in x
  std::string frontName{};          ///< in the legend
};

core::Value toJson(const LineChart& chart);
/// Throws core::InputError with positions on anything that cannot be drawn.
LineChart lineChartFromJson(const core::Value& document);

/// 1, 2 and 5 times powers of ten within [low, high], for a logarithmic axis.
std::vector<double> decadeTicks(double low, double high);

}  // namespace goniolux::plot
