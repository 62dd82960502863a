// Writes a figure as a picture.
#pragma once

#include <string>
#include <vector>

#include "plot/figure.h"

namespace goniolux::plot {

/// Draws the map into each of the files; their endings (.png, .svg) say how. Throws CannotDraw where there is no
/// OpenGL, and core::RunError where a file cannot be written.
void drawPlanMap(const PlanMap& map, const std::vector<std::string>& files);

}  // namespace goniolux::plot
