// Drawings of the report as SVG: the plan with luminaires, and polar diagrams.
#pragma once

#include <string>

#include "report/report.h"
#include "report/words.h"

namespace goniolux::report {

/// The plan to scale, with the luminaires' letters, calculation areas and a scale bar. "" without any line.
std::string planSvg(const Plan& plan, const Words& words);

/// Luminous intensity over angle, as on a maker's data sheet: gamma = 0 points down.
std::string polarSvg(const plot::PolarDiagram& diagram, const Words& words);

}  // namespace goniolux::report
