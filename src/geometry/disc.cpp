#include "geometry/disc.h"

#include <stdexcept>

#include "geometry/arguments.h"
#include "geometry/placement.h"

namespace goniolux::geometry {
namespace {

Shape make(const core::Arguments& arguments) {
  return makeDisc(requiredVector(arguments, "center"),
                  optionalVector(arguments, "normal").value_or(core::Vec3(0, 0, 1)),
                  radiusOrDiameter(arguments, "radius", "diameter"));
}

}  // namespace

Shape makeDisc(const core::Vec3& center, const core::Vec3& normal, double radius) {
  if (!(glm::length(normal) > 0)) {
    throw std::invalid_argument("the disc's \"normal\" has no length; give the direction that its front faces");
  }
  Shape shape;
  shape.partNames = {"surface"};
  shape.patches = {makeDiscPatch(center, normal, radius, 0)};
  return shape;
}

ObjectType discType() {
  core::Parameter normal = pointParameter("normal", "Normal", false, "[0, 0, 1]", "direction that the front faces");
  normal.kind = core::ParameterKind::direction;
  normal.unit = "";
  ObjectType type;
  type.name = "disc";
  type.title = "Disc";
  type.parameters = {pointParameter("center", "Centre", true, "", "centre of the disc"), normal,
                     radiusParameter("radius", "Radius", "radius; or give \"diameter\""),
                     radiusParameter("diameter", "Diameter", "diameter; or give \"radius\"")};
  type.parts = {"surface"};
  type.make = make;
  return type;
}

}  // namespace goniolux::geometry
