#include "plot/vtk/read_back.h"

#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include "core/diagnostics.h"

namespace goniolux::plot {

core::Value readBackVtp(const std::string& file) {
  core::readFile(file);  // says clearly when the file cannot be opened
  vtkNew<vtkXMLPolyDataReader> reader;
  if (reader->CanReadFile(file.c_str()) == 0) {
    throw core::InputError({file}, "not-vtp", "VTK does not take this for a .vtp file");
  }
  reader->SetFileName(file.c_str());
  reader->Update();
  if (reader->GetErrorCode() != 0) throw core::InputError({file}, "not-vtp", "VTK cannot read this file");
  vtkPolyData* data = reader->GetOutput();

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
  json.set("vertices", static_cast<double>(data->GetNumberOfVerts()));
  json.set("lines", static_cast<double>(data->GetNumberOfLines()));
  json.set("polygons", static_cast<double>(data->GetNumberOfPolys()));
  return json;
}

}  // namespace goniolux::plot
