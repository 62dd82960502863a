#include "geometry/cylinder.h"

#include "geometry/arguments.h"
#include "geometry/round_solid.h"

namespace goniolux::geometry {
namespace {

Shape make(const core::Arguments& arguments) {
  const Axis axis = axisArgument(arguments);
  const double radius = radiusOrDiameter(arguments, "radius", "diameter");
  return makeRoundSolid(axis.base, axis.top, radius, radius, capsArgument(arguments));
}

}  // namespace

ObjectType cylinderType() {
  ObjectType type;
  type.name = "cylinder";
  type.title = "Cylinder";
  type.parameters = axisParameters();
  type.parameters.push_back(radiusParameter("radius", "Radius", "radius; or give \"diameter\""));
  type.parameters.push_back(radiusParameter("diameter", "Diameter", "diameter; or give \"radius\""));
  type.parameters.push_back(capsParameter());
  type.parts = {"side", "bottom", "top"};
  type.make = make;
  return type;
}

}  // namespace goniolux::geometry
