// PlanMapPainter: a plan map drawn on a page.
#pragma once

#include <optional>
#include <vector>

#include "plot/colour_scale.h"
#include "plot/figure.h"
#include "plot/label_placement.h"
#include "plot/map_layout.h"
#include "plot/vtk/ink.h"
#include "plot/vtk/isolines.h"

namespace goniolux::plot {

class PlanMapPainter {
 public:
  /// The map must outlive the painter.
  PlanMapPainter(const PlanMap& map, const MapLayout& layout);
  void paint(Ink& ink) const;

 private:
  void paintColours(Ink& ink) const;
  void paintDots(Ink& ink, LabelPlacement& labels) const;
  void paintIsolines(Ink& ink, LabelPlacement& labels) const;
  void paintObjects(Ink& ink) const;
  void paintLuminaires(Ink& ink) const;
  void paintExtremes(Ink& ink, LabelPlacement& labels) const;
  void paintValues(Ink& ink, LabelPlacement& labels) const;

  const PlanMap& map_;
  MapLayout layout_;
  ColourScale scale_;
  std::optional<FineMap> fine_;  // of a regular grid
  vtkSmartPointer<vtkImageData> picture_;
  std::vector<FineMap::Isoline> isolines_;  // pixels
};

/// What stands around the map: titles, axes, legend, key to the symbols, footer.
void paintTitles(Ink& ink, const PlanMap& map, const MapLayout& layout);
void paintAxes(Ink& ink, const PlanMap& map, const MapLayout& layout);
void paintLegend(Ink& ink, const PlanMap& map, const MapLayout& layout, const ColourScale& scale);

/// The symbol of a luminaire: its opening with a cross, or a crossed circle for a point.
std::vector<Polyline> luminaireStrokes(const core::Vec2& position, const Polyline& footprint);
void paintLuminaire(Ink& ink, const core::Vec2& position, const Polyline& footprint);
/// A map whose values differ by more than they are uncertain has lines, and marks at its extremes; dots carry their
/// values.
inline bool showsExtremes(const PlanMap& map) {
  return map.grid && !map.levels.empty();
}
/// The mark of the highest (a triangle upwards) or lowest value.
void paintExtreme(Ink& ink, const core::Vec2& at, bool highest);

}  // namespace goniolux::plot
