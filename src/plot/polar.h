// PolarDiagram: luminous intensity against angle, as a figure (kind "polar-diagram" of "goniolux-figure", version 1)
// for the drawing helper. Gamma = 0 points down; the first half of a plane lies on the right, its opposite half on the
// left.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/document.h"

namespace goniolux::plot {

struct PolarCurve {
  std::string name;  ///< "C0–C180"
  /// (degrees, intensity): degrees from -180 to 180, ascending; gamma on the right, -gamma on the left.
  std::vector<std::pair<double, double>> points;
};

struct PolarDiagram {
  std::string title, subtitle, footer;
  std::vector<std::string> facts;
  std::string unit = "cd";
  std::vector<PolarCurve> curves;  ///< one or two
};

core::Value toJson(const PolarDiagram& diagram);
/// Throws core::InputError with positions on anything that cannot be drawn.
PolarDiagram polarDiagramFromJson(const core::Value& document);

}  // namespace goniolux::plot
