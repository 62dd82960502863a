#include "geometry/quadric.h"

#include <cmath>
#include <stdexcept>

#include "geometry/arguments.h"
#include "geometry/clipped_quadric.h"

namespace goniolux::geometry {

using core::Mat4;
using core::Vec3;

namespace {

struct Term {
  const char* key;
  int row, column;  // of the symmetric form; half of a mixed term stands on either side of the diagonal
};
constexpr Term terms[] = {{"xx", 0, 0}, {"yy", 1, 1}, {"zz", 2, 2}, {"xy", 0, 1}, {"yz", 1, 2},
                          {"zx", 2, 0}, {"x", 0, 3},  {"y", 1, 3},  {"z", 2, 3},  {"constant", 3, 3}};

Shape make(const core::Arguments& arguments) {
  Mat4 form(0.0);
  for (const Term& term : terms) {
    const double value = optionalNumber(arguments, term.key).value_or(0);
    form[term.column][term.row] += 0.5 * value;
    form[term.row][term.column] += 0.5 * value;
  }
  return makeQuadric(form, optionalVector(arguments, "center").value_or(Vec3(0)), required<double>(arguments, "size"),
                     requiredVector(arguments, "min"), requiredVector(arguments, "max"));
}

}  // namespace

Shape makeQuadric(const Mat4& form, const Vec3& center, double size, const Vec3& min, const Vec3& max) {
  if (!(size > 0)) throw std::invalid_argument("\"size\" must be above 0: the length that x, y and z are counted in");
  if (!(min.x < max.x && min.y < max.y && min.z < max.z)) {
    throw std::invalid_argument("the box has no extent; make \"min\" the smaller corner in x, y and z");
  }
  Shape shape;
  shape.partNames = {"surface"};
  QuadricPatch patch;
  patch.kind = QuadricPatch::Kind::quadric;
  const Vec3 half = 0.5 * (max - min), middle = 0.5 * (max + min);
  Mat4 toEquation(1.0);
  for (int axis = 0; axis < 3; ++axis) {
    patch.placement[axis][axis] = half[axis];
    toEquation[axis][axis] = half[axis] / size;
  }
  patch.placement[3] = glm::dvec4(middle, 1);
  toEquation[3] = glm::dvec4((middle - center) / size, 1);
  patch.form = glm::transpose(toEquation) * form * toEquation;
  double largest = 0;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) largest = std::max(largest, std::abs(patch.form[i][j]));
  if (!(largest > 0) || !std::isfinite(largest)) {
    throw std::invalid_argument("the equation has no terms; give \"xx\", \"yy\" … and \"constant\"");
  }
  patch.form /= largest;
  bool exists = isWholeEllipsoid(patch.form);
  if (!exists) visitSurface(patch.form, 64, [&](const Vec3&, const Vec3&, double) { exists = true; });
  if (!exists) {
    throw std::invalid_argument(
        "the box holds nothing of the surface; check \"min\", \"max\", \"center\" and the signs");
  }
  shape.closed = isWholeEllipsoid(patch.form);
  shape.patches = {patch};
  return shape;
}

ObjectType quadricType() {
  ObjectType type;
  type.name = "quadric";
  type.title = "Quadric: xx·x² + yy·y² + zz·z² + xy·x·y + yz·y·z + zx·z·x + x·x + y·y + z·z + constant = 0 in a box";
  for (const Term& term : terms) {
    core::Parameter parameter;
    parameter.key = term.key;
    parameter.title = "Coefficient";
    parameter.kind = core::ParameterKind::number;
    parameter.defaultText = "0";
    parameter.help = "coefficient; the front is where the left side grows";
    type.parameters.push_back(parameter);
  }
  core::Parameter size =
      radiusParameter("size", "Unit length", "the length that x, y and z of the equation are counted in");
  size.required = true;
  type.parameters.push_back(size);
  type.parameters.push_back(
      pointParameter("center", "Centre", false, "[0, 0, 0]", "zero of the equation's x, y and z"));
  type.parameters.push_back(pointParameter("min", "Lowest corner", true, "", "of the box that the surface is cut to"));
  type.parameters.push_back(pointParameter("max", "Highest corner", true, "", "of the box that the surface is cut to"));
  type.parts = {"surface"};
  type.make = make;
  return type;
}

}  // namespace goniolux::geometry
