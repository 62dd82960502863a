#include "geometry/sphere.h"

#include "geometry/arguments.h"
#include "geometry/placement.h"

namespace goniolux::geometry {
namespace {

Shape make(const core::Arguments& arguments) {
  return makeSphere(requiredVector(arguments, "center"), radiusOrDiameter(arguments, "radius", "diameter"));
}

}  // namespace

Shape makeSphere(const core::Vec3& center, double radius) {
  Shape shape;
  shape.closed = true;
  shape.partNames = {"surface"};
  shape.patches = {makeSpherePatch(center, radius, 0)};
  return shape;
}

ObjectType sphereType() {
  ObjectType type;
  type.name = "sphere";
  type.title = "Sphere";
  type.parameters = {pointParameter("center", "Centre", true, "", "centre of the sphere"),
                     radiusParameter("radius", "Radius", "radius; or give \"diameter\""),
                     radiusParameter("diameter", "Diameter", "diameter; or give \"radius\"")};
  type.parts = {"surface"};
  type.make = make;
  type.isClosed = true;
  return type;
}

}  // namespace goniolux::geometry
