#include "plot/vtk/isolines.h"

#include <vtkCellArray.h>
#include <vtkFlyingEdges2D.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStripper.h>

#include <algorithm>
#include <cmath>

#include "plot/vtk/ink.h"

namespace goniolux::plot {
namespace {

using core::Vec2;

/// Fine steps per cell: enough for smooth lines, few enough to be quick.
int stepsPerCell(const MapGrid& grid) {
  return std::clamp(480 / std::max(grid.nu, grid.nv), 1, 16);
}

/// The parts of a line outside excluded cells; its points are fractions of the grid's edges.
std::vector<Polyline> outsideExcluded(const Polyline& line, const GridField& field) {
  std::vector<Polyline> parts(1);
  for (const Vec2& point : line) {
    // Points on a cell's rim belong to either side: look a little to both.
    const bool excluded = field.isExcluded(point.x, point.y);
    if (!excluded) {
      parts.back().push_back(point);
    } else if (!parts.back().empty()) {
      parts.emplace_back();
    }
  }
  std::erase_if(parts, [](const Polyline& part) { return part.size() < 2; });
  return parts;
}

}  // namespace

FineMap::FineMap(const PlanMap& map) : map_(map), field_(map.grid->nu, map.grid->nv, map.values) {
  const int steps = stepsPerCell(*map.grid);
  nu_ = map.grid->nu * steps + 1;
  nv_ = map.grid->nv * steps + 1;
  mesh_ = vtkSmartPointer<vtkImageData>::New();
  mesh_->SetDimensions(nu_, nv_, 1);
  mesh_->SetSpacing(1.0 / (nu_ - 1), 1.0 / (nv_ - 1), 1);
  mesh_->AllocateScalars(VTK_DOUBLE, 1);
  auto* values = static_cast<double*>(mesh_->GetScalarPointer());
  for (int j = 0; j < nv_; ++j) {
    for (int i = 0; i < nu_; ++i) {
      *values++ = field_.at(static_cast<double>(i) / (nu_ - 1), static_cast<double>(j) / (nv_ - 1));
    }
  }
}

double FineMap::sample(double a, double b) const {
  const double x = std::clamp(a, 0.0, 1.0) * (nu_ - 1), y = std::clamp(b, 0.0, 1.0) * (nv_ - 1);
  const int i = std::min(static_cast<int>(x), nu_ - 2), j = std::min(static_cast<int>(y), nv_ - 2);
  const double fx = x - i, fy = y - j;
  const double* at = static_cast<const double*>(mesh_->GetScalarPointer()) + static_cast<std::ptrdiff_t>(j) * nu_ + i;
  return (1 - fy) * ((1 - fx) * at[0] + fx * at[1]) + fy * ((1 - fx) * at[nu_] + fx * at[nu_ + 1]);
}

std::vector<FineMap::Isoline> FineMap::isolines(const std::vector<double>& levels) const {
  std::vector<Isoline> lines;
  for (const double level : levels) {
    vtkNew<vtkFlyingEdges2D> contour;
    contour->SetInputData(mesh_);
    contour->SetValue(0, level);
    contour->ComputeScalarsOff();
    vtkNew<vtkStripper> stripper;
    stripper->SetInputConnection(contour->GetOutputPort());
    stripper->SetMaximumLength(1000000);
    stripper->JoinContiguousSegmentsOn();
    stripper->Update();
    vtkPolyData* output = stripper->GetOutput();
    vtkNew<vtkIdList> cell;
    vtkCellArray* strips = output->GetLines();
    for (strips->InitTraversal(); strips->GetNextCell(cell) != 0;) {
      Polyline fractions;
      for (vtkIdType k = 0; k < cell->GetNumberOfIds(); ++k) {
        const double* p = output->GetPoint(cell->GetId(k));
        fractions.emplace_back(p[0], p[1]);
      }
      for (Polyline& part : outsideExcluded(fractions, field_)) {
        for (Vec2& p : part) p = map_.grid->origin + map_.grid->u * p.x + map_.grid->v * p.y;
        lines.push_back({level, std::move(part)});
      }
    }
  }
  return lines;
}

vtkSmartPointer<vtkImageData> FineMap::picture(const MapLayout& layout, const ColourScale& scale,
                                               int oversampling) const {
  const Vec2 size = layout.frame.size();
  const int width = std::max(1, static_cast<int>(std::lround(size.x * oversampling)));
  const int height = std::max(1, static_cast<int>(std::lround(size.y * oversampling)));
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(width, height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  auto* pixel = static_cast<unsigned char*>(image->GetScalarPointer());

  const MapGrid& grid = *map_.grid;
  const double area = grid.u.x * grid.v.y - grid.u.y * grid.v.x;
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column, pixel += 4) {
      const Vec2 fraction((column + 0.5) / width, (row + 0.5) / height);
      const Vec2 d = layout.shown.low + layout.shown.size() * fraction - grid.origin;
      const double a = (d.x * grid.v.y - d.y * grid.v.x) / area, b = (grid.u.x * d.y - grid.u.y * d.x) / area;
      Rgb colour = white;
      const bool inside = a >= 0 && a <= 1 && b >= 0 && b <= 1;
      if (inside && field_.isExcluded(a, b)) {
        const int stripe = (column + row) % (9 * oversampling);
        colour = stripe < oversampling + oversampling / 2 ? Rgb{0x9a, 0x9a, 0x9a} : Rgb{0xec, 0xec, 0xec};
      } else if (inside) {
        colour = scale.colour(sample(a, b));
      }
      std::copy(colour.begin(), colour.end(), pixel);
      pixel[3] = inside ? 255 : 0;
    }
  }
  return image;
}

}  // namespace goniolux::plot
