#include "geometry/polygon.h"

#include "geometry/arguments.h"
#include "geometry/triangulate.h"

namespace goniolux::geometry {
namespace {

Shape make(const core::Arguments& arguments) {
  const auto holes = optional<std::vector<std::vector<core::Vec3>>>(arguments, "holes");
  return makePolygon(required<std::vector<core::Vec3>>(arguments, "vertices"),
                     holes.value_or(std::vector<std::vector<core::Vec3>>{}));
}

}  // namespace

Shape makePolygon(const std::vector<core::Vec3>& vertices, const std::vector<std::vector<core::Vec3>>& holes) {
  std::vector<std::vector<core::Vec3>> rings{vertices};
  rings.insert(rings.end(), holes.begin(), holes.end());
  Shape shape;
  shape.partNames = {"surface"};
  shape.mesh.triangles = triangulateInSpace(rings, "the polygon");
  for (const auto& ring : rings) shape.mesh.vertices.insert(shape.mesh.vertices.end(), ring.begin(), ring.end());
  shape.mesh.parts.assign(shape.mesh.triangles.size(), 0);
  return shape;
}

ObjectType polygonType() {
  core::Parameter vertices =
      pointParameter("vertices", "Corners", true, "",
                     "three or more points in a plane; the front is where they turn counter-clockwise");
  vertices.kind = core::ParameterKind::points3;
  core::Parameter holes = pointParameter("holes", "Holes", false, "",
                                         "list of holes, each a list of points in the polygon's plane, inside it");
  holes.kind = core::ParameterKind::loops3;
  ObjectType type;
  type.name = "polygon";
  type.title = "Polygon";
  type.parameters = {vertices, holes};
  type.parts = {"surface"};
  type.make = make;
  return type;
}

}  // namespace goniolux::geometry
