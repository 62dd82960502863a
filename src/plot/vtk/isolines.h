// Isolines and the coloured picture of a map's values, by VTK's contouring and image filters.
#pragma once

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <vector>

#include "plot/colour_scale.h"
#include "plot/figure.h"
#include "plot/grid_field.h"
#include "plot/map_layout.h"

namespace goniolux::plot {

/// A regular grid's values on a fine mesh: what both the colours and the isolines are drawn from, so that they agree.
class FineMap {
 public:
  explicit FineMap(const PlanMap& map);  ///< map.grid is set

  struct Isoline {
    double level = 0;
    Polyline points;  ///< metres in the plan
  };
  /// Lines of equal value at the levels, without the parts in excluded cells.
  [[nodiscard]] std::vector<Isoline> isolines(const std::vector<double>& levels) const;

  /// RGBA picture of the frame, `oversampling` samples per pixel in each direction; transparent beside the grid,
  /// hatched where excluded.
  [[nodiscard]] vtkSmartPointer<vtkImageData> picture(const MapLayout& layout, const ColourScale& scale,
                                                      int oversampling) const;

 private:
  [[nodiscard]] double sample(double a, double b) const;

  const PlanMap& map_;
  GridField field_;
  int nu_, nv_;  // nodes of the fine mesh
  vtkSmartPointer<vtkImageData> mesh_;
};

}  // namespace goniolux::plot
