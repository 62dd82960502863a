#include "app/gui/room/room_actors.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkShaderProperty.h>
#include <vtkUniforms.h>

#include <algorithm>
#include <cmath>
#include <utility>
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

/// m; a part of the room.
double lengthOfAims(const RoomScene& scene) {
  return std::min(0.22 * glm::length(scene.high - scene.low) / 3 + 0.2, 2.0);
}

/// Half-planes C every 30 degrees with a point every 5, and rings of gamma every 30.
void addSolid(const LuminaireMark& mark, double reach, vtkPoints* points, vtkCellArray* cells) {
  constexpr int planes = 12, gammas = 37, fine = 72;
  double strongest = 0;
  const auto intensity = [&](double c, double gamma) {
    const Vec3 local(std::sin(gamma) * std::cos(c), std::sin(gamma) * std::sin(c), std::cos(gamma));
    return mark.distribution ? mark.distribution->intensity(local) : std::max(0.0, local.z);
  };
  for (int i = 0; i < 2 * planes; ++i)
    for (int j = 0; j < gammas; ++j)
      strongest = std::max(strongest, intensity(core::pi / planes * i, core::pi / (gammas - 1) * j));
  if (!(strongest > 0)) return;
  const auto curve = [&](int count, const auto& anglesAt) {
    std::vector<vtkIdType> ids;
    for (int k = 0; k < count; ++k) {
      const auto [c, gamma] = anglesAt(k);
      const Vec3 direction = std::sin(gamma) * std::cos(c) * mark.frame.c0 +
                             std::sin(gamma) * std::sin(c) * mark.frame.c90 + std::cos(gamma) * mark.frame.aim;
      ids.push_back(add(points, mark.position + reach * intensity(c, gamma) / strongest * direction));
    }
    cells->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
  };
  for (int i = 0; i < planes; ++i)
    curve(gammas, [&](int k) { return std::pair(2 * core::pi / planes * i, core::pi / (gammas - 1) * k); });
  for (int j = 1; j < 6; ++j)
    curve(fine + 1, [&](int k) { return std::pair(2 * core::pi / fine * k, core::pi / 6 * j); });
}

void addRim(const LuminaireMark& mark, vtkPoints* points, vtkCellArray* cells) {
  std::vector<vtkIdType> ids;
  for (const Vec3& corner : lifted(mark)) ids.push_back(add(points, corner));
  ids.push_back(ids.front());
  cells->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
}

void addBox(const geometry::Bounds& box, vtkPoints* points, vtkCellArray* cells) {
  if (box.empty()) return;
  const Vec3 low = box.min - Vec3(0.01), high = box.max + Vec3(0.01);
  const vtkIdType first = points->GetNumberOfPoints();
  for (int k = 0; k < 8; ++k)
    add(points, Vec3((k & 1) != 0 ? high.x : low.x, (k & 2) != 0 ? high.y : low.y, (k & 4) != 0 ? high.z : low.z));
  for (int k = 0; k < 8; ++k)
    for (const int bit : {1, 2, 4})
      if ((k & bit) == 0) {
        const vtkIdType line[2] = {first + k, first + (k | bit)};
        cells->InsertNextCell(2, line);
      }
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

void makeSurface(vtkActor& actor, bool frontOnly) {
  vtkProperty* look = actor.GetProperty();
  look->SetInterpolationToFlat();
  look->SetAmbient(0.42);
  look->SetDiffuse(0.62);
  look->SetSpecular(0);
  look->SetBackfaceCulling(frontOnly ? 1 : 0);
}

// VTK moves coincident lines by writing the depth of every fragment, which keeps software OpenGL from leaving out what
// is hidden: it draws everything several times slower. A vertex can be moved for nothing.
void makeForward(vtkActor& actor) {
  actor.GetShaderProperty()->AddVertexShaderReplacement(
      "//VTK::PositionVC::Impl", true, "//VTK::PositionVC::Impl\n  gl_Position.z -= forward;\n", false);
  drawForward(actor, 0);
}

void drawForward(vtkActor& actor, double depth) {
  actor.GetShaderProperty()->GetVertexCustomUniforms()->SetUniformf("forward", static_cast<float>(depth));
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

vtkSmartPointer<vtkPolyData> rimsOf(const RoomScene& scene) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  for (const LuminaireMark& mark : scene.luminaires) addRim(mark, points, cells);
  return dataOf(points, cells);
}

vtkSmartPointer<vtkPolyData> aimsOf(const RoomScene& scene) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  const double length = lengthOfAims(scene);
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

vtkSmartPointer<vtkPolyData> marksOf(const RoomScene& scene, const std::vector<std::string>& pointers) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  for (const std::string& pointer : pointers) {
    for (const LuminaireMark& mark : scene.luminaires)
      if (mark.pointer == pointer) addRim(mark, points, cells);
    if (const auto entry = scene.entries.find(pointer); entry != scene.entries.end())
      addBox(entry->second.box, points, cells);
  }
  return dataOf(points, cells);
}

vtkSmartPointer<vtkPolyData> solidsOf(const RoomScene& scene, const std::vector<std::string>& pointers) {
  constexpr int most = 60;
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  int drawn = 0;
  for (const LuminaireMark& mark : scene.luminaires)
    if (drawn < most && std::find(pointers.begin(), pointers.end(), mark.pointer) != pointers.end()) {
      addSolid(mark, lengthOfAims(scene), points, cells);
      ++drawn;
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
