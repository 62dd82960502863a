#include "app/gui/room/grid_overlay.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>

#include "plot/grid_field.h"
#include "plot/levels.h"
#include "plot/vtk/isolines.h"

namespace goniolux::gui {
namespace {

using core::Vec2;
using core::Vec3;

bool isDrawable(const project::GridResult& grid) {
  return grid.counts && grid.plane &&
         std::any_of(grid.values.begin(), grid.values.end(), [](double v) { return std::isfinite(v); });
}

/// The scale that all grids share, as a map without a plan.
plot::PlanMap scaleOf(const std::vector<project::GridResult>& grids, const FalseColour& look) {
  plot::PlanMap map;
  map.palette = look.palette;
  map.banded = look.banded;
  std::vector<double> all;
  double finest = 0;
  for (const project::GridResult& grid : grids) {
    if (!isDrawable(grid)) continue;
    for (std::size_t i = 0; i < grid.values.size(); ++i)
      if (std::isfinite(grid.values[i])) all.push_back(grid.values[i]);
    finest = std::max(finest, 2 * grid.mean.halfWidth());
  }
  if (all.empty()) return map;
  const auto [low, high] = std::minmax_element(all.begin(), all.end());
  map.lowest = *low;
  map.highest = std::max(*high, *low + 1e-9);
  map.levels = look.levels.empty() ? plot::mapLevels(all, finest) : look.levels;
  return map;
}

class Builder {
 public:
  Builder(const plot::ColourScale& scale, const std::vector<double>& levels) : scale_(scale), levels_(levels) {
    colours_->SetNumberOfComponents(3);
    colours_->SetName("colour");
  }

  void add(const project::GridResult& grid) {
    const int nu = (*grid.counts)[0], nv = (*grid.counts)[1];
    const plot::GridField field(nu, nv, grid.values);
    const Vec3 lift = 0.004 * normalOf(grid);  // above a desk that it lies on
    const auto at = [&](double a, double b) {
      return grid.plane->origin + a * grid.plane->u + b * grid.plane->v + lift;
    };
    const int steps = std::clamp(160 / std::max(nu, nv), 1, 8);
    for (int j = 0; j < nv * steps; ++j)
      for (int i = 0; i < nu * steps; ++i) {
        const double a0 = static_cast<double>(i) / (nu * steps), a1 = static_cast<double>(i + 1) / (nu * steps);
        const double b0 = static_cast<double>(j) / (nv * steps), b1 = static_cast<double>(j + 1) / (nv * steps);
        const double a = (a0 + a1) / 2, b = (b0 + b1) / 2;
        if (field.isExcluded(a, b)) continue;
        const vtkIdType corners[4] = {point(quadPoints_, at(a0, b0)), point(quadPoints_, at(a1, b0)),
                                      point(quadPoints_, at(a1, b1)), point(quadPoints_, at(a0, b1))};
        quads_->InsertNextCell(4, corners);
        colours_->InsertNextTypedTuple(scale_.colour(field.at(a, b)).data());
      }
    addIsolines(grid, nu, nv, lift);
  }

  void finish(GridOverlay& overlay) const {
    overlay.colours = vtkSmartPointer<vtkPolyData>::New();
    overlay.colours->SetPoints(quadPoints_);
    overlay.colours->SetPolys(quads_);
    overlay.colours->GetCellData()->SetScalars(colours_);
    overlay.isolines = vtkSmartPointer<vtkPolyData>::New();
    overlay.isolines->SetPoints(linePoints_);
    overlay.isolines->SetLines(lines_);
  }

 private:
  static Vec3 normalOf(const project::GridResult& grid) {
    const Vec3 across = glm::cross(grid.plane->u, grid.plane->v);
    return glm::length(across) > 0 ? glm::normalize(across) : Vec3(0, 0, 1);
  }
  static vtkIdType point(vtkPoints* points, const Vec3& p) { return points->InsertNextPoint(p.x, p.y, p.z); }

  /// Drawn in fractions of the edges: a map of one by one metre.
  void addIsolines(const project::GridResult& grid, int nu, int nv, const Vec3& lift) {
    if (levels_.empty() || nu < 2 || nv < 2) return;
    plot::PlanMap map;
    map.grid = plot::MapGrid{{0, 0}, {1, 0}, {0, 1}, nu, nv};
    map.values = grid.values;
    for (const plot::FineMap::Isoline& line : plot::FineMap(map).isolines(levels_)) {
      std::vector<vtkIdType> ids;
      for (const Vec2& p : line.points)
        ids.push_back(point(linePoints_, grid.plane->origin + p.x * grid.plane->u + p.y * grid.plane->v + 2.0 * lift));
      lines_->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
    }
  }

  const plot::ColourScale& scale_;
  const std::vector<double>& levels_;
  vtkNew<vtkPoints> quadPoints_, linePoints_;
  vtkNew<vtkCellArray> quads_, lines_;
  vtkNew<vtkUnsignedCharArray> colours_;
};

}  // namespace

GridOverlay overlayOf(const std::vector<project::GridResult>& grids, const FalseColour& look) {
  GridOverlay overlay;
  if (std::none_of(grids.begin(), grids.end(), isDrawable)) return overlay;
  const plot::PlanMap map = scaleOf(grids, look);
  overlay.scale.emplace(map);
  Builder builder(*overlay.scale, map.levels);
  for (const project::GridResult& grid : grids)
    if (isDrawable(grid)) {
      builder.add(grid);
      overlay.unit = grid.unit;
    }
  builder.finish(overlay);
  return overlay;
}

}  // namespace goniolux::gui
