// GridOverlay: the grids of results as false colour and isolux lines in space, on one common scale. Made off the GUI
// thread.
#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <optional>
#include <string>
#include <vector>

#include "app/gui/plots/false_colour.h"
#include "plot/colour_scale.h"
#include "project/results.h"

namespace goniolux::gui {

struct GridOverlay {
  vtkSmartPointer<vtkPolyData> colours;    ///< quads with colours
  vtkSmartPointer<vtkPolyData> isolines;   ///< lines
  std::optional<plot::ColourScale> scale;  ///< nothing when there are no values
  std::string unit = "lx", title = "Illuminance";
};

/// Grids of single points are left out.
GridOverlay overlayOf(const std::vector<project::GridResult>& grids, const FalseColour& look);

}  // namespace goniolux::gui
