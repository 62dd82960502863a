#include "geometry/parametric.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "geometry/arguments.h"
#include "geometry/bounds.h"
#include "geometry/bspline_surface.h"
#include "geometry/mesh_checks.h"

namespace goniolux::geometry {

using core::Vec3;
using Net = std::vector<std::vector<Vec3>>;

namespace {

constexpr double defaultChordError = 1e-4;  // of the extent of the control points
constexpr double mostTriangles = 4e6;
constexpr int largestDegree = 15;

// Triangles of an n x n grid over the patch are off by at most 1/8 (h^2 S_uu + 2 h k S_uv + k^2 S_vv). — Filip,
// Magedson, Markot, "Surface algorithms using bounds on derivatives", CAGD 3 (1986)
double stepsFor(const BsplineSurface& surface, double chordError) {
  const auto bound = surface.secondDerivatives();
  const double steps = std::ceil(std::sqrt((bound.uu + 2 * bound.uv + bound.vv) / (8 * chordError)));
  // Whole spans, so that the derivatives that jump at knots do so between triangles.
  const double spans = std::max(surface.spansU(), surface.spansV());
  return std::max(1.0, std::ceil(steps / spans)) * spans;
}

void addPatch(const BsplineSurface& surface, int steps, Mesh& mesh) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  const auto side = static_cast<std::uint32_t>(steps + 1);
  for (int i = 0; i <= steps; ++i)
    for (int j = 0; j <= steps; ++j) mesh.vertices.push_back(surface.at(double(i) / steps, double(j) / steps));
  for (std::uint32_t i = 0; i + 1 < side; ++i) {
    for (std::uint32_t j = 0; j + 1 < side; ++j) {
      const std::uint32_t a = first + i * side + j, b = a + side, c = b + 1, d = a + 1;
      mesh.triangles.push_back({a, b, c});
      mesh.triangles.push_back({a, c, d});
      const auto at = [&](std::uint32_t u, std::uint32_t v) {
        return glm::vec2(float(u) / float(steps), float(v) / float(steps));
      };
      mesh.coordinates.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.coordinates.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
}

int degreeOf(const core::Arguments& arguments, const std::string& key, std::size_t points, bool isBezier) {
  const auto asked = optionalNumber(arguments, key);
  if (isBezier) {
    if (asked) throw std::invalid_argument(fmt::format("\"{}\" goes with \"basis\": \"bspline\"", key));
    return static_cast<int>(points) - 1;
  }
  const double degree = asked.value_or(std::min<double>(3, double(points) - 1));
  if (degree != std::floor(degree) || degree < 1 || degree > largestDegree) {
    throw std::invalid_argument(fmt::format("\"{}\" must be a whole number from 1 to {}", key, largestDegree));
  }
  return static_cast<int>(degree);
}

Shape make(const core::Arguments& arguments) {
  const Net rows = required<Net>(arguments, "control");
  const std::string basis = optional<std::string>(arguments, "basis").value_or("bezier");
  if (basis != "bezier" && basis != "bspline") {
    throw std::invalid_argument(fmt::format("\"basis\" is \"{}\"; it can be bezier or bspline", basis));
  }
  const double perPatch = optionalNumber(arguments, "patch_rows").value_or(double(rows.size()));
  if (!(perPatch >= 2) || perPatch != std::floor(perPatch) || rows.empty() ||
      std::fmod(double(rows.size()), perPatch) != 0) {
    throw std::invalid_argument(
        fmt::format("\"control\" has {} rows, which do not divide into patches of {} rows; a patch has 2 rows or more",
                    rows.size(), perPatch));
  }
  std::vector<Net> patches;
  for (auto row = rows.begin(); row != rows.end(); row += static_cast<std::ptrdiff_t>(perPatch))
    patches.emplace_back(row, row + static_cast<std::ptrdiff_t>(perPatch));
  Bounds box;
  for (const auto& row : rows)
    for (const Vec3& p : row) box.add(p);
  const double chordError =
      optionalNumber(arguments, "chord_error").value_or(defaultChordError * glm::length(box.extent()));
  const bool isBezier = basis == "bezier";
  return makeParametric(patches, degreeOf(arguments, "degree_u", patches.front().size(), isBezier),
                        degreeOf(arguments, "degree_v", rows.front().size(), isBezier), chordError);
}

}  // namespace

Shape makeParametric(const std::vector<Net>& control, int degreeU, int degreeV, double chordError) {
  std::vector<BsplineSurface> surfaces;
  double steps = 1;
  for (const Net& net : control) {
    for (std::size_t i = 0; i < net.size(); ++i) {
      if (net[i].size() != net[0].size()) {
        throw std::invalid_argument(fmt::format("row {} of \"control\" has {} points, the first {}; all have as many",
                                                i + 1, net[i].size(), net[0].size()));
      }
      for (const Vec3& p : net[i])
        if (!std::isfinite(p.x + p.y + p.z)) throw std::invalid_argument("a control point is not finite");
    }
    if (static_cast<int>(net.size()) <= degreeU || static_cast<int>(net[0].size()) <= degreeV || degreeU < 1 ||
        degreeV < 1 || std::max(degreeU, degreeV) > largestDegree) {
      throw std::invalid_argument(fmt::format(
          "a patch of {} x {} control points cannot have the degrees {} and {}: 1 to {}, below the number of "
          "points",
          net.size(), net[0].size(), degreeU, degreeV, largestDegree));
    }
    surfaces.emplace_back(net, degreeU, degreeV);
    steps = std::max(steps, stepsFor(surfaces.back(), chordError));
  }
  if (!(2 * steps * steps * double(control.size()) <= mostTriangles)) {
    throw std::invalid_argument(
        fmt::format("\"chord_error\" is {:.2g} m, which needs more than {:.0f} million triangles; allow a larger error",
                    chordError, mostTriangles / 1e6));
  }
  Shape shape;
  shape.partNames = {"surface"};
  for (const BsplineSurface& surface : surfaces) addPatch(surface, static_cast<int>(steps), shape.mesh);
  shape.mesh.parts.assign(shape.mesh.triangles.size(), 0);
  shape.chordError = chordError;
  mergeVertices(shape.mesh, 1e-9 * glm::length(boundsOf(shape.mesh).extent()));
  removeCollapsedTriangles(shape.mesh);
  shape.closed = orientOutward(shape.mesh).watertight();
  removeDegenerateTriangles(shape.mesh);
  if (shape.mesh.triangles.empty()) throw std::invalid_argument("the control points span no surface");
  return shape;
}

ObjectType parametricType() {
  const auto number = [](const char* key, const char* title, const char* help) {
    core::Parameter parameter;
    parameter.key = key;
    parameter.title = title;
    parameter.kind = core::ParameterKind::number;
    parameter.help = help;
    return parameter;
  };
  core::Parameter control =
      pointParameter("control", "Control points", true, "", "list of rows, each a list of points; rows run along u");
  control.kind = core::ParameterKind::loops3;
  core::Parameter basis;
  basis.key = "basis";
  basis.title = "Basis";
  basis.kind = core::ParameterKind::text;
  basis.defaultText = "bezier";
  basis.help = "bezier: one polynomial per patch; bspline: clamped uniform knots";
  ObjectType type;
  type.name = "parametric";
  type.title = "Parametric surface: Bézier or B-spline patches";
  type.parameters = {
      control,
      basis,
      number("degree_u", "Degree along u", "of a bspline; 3 when left out, or as far as there are points"),
      number("degree_v", "Degree along v", "of a bspline; 3 when left out, or as far as there are points"),
      number("patch_rows", "Rows of a patch",
             "rows of one patch, where several follow each other; all rows when left out"),
      radiusParameter("chord_error", "Chord error",
                      "largest distance between the surface and its triangles; when left out, 1/10000 of "
                      "the control points' extent")};
  type.parts = {"surface"};
  type.make = make;
  return type;
}

}  // namespace goniolux::geometry
