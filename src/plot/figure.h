// Figure: everything that is drawn in one picture, as a file that the drawing helper `goniolux-plot` reads (format
// "goniolux-figure", version 1). It holds numbers and words, no pixels: what is shown is decided here, how it looks is
// decided by the helper.
//
// Kind "plan-map": the values of one grid in false colour with isolines, in the plane of the grid. Drawing coordinates
// are metres in that plane, x to the right, y up.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/document.h"
#include "core/vector.h"

namespace goniolux::plot {

using Polyline = std::vector<core::Vec2>;

/// A regular grid's cells: `counts` values per edge at cell centres, u fastest.
struct MapGrid {
  core::Vec2 origin{0}, u{1, 0}, v{0, 1};  ///< corner and full edges
  int nu = 1, nv = 1;
};

struct MapLuminaire {
  std::string name;
  core::Vec2 position{0};
  Polyline footprint;  ///< closed polygon; two points for a line, none for a point
};

struct PlanMap {
  std::string title, subtitle;     ///< e.g. the project; the grid and its quantity
  std::vector<std::string> facts;  ///< short statements under the title, e.g. "mean 512 ± 4 lx"
  std::string footer;              ///< how the picture was made
  std::string legendTitle, unit;   ///< "Illuminance", "lx"
  std::string xTitle = "x / m", yTitle = "y / m";
  int width = 0, height = 0;  ///< pixels; 0 = as the helper finds fit

  std::optional<MapGrid> grid;  ///< none: the points are drawn as dots
  std::vector<core::Vec2> points;
  std::vector<double> values;      ///< one per point; NaN = excluded
  double lowest = 0, highest = 1;  ///< the values at the ends of the palette
  std::vector<double> levels;      ///< ascending
  std::string palette = "viridis";
  bool banded = true;  ///< one colour between two levels; otherwise a smooth passage

  std::vector<Polyline> roomLines, objectLines;
  std::vector<MapLuminaire> luminaires;

  /// Other words for what the page says by itself: "in", "luminaire", "highest value", "lowest value", "not counted".
  std::map<std::string, std::string> words;
  /// The English word, or the one that stands for it.
  [[nodiscard]] const std::string& word(const std::string& english) const;
};

/// The kind of a figure: "plan-map", "polar-diagram", "line-chart" or "photometric-solid". Throws core::InputError if
/// the document is no figure of this version.
std::string figureKind(const core::Value& document);

core::Value toJson(const PlanMap& map);
/// Throws core::InputError with positions on anything that cannot be drawn.
PlanMap planMapFromJson(const core::Value& document);

/// Joins segments that share an end into polylines: fewer, and without breaks at their joints.
std::vector<Polyline> joined(const std::vector<std::pair<core::Vec2, core::Vec2>>& segments, double tolerance);

}  // namespace goniolux::plot
