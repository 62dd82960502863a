// From results and outline to a figure: what a plan map of a grid shows.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pipeline/outline.h"
#include "plot/figure.h"
#include "project/results.h"

namespace goniolux::pipeline {

struct MapOptions {
  std::vector<double> levels;  ///< empty = chosen from the values and their half-widths
  std::string palette = "viridis";
  bool banded = true;
  int width = 0, height = 0;  ///< pixels; 0 = as fits
};

/// A horizontal grid is drawn in plan (x to the right, y up) with all furniture and luminaires; another grid in its own
/// plane seen from the side that it faces, with what lies in that plane. `outline` may be null.
plot::PlanMap planMapOf(const project::Results& results, const project::GridResult& grid, const Outline* outline,
                        const MapOptions& options);

}  // namespace goniolux::pipeline
