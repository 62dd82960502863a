#include "plot/vtk/read_back.h"

#include <vtkCellType.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include "core/diagnostics.h"

namespace goniolux::plot {

namespace {

template <typename Reader>
void read(Reader& reader, const std::string& file) {
  if (reader.CanReadFile(file.c_str()) == 0)
    throw core::InputError({file}, "not-vtp", "VTK does not take this for a .vtp or .vtu file");
  reader.SetFileName(file.c_str());
  reader.Update();
  if (reader.GetErrorCode() != 0) throw core::InputError({file}, "not-vtp", "VTK cannot read this file");
}

/// How many cells have a type of VTK's.
double cellsOf(vtkPointSet* data, int type) {
  double count = 0;
  for (vtkIdType i = 0; i < data->GetNumberOfCells(); ++i) count += data->GetCellType(i) == type ? 1 : 0;
  return count;
}

}  // namespace

core::Value readBackVtp(const std::string& file) {
  core::readFile(file);  // says clearly when the file cannot be opened
  vtkNew<vtkXMLPolyDataReader> surfaces;
  vtkNew<vtkXMLUnstructuredGridReader> grids;
  const bool isGrid = file.ends_with(".vtu");
  if (isGrid)
    read(*grids, file);
  else
    read(*surfaces, file);
  vtkPolyData* surface = isGrid ? nullptr : surfaces->GetOutput();
  vtkPointSet* data = isGrid ? static_cast<vtkPointSet*>(grids->GetOutput()) : surface;

  core::Value json;
  core::Value::Array points;
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i) {
    const double* p = data->GetPoint(i);
    points.push_back(core::Value::Array{p[0], p[1], p[2]});
  }
  json.set("points", std::move(points));
  core::Value arrays = core::Value::Object{};
  for (int k = 0; k < data->GetPointData()->GetNumberOfArrays(); ++k) {
    vtkDataArray* array = data->GetPointData()->GetArray(k);
    core::Value::Array values;
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i) values.emplace_back(array->GetTuple1(i));
    arrays.set(array->GetName(), std::move(values));
  }
  json.set("arrays", arrays);
  vtkDataArray* scalars = data->GetPointData()->GetScalars();
  json.set("scalars", scalars ? scalars->GetName() : "");
  json.set("vertices", surface ? static_cast<double>(surface->GetNumberOfVerts()) : cellsOf(data, VTK_POLY_VERTEX));
  json.set("lines", surface ? static_cast<double>(surface->GetNumberOfLines()) : cellsOf(data, VTK_POLY_LINE));
  json.set("polygons", surface ? static_cast<double>(surface->GetNumberOfPolys()) : cellsOf(data, VTK_POLYGON));
  return json;
}

}  // namespace goniolux::plot
