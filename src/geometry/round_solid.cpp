#include "geometry/round_solid.h"

#include <fmt/format.h>

#include <stdexcept>

#include "geometry/arguments.h"
#include "geometry/placement.h"

namespace goniolux::geometry {

Shape makeRoundSolid(const core::Vec3& base, const core::Vec3& top, double baseRadius, double topRadius, Caps caps) {
  if (!(glm::length(top - base) > 0)) {
    throw std::invalid_argument("\"base\" and \"top\" coincide; move one of them along the axis");
  }
  if (!(baseRadius > 0) && !(topRadius > 0)) {
    throw std::invalid_argument("the radius is 0 at both ends; give at least one end a radius above 0");
  }
  Shape shape;
  shape.partNames = {"side", "bottom", "top"};
  if (baseRadius == topRadius) {
    shape.patches.push_back(makeCylinderPatch(base, top, baseRadius, 0));
  } else {
    shape.patches.push_back(makeConePatch(base, top, baseRadius, topRadius, 0));
  }
  const bool capBottom = caps == Caps::both || caps == Caps::bottom;
  const bool capTop = caps == Caps::both || caps == Caps::top;
  if (capBottom && baseRadius > 0) shape.patches.push_back(makeDiscPatch(base, base - top, baseRadius, 1));
  if (capTop && topRadius > 0) shape.patches.push_back(makeDiscPatch(top, top - base, topRadius, 2));
  shape.closed = (capBottom || !(baseRadius > 0)) && (capTop || !(topRadius > 0));
  return shape;
}

Axis axisArgument(const core::Arguments& arguments) {
  const core::Vec3 base = requiredVector(arguments, "base");
  const auto top = optionalVector(arguments, "top");
  const auto height = optionalNumber(arguments, "height");
  if (top.has_value() == height.has_value()) {
    throw std::invalid_argument(
        fmt::format("give either \"top\" (the other end's centre) or \"height\"{}", top ? ", not both" : ""));
  }
  if (top) {
    if (arguments.contains("axis")) {
      throw std::invalid_argument("\"axis\" goes with \"height\"; \"top\" already says the direction: leave one out");
    }
    return {base, *top};
  }
  const core::Vec3 axis = optionalVector(arguments, "axis").value_or(core::Vec3(0, 0, 1));
  if (!(glm::length(axis) > 0)) throw std::invalid_argument("\"axis\" has no length; give a direction, e.g. [0, 0, 1]");
  return {base, base + *height * glm::normalize(axis)};
}

Caps capsArgument(const core::Arguments& arguments) {
  const std::string text = optional<std::string>(arguments, "caps").value_or("both");
  if (text == "both") return Caps::both;
  if (text == "none") return Caps::none;
  if (text == "bottom") return Caps::bottom;
  if (text == "top") return Caps::top;
  throw std::invalid_argument(fmt::format("\"caps\" is \"{}\"; it can be both, bottom, top or none", text));
}

std::vector<core::Parameter> axisParameters() {
  core::Parameter height = radiusParameter("height", "Height", "length along \"axis\"; or give \"top\"");
  core::Parameter axis =
      pointParameter("axis", "Axis", false, "", "direction from base to top, with \"height\"; [0, 0, 1] when left out");
  axis.kind = core::ParameterKind::direction;
  axis.unit = "";
  return {pointParameter("base", "Base", true, "", "centre of the bottom end"),
          pointParameter("top", "Top", false, "", "centre of the top end; or give \"height\""), height, axis};
}

core::Parameter capsParameter() {
  return {.key = std::string("caps"),
          .title = std::string("End caps"),
          .unit = {},
          .kind = core::ParameterKind::text,
          .required = false,
          .defaultText = std::string("both"),
          .help = std::string("which ends are closed: both, bottom, top or none"),
          .source = {}};
}

}  // namespace goniolux::geometry
