#include "project/scene_checks.h"

#include <fmt/format.h>

#include <algorithm>

#include "geometry/bounds.h"
#include "geometry/inside.h"
#include "geometry/queries.h"
#include "reflection/bsdf.h"

namespace goniolux::project {
namespace {

using core::Vec3;
using geometry::Bounds;

/// Where people are: the inward-facing objects, or without any the whole scene.
class Rooms {
 public:
  explicit Rooms(const std::vector<scene::Object>& objects) {
    Bounds all;
    for (const scene::Object& object : objects) {
      for (const core::Mat4& place : scene::placesOf(object)) {
        const Bounds bounds = geometry::bounds(object.shape, place);
        all.add(bounds);
        if (object.facesInward) rooms_.push_back(bounds);
      }
    }
    hasRooms_ = !rooms_.empty();
    if (!hasRooms_) rooms_.push_back(all);
    // What lies on a wall is inside; a scene without walls (a single plane) has room above it.
    margin_ = 1e-6 * std::max(1e-3, glm::length(all.extent()));
  }
  [[nodiscard]] bool contain(const Vec3& point) const {
    return std::any_of(rooms_.begin(), rooms_.end(), [&](const Bounds& room) { return room.contains(point, margin_); });
  }
  [[nodiscard]] bool known() const { return hasRooms_; }

 private:
  std::vector<Bounds> rooms_;
  bool hasRooms_ = false;
  double margin_ = 0;
};

void checkGrids(const Project& project, const Rooms& rooms, core::Diagnostics& diagnostics) {
  for (const analysis::Grid& grid : project.grids) {
    const auto outside =
        std::count_if(grid.points.begin(), grid.points.end(), [&](const Vec3& p) { return !rooms.contain(p); });
    if (outside == 0) continue;
    if (static_cast<std::size_t>(outside) < grid.points.size()) {
      if (!rooms.known()) continue;
      diagnostics.warning(grid.position, "outside",
                          fmt::format("{} of {} points of the grid \"{}\" lie outside every room", outside,
                                      grid.points.size(), grid.name));
      continue;
    }
    diagnostics.error(
        grid.position, "outside",
        fmt::format("the grid \"{}\" lies wholly outside {}; check its origin, edges and the project's \"units\"",
                    grid.name, rooms.known() ? "every room" : "the scene"));
  }
}

void checkLuminaires(const Project& project, const Rooms& rooms, core::Diagnostics& diagnostics) {
  if (!rooms.known()) return;
  for (const scene::Luminaire& luminaire : project.environment.luminaires) {
    if (rooms.contain(luminaire.center)) continue;
    diagnostics.warning(
        luminaire.position, "outside",
        fmt::format("the luminaire \"{}\" stands outside every room: its light may not come in", luminaire.name));
  }
}

void checkEye(const Project& project, const Vec3& eye, const std::string& what, const core::SourcePosition& position,
              core::Diagnostics& diagnostics) {
  for (const scene::Object& object : project.environment.objects) {
    if (object.facesInward || !object.shape.closed) continue;
    const auto places = scene::placesOf(object);
    if (std::none_of(places.begin(), places.end(),
                     [&](const core::Mat4& place) { return geometry::InsideTest(object.shape, place).contains(eye); }))
      continue;
    diagnostics.error(position, "inside-object",
                      fmt::format("the eye of {} lies inside \"{}\" (line {}); move it out", what, object.name,
                                  object.position.line));
  }
}

/// Reflectances and transmittances, unlike refractive indices and the coefficients of the paper's models.
bool isShareOfLight(const material::Material& material, const std::string& key) {
  const reflection::ReflectionModel* model = reflection::findReflectionModel(material.model);
  return model != nullptr &&
         std::any_of(model->parameters.begin(), model->parameters.end(), [&](const core::Parameter& parameter) {
           return parameter.key == key && parameter.kind == core::ParameterKind::spectrum && parameter.maximum <= 1;
         });
}

void checkMaterials(const Project& project, core::Diagnostics& diagnostics) {
  for (const material::Material& material : project.environment.materials) {
    for (const auto& [key, spectrum] : material.spectra) {
      if (!(spectrum.range().first >= 1) || !isShareOfLight(material, key)) continue;
      diagnostics.warning(
          material.position, "reflects-everything",
          fmt::format("\"{}\" of \"{}\" is 1: nothing real reflects everything, and light in a room of it never dies",
                      key, material.name));
    }
  }
}

// The inside of a body of glass is where its closed shape's inside is; an open shape has none that ends.
void checkTransparentBodies(const Project& project, core::Diagnostics& diagnostics) {
  for (const scene::Object& object : project.environment.objects) {
    if (const material::Material* glass = scene::openGlassOf(project.environment, object))
      diagnostics.warning(
          object.position, "open-body",
          fmt::format("\"{}\" is of \"{}\" but not closed: it has no inside, and is refused when it comes to "
                      "calculating; close the shape, or give the material \"thickness_m\"",
                      object.name, glass->name));
  }
}

}  // namespace

void checkScene(const Project& project, core::Diagnostics& diagnostics) {
  const Rooms rooms(project.environment.objects);
  checkGrids(project, rooms, diagnostics);
  checkLuminaires(project, rooms, diagnostics);
  for (const scene::View& view : project.views) {
    checkEye(project, view.eye, "the view \"" + view.name + "\"", view.position, diagnostics);
  }
  for (const analysis::Observer& observer : project.observers) {
    checkEye(project, observer.eye, "the observer \"" + observer.name + "\"", observer.position, diagnostics);
  }
  checkMaterials(project, diagnostics);
  checkTransparentBodies(project, diagnostics);
}

}  // namespace goniolux::project
