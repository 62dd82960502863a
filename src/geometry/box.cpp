#include "geometry/box.h"

#include <fmt/format.h>

#include <stdexcept>

#include "geometry/arguments.h"

namespace goniolux::geometry {
namespace {

Shape make(const core::Arguments& arguments) {
  return makeBox(requiredVector(arguments, "min"), requiredVector(arguments, "max"));
}

}  // namespace

Shape makeBox(const core::Vec3& min, const core::Vec3& max) {
  for (int axis = 0; axis < 3; ++axis) {
    if (!(min[axis] < max[axis])) {
      throw std::invalid_argument(
          fmt::format("the box has no extent in {0}: \"min\" is {1} m, \"max\" {2} m there; make \"min\" the smaller",
                      "xyz"[axis], min[axis], max[axis]));
    }
  }
  Shape shape;
  shape.closed = true;
  shape.partNames = {"floor", "ceiling", "xmin", "xmax", "ymin", "ymax"};
  // Corner k takes max in x, y, z where bit 0, 1, 2 of k is set.
  for (unsigned k = 0; k < 8; ++k) {
    shape.mesh.vertices.emplace_back(k & 1U ? max.x : min.x, k & 2U ? max.y : min.y, k & 4U ? max.z : min.z);
  }
  // Corners of each face in the order of partNames, counter-clockwise seen from outside.
  constexpr std::array<std::array<std::uint32_t, 4>, 6> faces{
      {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}}};
  for (std::uint32_t part = 0; part < faces.size(); ++part) {
    const auto& f = faces[part];
    shape.mesh.triangles.push_back({f[0], f[1], f[2]});
    shape.mesh.triangles.push_back({f[0], f[2], f[3]});
    shape.mesh.parts.insert(shape.mesh.parts.end(), 2, part);
  }
  return shape;
}

ObjectType boxType() {
  ObjectType type;
  type.name = "box";
  type.title = "Box";
  type.parameters = {pointParameter("min", "Lowest corner", true, "", "corner with the smallest x, y and z"),
                     pointParameter("max", "Highest corner", true, "", "corner with the largest x, y and z")};
  type.parts = {"floor", "ceiling", "xmin", "xmax", "ymin", "ymax"};
  type.partGroups = {{"walls", {"xmin", "xmax", "ymin", "ymax"}}};
  type.make = make;
  type.isClosed = true;
  return type;
}

}  // namespace goniolux::geometry
