#include "app/gui/room/room_scene.h"

#include <algorithm>
#include <cmath>

#include "app/gui/document/json_pointer.h"
#include "display/device.h"
#include "geometry/queries.h"
#include "geometry/tessellate.h"
#include "pipeline/outline.h"
#include "spectrum/cie_data.h"
#include "spectrum/colorimetry.h"

namespace goniolux::gui {
namespace {

using core::Vec3;

constexpr int sidesOfRoundSurfaces = 48;

LuminaireMark markOf(const scene::Luminaire& luminaire) {
  const pipeline::LuminaireOutline outline = pipeline::outlineOf(luminaire);
  LuminaireMark mark{
      luminaire.name,        {}, luminaire.center, luminaire.frame.aim, outline.footprint, luminaire.frame,
      luminaire.distribution};
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

/// Enters the boxes of an object into the scene; gives the diagonal of one place's.
double addPlaces(RoomScene& scene, const scene::Object& object, const std::string& pointer) {
  double size = 0;
  for (const core::Mat4& place : scene::placesOf(object)) {
    const geometry::Bounds box = geometry::bounds(object.shape, place);
    scene.entries.try_emplace(pointer, EntryPlace{box, box.center(), object.facesInward}).first->second.box.add(box);
    size = std::max(size, glm::length(box.extent()));
  }
  return size;
}

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

  SurfaceList inward, outward;
  std::vector<std::pair<double, std::vector<pipeline::Segment>>> edges;  // with the size of what they bound
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
    scene.objectPointers.push_back(entryAt(root, object.position));
    edges.emplace_back(addPlaces(scene, object, scene.objectPointers.back()), pipeline::featureEdges(object));
  }
  scene.room = inward.whole();
  scene.objects = outward.pieces();
  std::stable_sort(edges.begin(), edges.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<pipeline::Segment> lines;
  for (const auto& [size, own] : edges) lines.insert(lines.end(), own.begin(), own.end());
  scene.edges = linePieces(lines);
  geometry::Bounds box;
  for (const auto& [pointer, entry] : scene.entries) box.add(entry.box);
  for (const scene::Luminaire& luminaire : project.environment.luminaires) {
    LuminaireMark mark = markOf(luminaire);
    mark.pointer = entryAt(root, luminaire.position);
    box.add(mark.position);
    scene.luminaires.push_back(std::move(mark));
  }
  if (!box.empty()) {
    scene.low = box.min;
    scene.high = glm::max(box.max, box.min + Vec3(1e-3));
  }
  return scene;
}

}  // namespace goniolux::gui
