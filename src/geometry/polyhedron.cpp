#include "geometry/polyhedron.h"

#include <fmt/format.h>

#include <stdexcept>

#include "geometry/arguments.h"
#include "geometry/mesh_checks.h"
#include "geometry/triangulate.h"

namespace goniolux::geometry {
namespace {

Shape make(const core::Arguments& arguments) {
  return makePolyhedron(required<std::vector<core::Vec3>>(arguments, "vertices"),
                        required<std::vector<std::vector<int>>>(arguments, "faces"));
}

}  // namespace

Shape makePolyhedron(const std::vector<core::Vec3>& vertices, const std::vector<std::vector<int>>& faces) {
  if (faces.empty())
    throw std::invalid_argument("the polyhedron has no faces; give lists of vertex numbers as \"faces\"");
  Shape shape;
  shape.partNames = {"surface"};
  shape.mesh.vertices = vertices;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    std::vector<core::Vec3> ring;
    for (const int index : faces[f]) {
      if (index < 0 || static_cast<std::size_t>(index) >= vertices.size()) {
        throw std::invalid_argument(fmt::format("face {} names vertex {}, but vertices count from 0 to {}", f + 1,
                                                index, static_cast<long>(vertices.size()) - 1));
      }
      ring.push_back(vertices[static_cast<std::size_t>(index)]);
    }
    for (const auto& t : triangulateInSpace({ring}, fmt::format("face {}", f + 1))) {
      shape.mesh.triangles.push_back({static_cast<std::uint32_t>(faces[f][t[0]]),
                                      static_cast<std::uint32_t>(faces[f][t[1]]),
                                      static_cast<std::uint32_t>(faces[f][t[2]])});
    }
  }
  shape.mesh.parts.assign(shape.mesh.triangles.size(), 0);
  // Points that the designer wrote twice are one corner all the same.
  mergeVertices(shape.mesh, 1e-9 * glm::length(boundsOf(shape.mesh).extent()));
  shape.closed = orientOutward(shape.mesh).watertight();
  return shape;
}

ObjectType polyhedronType() {
  core::Parameter vertices = pointParameter("vertices", "Corners", true, "", "list of points");
  vertices.kind = core::ParameterKind::points3;
  core::Parameter faces =
      pointParameter("faces", "Faces", true, "",
                     "list of faces, each a list of vertex numbers that count from 0, in order round the face");
  faces.kind = core::ParameterKind::faces;
  faces.unit = "";
  ObjectType type;
  type.name = "polyhedron";
  type.title = "Polyhedron";
  type.parameters = {vertices, faces};
  type.parts = {"surface"};
  type.make = make;
  return type;
}

}  // namespace goniolux::geometry
