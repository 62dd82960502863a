#include "geometry/bspline_surface.h"

#include <algorithm>
#include <utility>

namespace goniolux::geometry {

using core::Vec3;

namespace {

using Line = std::vector<Vec3>;

// Knot k of a clamped uniform B-spline with `count` control points, from 0 to 1.
double knot(int k, int count, int degree) {
  const int spans = count - degree;
  return std::clamp(double(k - degree) / spans, 0.0, 1.0);
}

// — de Boor, A Practical Guide to Splines (1978), ch. X
Vec3 deBoor(const Line& control, int degree, double t) {
  const int count = static_cast<int>(control.size());
  const int spans = count - degree;
  const int span = degree + std::min(static_cast<int>(t * spans), spans - 1);
  Line d(control.begin() + (span - degree), control.begin() + span + 1);
  for (int r = 1; r <= degree; ++r) {
    for (int j = degree; j >= r; --j) {
      const double low = knot(span - degree + j, count, degree), high = knot(span + 1 + j - r, count, degree);
      const double a = (t - low) / (high - low);
      d[std::size_t(j)] = (1 - a) * d[std::size_t(j - 1)] + a * d[std::size_t(j)];
    }
  }
  return d[std::size_t(degree)];
}

// Control points of the derivative, a B-spline of one degree less on the same knots without the first and the last.
Line derivative(const Line& control, int degree, int count, int dropped) {
  // `count` and degree + dropped are those of the first curve, whose knots these are.
  const int first = degree + dropped;
  Line result;
  for (int i = 0; i + 1 < static_cast<int>(control.size()); ++i) {
    const double low = knot(i + 1 + dropped, count, first), high = knot(i + 1 + degree + dropped, count, first);
    result.push_back(double(degree) / (high - low) * (control[std::size_t(i + 1)] - control[std::size_t(i)]));
  }
  return result;
}

std::vector<Line> transposed(const std::vector<Line>& rows) {
  std::vector<Line> columns(rows.front().size(), Line(rows.size()));
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t j = 0; j < rows[i].size(); ++j) columns[j][i] = rows[i][j];
  return columns;
}

std::vector<Line> derivativeOfRows(const std::vector<Line>& rows, int degree, int times) {
  std::vector<Line> result = rows;
  const int count = static_cast<int>(rows.front().size());
  for (int k = 0; k < times; ++k) {
    for (Line& row : result) row = degree - k > 0 ? derivative(row, degree - k, count, k) : Line(1, Vec3(0));
  }
  return result;
}

double longest(const std::vector<Line>& rows) {
  double length = 0;
  for (const Line& row : rows)
    for (const Vec3& v : row) length = std::max(length, glm::length(v));
  return length;
}

}  // namespace

BsplineSurface::BsplineSurface(std::vector<Line> control, int degreeU, int degreeV)
    : control_(std::move(control)), degreeU_(degreeU), degreeV_(degreeV) {}

Vec3 BsplineSurface::at(double u, double v) const {
  Line column;
  for (const Line& row : control_) column.push_back(deBoor(row, degreeV_, v));
  return deBoor(column, degreeU_, u);
}

BsplineSurface::Bounds BsplineSurface::secondDerivatives() const {
  const auto alongU = [&](const std::vector<Line>& rows, int times) {
    return transposed(derivativeOfRows(transposed(rows), degreeU_, times));
  };
  return {longest(alongU(control_, 2)), longest(alongU(derivativeOfRows(control_, degreeV_, 1), 1)),
          longest(derivativeOfRows(control_, degreeV_, 2))};
}

}  // namespace goniolux::geometry
