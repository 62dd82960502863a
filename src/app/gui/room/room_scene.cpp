#include "app/gui/room/room_scene.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>

#include "app/gui/document/json_pointer.h"
#include "display/device.h"
#include "geometry/tessellate.h"
#include "pipeline/feature_edges.h"
#include "pipeline/outline.h"
#include "spectrum/cie_data.h"
#include "spectrum/colorimetry.h"

namespace goniolux::gui {
namespace {

using core::Vec3;

constexpr int sidesOfRoundSurfaces = 48;

/// Triangles with a colour and an object's number each.
class Surfaces {
 public:
  Surfaces() {
    colours_->SetNumberOfComponents(3);
    colours_->SetName("colour");
    objects_->SetName("object");
  }

  void add(const geometry::Mesh& mesh, const core::Mat4& place, bool turned, const std::vector<plot::Rgb>& colourOfPart,
           int object) {
    const vtkIdType first = points_->GetNumberOfPoints();
    for (const Vec3& vertex : mesh.vertices) {
      const Vec3 at(place * glm::dvec4(vertex, 1));
      points_->InsertNextPoint(at.x, at.y, at.z);
    }
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      vtkIdType corners[3] = {first + mesh.triangles[i][0], first + mesh.triangles[i][1], first + mesh.triangles[i][2]};
      if (turned) std::swap(corners[1], corners[2]);
      cells_->InsertNextCell(3, corners);
      const std::size_t part = i < mesh.parts.size() ? mesh.parts[i] : 0;
      const plot::Rgb colour = part < colourOfPart.size() ? colourOfPart[part] : plot::Rgb{160, 160, 160};
      colours_->InsertNextTypedTuple(colour.data());
      objects_->InsertNextValue(object);
    }
  }

  [[nodiscard]] vtkSmartPointer<vtkPolyData> data() const {
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points_);
    data->SetPolys(cells_);
    data->GetCellData()->SetScalars(colours_);
    data->GetCellData()->AddArray(objects_);
    return data;
  }

 private:
  vtkNew<vtkPoints> points_;
  vtkNew<vtkCellArray> cells_;
  vtkNew<vtkUnsignedCharArray> colours_;
  vtkNew<vtkIntArray> objects_;
};

vtkSmartPointer<vtkPolyData> linesOf(const std::vector<pipeline::Segment>& segments) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  for (const pipeline::Segment& segment : segments) {
    const vtkIdType ends[2] = {points->InsertNextPoint(segment.from.x, segment.from.y, segment.from.z),
                               points->InsertNextPoint(segment.to.x, segment.to.y, segment.to.z)};
    cells->InsertNextCell(2, ends);
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetLines(cells);
  return data;
}

LuminaireMark markOf(const scene::Luminaire& luminaire) {
  const pipeline::LuminaireOutline outline = pipeline::outlineOf(luminaire);
  LuminaireMark mark{luminaire.name, {}, luminaire.center, luminaire.frame.aim, outline.footprint};
  const Vec3 x = luminaire.frame.c0, y = luminaire.frame.c90;
  if (mark.footprint.empty()) {  // a point
    constexpr double r = 0.06;
    mark.footprint = {mark.position - r * x - r * y, mark.position + r * x - r * y, mark.position + r * x + r * y,
                      mark.position - r * x + r * y};
  } else if (mark.footprint.size() == 2) {  // a line
    const Vec3 along = glm::normalize(mark.footprint[1] - mark.footprint[0]);
    const Vec3 across = 0.02 * glm::normalize(glm::cross(along, luminaire.frame.aim + Vec3(1e-9, 0, 0)));
    const Vec3 a = mark.footprint[0], b = mark.footprint[1];
    mark.footprint = {a - across, b - across, b + across, a + across};
  }
  return mark;
}

/// The entry of a list of the document that stands at a place: "/objects/3".
std::string entryAt(const core::Value& root, const core::SourcePosition& position) {
  const std::vector<std::string> steps = stepsOf(pointerAt(root, position.line, position.column));
  return steps.size() < 2 ? std::string() : under(under("", steps[0]), steps[1]);
}

class Box {
 public:
  void add(vtkPolyData* data) {
    if (data->GetNumberOfPoints() == 0) return;
    double bounds[6];
    data->GetBounds(bounds);
    add({bounds[0], bounds[2], bounds[4]});
    add({bounds[1], bounds[3], bounds[5]});
  }
  void add(const Vec3& point) {
    low_ = isEmpty_ ? point : glm::min(low_, point);
    high_ = isEmpty_ ? point : glm::max(high_, point);
    isEmpty_ = false;
  }
  void write(RoomScene& scene) const {
    if (isEmpty_) return;
    scene.low = low_;
    scene.high = glm::max(high_, low_ + Vec3(1e-3));
  }

 private:
  Vec3 low_{0}, high_{0};
  bool isEmpty_ = true;
};

}  // namespace

plot::Rgb colourOf(const material::Material& material) {
  static const spectrum::SpectralDistribution daylight = *spectrum::illuminant("CIE D65");
  return colourOf(material, daylight);
}

plot::Rgb colourOf(const material::Material& material, const spectrum::SpectralDistribution& light) {
  static const display::Device srgb = display::readDevice("srgb");
  const core::Mat3 toRgb = display::rgbFromXyz(srgb, spectrum::chromaticity(spectrum::tristimulus(light)));
  // The finish's largest curve that is a reflectance or transmittance; one without any (a conductor) looks like metal.
  spectrum::Xyz colour{0.55, 0.57, 0.6};
  double brightest = -1;
  for (const auto& [key, curve] : material.spectra) {
    if (curve.range().second > 1) continue;
    const spectrum::Xyz seen = spectrum::tristimulus(curve, light);
    if (seen.Y > brightest) brightest = seen.Y, colour = seen;
  }
  const Vec3 linear = toRgb * Vec3(colour.X, colour.Y, colour.Z);
  plot::Rgb rgb{};
  for (int k = 0; k < 3; ++k) {
    const double code = srgb.transfer.front().encode(std::clamp(linear[k], 0.0, 1.0));
    rgb[static_cast<std::size_t>(k)] = static_cast<std::uint8_t>(std::lround(255 * code));
  }
  return rgb;
}

RoomScene roomSceneOf(const project::Project& project, const std::string& text) {
  RoomScene scene;
  core::Diagnostics ignored;
  const core::Value root = core::parseJson(text, project.file, ignored);
  std::vector<plot::Rgb> colours;
  for (const material::Material& material : project.environment.materials) colours.push_back(colourOf(material));

  Surfaces inward, outward;
  std::vector<pipeline::Segment> edges;
  for (std::size_t i = 0; i < project.environment.objects.size(); ++i) {
    const scene::Object& object = project.environment.objects[i];
    std::vector<plot::Rgb> colourOfPart;
    for (const std::uint32_t material : object.materials)
      colourOfPart.push_back(material < colours.size() ? colours[material] : plot::Rgb{160, 160, 160});
    const geometry::Mesh mesh = geometry::tessellate(object.shape, sidesOfRoundSurfaces);
    for (const core::Mat4& place : scene::placesOf(object))
      (object.facesInward ? inward : outward)
          .add(mesh, place, object.facesInward != (glm::determinant(core::Mat3(place)) < 0), colourOfPart,
               static_cast<int>(i));
    const std::vector<pipeline::Segment> own = pipeline::featureEdges(object);
    edges.insert(edges.end(), own.begin(), own.end());
    scene.objectPointers.push_back(entryAt(root, object.position));
  }
  scene.room = inward.data();
  scene.objects = outward.data();
  scene.edges = linesOf(edges);
  Box box;
  box.add(scene.room);
  box.add(scene.objects);
  for (const scene::Luminaire& luminaire : project.environment.luminaires) {
    LuminaireMark mark = markOf(luminaire);
    mark.pointer = entryAt(root, luminaire.position);
    box.add(mark.position);
    scene.luminaires.push_back(std::move(mark));
  }
  box.write(scene);
  return scene;
}

}  // namespace goniolux::gui
