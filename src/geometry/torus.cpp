#include "geometry/torus.h"

#include <fmt/format.h>

#include <stdexcept>

#include "geometry/arguments.h"
#include "geometry/placement.h"

namespace goniolux::geometry {
namespace {

Shape make(const core::Arguments& arguments) {
  return makeTorus(requiredVector(arguments, "center"), optionalVector(arguments, "axis").value_or(core::Vec3(0, 0, 1)),
                   required<double>(arguments, "ring_radius"), required<double>(arguments, "tube_radius"));
}

}  // namespace

Shape makeTorus(const core::Vec3& center, const core::Vec3& axis, double ringRadius, double tubeRadius) {
  if (!(glm::length(axis) > 0)) throw std::invalid_argument("\"axis\" has no length; give a direction, e.g. [0, 0, 1]");
  if (!(tubeRadius > 0) || !(tubeRadius < ringRadius)) {
    throw std::invalid_argument(
        fmt::format("\"tube_radius\" is {} m and \"ring_radius\" {} m; the tube must be thinner than the ring, or it "
                    "would run through itself",
                    tubeRadius, ringRadius));
  }
  Shape shape;
  shape.closed = true;
  shape.partNames = {"surface"};
  QuadricPatch patch;
  patch.kind = QuadricPatch::Kind::torus;
  patch.ratio = tubeRadius / ringRadius;
  patch.placement = placementAlong(center, ringRadius * glm::normalize(axis), ringRadius);
  shape.patches = {patch};
  return shape;
}

ObjectType torusType() {
  core::Parameter axis = pointParameter("axis", "Axis", false, "[0, 0, 1]", "upright on the plane of the ring");
  axis.kind = core::ParameterKind::direction;
  axis.unit = "";
  core::Parameter ring =
      radiusParameter("ring_radius", "Radius of the ring", "from the centre to the middle of the tube");
  core::Parameter tube = radiusParameter("tube_radius", "Radius of the tube", "smaller than the ring's");
  ring.required = tube.required = true;
  ObjectType type;
  type.name = "torus";
  type.title = "Torus";
  type.parameters = {pointParameter("center", "Centre", true, "", "centre of the ring"), axis, ring, tube};
  type.parts = {"surface"};
  type.make = make;
  type.isClosed = true;
  return type;
}

}  // namespace goniolux::geometry
