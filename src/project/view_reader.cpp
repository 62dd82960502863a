#include "project/view_reader.h"

#include <fmt/format.h>

#include <cmath>

#include "project/section_reader.h"

namespace goniolux::project {
namespace {

using Projection = scene::View::Projection;

Projection projectionNamed(const std::string& name) {
  if (name == "orthographic") return Projection::orthographic;
  if (name == "fisheye-equidistant") return Projection::fisheyeEquidistant;
  if (name == "fisheye-equisolid") return Projection::fisheyeEquisolid;
  return Projection::perspective;
}

void readField(SectionReader& section, scene::View& view, Reading& reading) {
  const core::Value* given = section.find("fov");
  if (!given) {
    if (view.projection != Projection::perspective) view.verticalFov = core::pi;  // a fisheye sees half the sphere
    return;
  }
  if (view.projection == Projection::orthographic) {
    section.refuse("fov", "view-form", "an orthographic view has \"span\" (the height of the picture), no \"fov\"");
    return;
  }
  std::optional<double> degrees;
  double vertical = 0;
  if (given->isObject()) {
    SectionReader field(*given, horizontalFieldSection(), reading);
    degrees = field.failed() ? std::nullopt : field.number("horizontal");
    if (!degrees) return;
    if (view.projection == Projection::perspective && *degrees >= 180) degrees = 180;  // refused below
    vertical = *degrees >= 180 && view.projection == Projection::perspective
                   ? core::pi
                   : verticalField(*degrees * core::degree, view.projection, view.width, view.height);
  } else {
    degrees = section.number("fov");
    if (!degrees) return;
    vertical = *degrees * core::degree;
  }
  const double largest = view.projection == Projection::perspective ? core::pi : 2 * core::pi;
  if (!(vertical <= largest) || (view.projection == Projection::perspective && vertical > 179.9 * core::degree)) {
    section.refuse("fov", "out-of-range",
                   view.projection == Projection::perspective
                       ? "a perspective view sees less than 180 degrees; take a fisheye for more"
                       : "a fisheye sees at most 360 degrees");
    return;
  }
  view.verticalFov = vertical;
}

void readUp(SectionReader& section, scene::View& view) {
  const auto up = section.direction("up");
  if (section.has("up") && !up) return;
  const core::Vec3 forward = view.target - view.eye;
  if (!(glm::length(forward) > 0)) {
    section.refuse("target", "zero-vector", "\"eye\" and \"target\" coincide: the view has no direction");
    return;
  }
  view.up = up.value_or(core::Vec3(0, 0, 1));
  if (glm::length(glm::cross(glm::normalize(forward), view.up)) > 1e-6) return;
  if (up) {
    section.refuse("up", "parallel", "\"up\" points along the direction of view; give a direction across it");
  } else {
    view.up = {0, 1, 0};  // straight up or down: north is at the top, as on a plan
  }
}

}  // namespace

double verticalField(double horizontal, Projection projection, int width, int height) {
  const double aspect = static_cast<double>(height) / width;
  switch (projection) {
    case Projection::fisheyeEquidistant:
      return horizontal * aspect;
    case Projection::fisheyeEquisolid:  // the radius goes with the sine of a quarter of the whole angle
      return 4 * std::asin(std::min(1.0, std::sin(horizontal / 4) * aspect));
    default:
      return 2 * std::atan(std::tan(horizontal / 2) * aspect);
  }
}

std::vector<scene::View> readViews(const core::Value& value, Reading& reading) {
  std::vector<scene::View> views;
  if (!value.isArray()) {
    reading.error(value, "wrong-type", "\"views\" must be a list: \"views\": [ { … }, … ]");
    return views;
  }
  for (const core::Value& entry : value.array()) {
    SectionReader section(entry, viewSection(), reading);
    if (!section.isObject()) continue;
    scene::View view;
    view.position = entry.position();
    view.name = section.text("name").value_or("");
    view.projection = projectionNamed(section.choice("projection").value_or("perspective"));
    view.width = section.integer("width").value_or(view.width);
    view.height = section.integer("height").value_or(view.height);
    const auto eye = section.point("eye"), target = section.point("target");
    readField(section, view, reading);
    if (const auto span = section.length("span")) {
      view.span = *span;
      if (view.projection != Projection::orthographic) {
        section.refuse("span", "view-form", "\"span\" goes with the projection \"orthographic\"; others have \"fov\"");
      }
    } else if (view.projection == Projection::orthographic && !section.has("span")) {
      section.refuse("span", "missing-key", "an orthographic view needs \"span\", the height of the picture");
    }
    if (!eye || !target) continue;
    view.eye = *eye;
    view.target = *target;
    readUp(section, view);
    views.push_back(std::move(view));
  }
  return views;
}

}  // namespace goniolux::project
