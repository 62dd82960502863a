#include "geometry/cone.h"

#include "geometry/arguments.h"
#include "geometry/round_solid.h"

namespace goniolux::geometry {
namespace {

Shape make(const core::Arguments& arguments) {
  const Axis axis = axisArgument(arguments);
  return makeRoundSolid(axis.base, axis.top, optionalNumber(arguments, "radius").value_or(0),
                        optionalNumber(arguments, "top_radius").value_or(0), capsArgument(arguments));
}

}  // namespace

ObjectType coneType() {
  core::Parameter radius = radiusParameter("radius", "Radius at the base", "radius at the base; 0 for a point");
  core::Parameter topRadius = radiusParameter("top_radius", "Radius at the top", "radius at the top; 0 for a point");
  radius.required = true;
  radius.minimumIsAllowed = topRadius.minimumIsAllowed = true;
  topRadius.defaultText = "0";
  ObjectType type;
  type.name = "cone";
  type.title = "Cone or frustum";
  type.parameters = axisParameters();
  type.parameters.push_back(radius);
  type.parameters.push_back(topRadius);
  type.parameters.push_back(capsParameter());
  type.parts = {"side", "bottom", "top"};
  type.make = make;
  return type;
}

}  // namespace goniolux::geometry
