#include "app/gui/room/room_actors.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <vector>

namespace goniolux::gui {
namespace {

using core::Vec3;

vtkIdType add(vtkPoints* points, const Vec3& p) {
  return points->InsertNextPoint(p.x, p.y, p.z);
}

/// The footprint a little off the surface that it may lie in.
std::vector<Vec3> lifted(const LuminaireMark& mark) {
  std::vector<Vec3> corners = mark.footprint;
  for (Vec3& corner : corners) corner += 0.006 * mark.aim;
  return corners;
}

vtkSmartPointer<vtkPolyData> dataOf(vtkPoints* points, vtkCellArray* lines) {
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetLines(lines);
  return data;
}

}  // namespace

vtkSmartPointer<vtkActor> emptyActor() {
  auto actor = vtkSmartPointer<vtkActor>::New();
  vtkNew<vtkPolyDataMapper> mapper;
  vtkNew<vtkPolyData> nothing;
  mapper->SetInputData(nothing);
  mapper->SetStatic(1);
  actor->SetMapper(mapper);
  return actor;
}

void makeSurface(vtkActor& actor, bool insideOnly) {
  vtkProperty* look = actor.GetProperty();
  look->SetInterpolationToFlat();
  look->SetAmbient(0.42);
  look->SetDiffuse(0.62);
  look->SetSpecular(0);
  look->SetBackfaceCulling(insideOnly ? 1 : 0);
  actor.GetMapper()->SetScalarModeToUseCellData();
}

void makePlain(vtkActor& actor, const QColor& colour, float width) {
  vtkProperty* look = actor.GetProperty();
  look->SetLighting(false);
  look->SetColor(colour.redF(), colour.greenF(), colour.blueF());
  look->SetLineWidth(width);
  actor.GetMapper()->ScalarVisibilityOff();
}

void setData(vtkActor& actor, vtkPolyData* data) {
  auto* mapper = vtkPolyDataMapper::SafeDownCast(actor.GetMapper());
  if (data != nullptr) {
    mapper->SetInputData(data);
  } else {
    vtkNew<vtkPolyData> nothing;
    mapper->SetInputData(nothing);
  }
}

vtkSmartPointer<vtkPolyData> openingsOf(const RoomScene& scene) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  for (const LuminaireMark& mark : scene.luminaires) {
    std::vector<vtkIdType> ids;
    for (const Vec3& corner : lifted(mark)) ids.push_back(add(points, corner));
    cells->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(cells);
  return data;
}

vtkSmartPointer<vtkPolyData> rimsOf(const RoomScene& scene, const std::string& only) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  for (const LuminaireMark& mark : scene.luminaires) {
    if (!only.empty() && mark.pointer != only) continue;
    std::vector<vtkIdType> ids;
    for (const Vec3& corner : lifted(mark)) ids.push_back(add(points, corner));
    ids.push_back(ids.front());
    cells->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
  }
  return dataOf(points, cells);
}

vtkSmartPointer<vtkPolyData> aimsOf(const RoomScene& scene) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  const double length = 0.22 * glm::length(scene.high - scene.low) / 3 + 0.2;
  for (const LuminaireMark& mark : scene.luminaires) {
    const Vec3 tip = mark.position + length * mark.aim;
    Vec3 x, y;
    core::perpendiculars(mark.aim, x, y);
    const vtkIdType line[2] = {add(points, mark.position), add(points, tip)};
    cells->InsertNextCell(2, line);
    const double head = 0.12 * length;  // an arrow's head: where it points is to be seen from every side
    for (const Vec3& side : {x, -x, y, -y}) {
      const vtkIdType barb[2] = {line[1], add(points, tip - head * mark.aim + 0.5 * head * side)};
      cells->InsertNextCell(2, barb);
    }
  }
  return dataOf(points, cells);
}

vtkSmartPointer<vtkPolyData> boxAround(const RoomScene& scene, const std::string& pointer) {
  Vec3 low(1e300), high(-1e300);
  for (vtkPolyData* surface : {scene.room.Get(), scene.objects.Get()}) {
    auto* objects = vtkIntArray::SafeDownCast(surface->GetCellData()->GetArray("object"));
    vtkCellArray* cells = surface->GetPolys();
    for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i) {
      if (scene.objectPointers.at(static_cast<std::size_t>(objects->GetValue(i))) != pointer) continue;
      vtkIdType size = 0;
      const vtkIdType* corners = nullptr;
      cells->GetCellAtId(i, size, corners);
      for (vtkIdType k = 0; k < size; ++k) {
        double p[3];
        surface->GetPoint(corners[k], p);
        low = glm::min(low, Vec3(p[0], p[1], p[2]));
        high = glm::max(high, Vec3(p[0], p[1], p[2]));
      }
    }
  }
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  if (low.x <= high.x) {
    low -= Vec3(0.01);
    high += Vec3(0.01);
    const auto corner = [&](int k) {
      return Vec3((k & 1) != 0 ? high.x : low.x, (k & 2) != 0 ? high.y : low.y, (k & 4) != 0 ? high.z : low.z);
    };
    for (int k = 0; k < 8; ++k) add(points, corner(k));
    for (int k = 0; k < 8; ++k)
      for (const int bit : {1, 2, 4})
        if ((k & bit) == 0) {
          const vtkIdType line[2] = {k, k | bit};
          cells->InsertNextCell(2, line);
        }
  }
  return dataOf(points, cells);
}

vtkSmartPointer<vtkPolyData> lineBetween(const Vec3& from, const Vec3& to) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  const vtkIdType line[2] = {add(points, from), add(points, to)};
  cells->InsertNextCell(2, line);
  return dataOf(points, cells);
}

}  // namespace goniolux::gui
