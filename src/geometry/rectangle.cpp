#include "geometry/rectangle.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "geometry/arguments.h"

namespace goniolux::geometry {
namespace {

Shape make(const core::Arguments& arguments) {
  return makeRectangle(requiredVector(arguments, "origin"), requiredVector(arguments, "u"),
                       requiredVector(arguments, "v"));
}

}  // namespace

Shape makeRectangle(const core::Vec3& origin, const core::Vec3& u, const core::Vec3& v) {
  const double lengthU = glm::length(u), lengthV = glm::length(v);
  if (!(lengthU > 0) || !(lengthV > 0)) {
    throw std::invalid_argument(fmt::format(
        "edge \"{}\" of the rectangle has no length; give its full length and direction", lengthU > 0 ? "v" : "u"));
  }
  const double cosine = glm::dot(u, v) / (lengthU * lengthV);
  if (std::abs(cosine) > std::sin(0.1 * core::degree)) {
    throw std::invalid_argument(
        fmt::format("the edges \"u\" and \"v\" meet at {:.1f} degrees; a rectangle needs 90, for other angles take "
                    "\"shape\": \"polygon\" with \"vertices\"",
                    std::acos(cosine) / core::degree));
  }
  Shape shape;
  shape.partNames = {"surface"};
  shape.mesh.vertices = {origin, origin + u, origin + u + v, origin + v};
  shape.mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  shape.mesh.parts = {0, 0};
  shape.mesh.coordinates = {{{{0, 0}, {1, 0}, {1, 1}}}, {{{0, 0}, {1, 1}, {0, 1}}}};
  return shape;
}

ObjectType rectangleType() {
  ObjectType type;
  type.name = "rectangle";
  type.title = "Rectangle";
  type.parameters = {
      pointParameter("origin", "Corner", true, "", "one corner"),
      pointParameter("u", "First edge", true, "",
                     "from the corner along the first edge, its full length, as for a grid"),
      pointParameter("v", "Second edge", true, "",
                     "from the corner along the second edge, its full length; the front is where u x v points")};
  type.parts = {"surface"};
  type.make = make;
  return type;
}

}  // namespace goniolux::geometry
