// A smooth profile through given points, cut into chords.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "geometry/revolution.h"

namespace goniolux::geometry {

using core::Vec2;

namespace {

constexpr int mostChords = 1000;  // between two points

// Neighbours before the first and after the last point: mirrored at the axis, which makes the curve perpendicular to
// it; round the corner for a closed profile; straight on at a free end.
Vec2 beyond(const std::vector<Vec2>& points, bool atEnd) {
  const std::size_t n = points.size();
  const Vec2 &end = atEnd ? points[n - 1] : points[0], &next = atEnd ? points[n - 2] : points[1];
  if (points.front() == points.back()) return atEnd ? points[1] : points[n - 2];
  if (end.x == 0) return {-next.x, next.y};
  return 2.0 * end - next;
}

// Bezier points of the centripetal Catmull-Rom curve from b to c. — Catmull & Rom 1974; parameters: Lee, "Choosing
// nodes in parametric curve interpolation", CAD 21 (1989); no cusps: Yuksel, Schaefer, Keyser, CAD 43 (2011)
std::array<Vec2, 4> bezier(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const double d1 = std::sqrt(glm::distance(a, b)), d2 = std::sqrt(glm::distance(b, c)),
               d3 = std::sqrt(glm::distance(c, d));
  const Vec2 p1 = (d1 * d1 * c - d2 * d2 * a + (2 * d1 * d1 + 3 * d1 * d2 + d2 * d2) * b) / (3 * d1 * (d1 + d2));
  const Vec2 p2 = (d3 * d3 * b - d2 * d2 * d + (2 * d3 * d3 + 3 * d3 * d2 + d2 * d2) * c) / (3 * d3 * (d3 + d2));
  return {b, p1, p2, c};
}

Vec2 at(const std::array<Vec2, 4>& p, double t) {
  const double s = 1 - t;
  return s * s * s * p[0] + 3 * s * s * t * p[1] + 3 * s * t * t * p[2] + t * t * t * p[3];
}

}  // namespace

std::vector<Vec2> splineProfile(const std::vector<Vec2>& points, double chordError) {
  if (points.size() < 3) return points;
  std::vector<Vec2> curve{points.front()};
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const Vec2 before = i == 0 ? beyond(points, false) : points[i - 1];
    const Vec2 after = i + 2 == points.size() ? beyond(points, true) : points[i + 2];
    if (points[i] == points[i + 1]) {
      throw std::invalid_argument(fmt::format("points {} and {} of the profile coincide; leave one out", i + 1, i + 2));
    }
    const auto p = bezier(before, points[i], points[i + 1], after);
    // A chord over the parameter step h is off by at most h^2/8 max|B''|, and B'' lies in the hull of its ends.
    const double second = 6 * std::max(glm::length(p[0] - 2.0 * p[1] + p[2]), glm::length(p[1] - 2.0 * p[2] + p[3]));
    const double needed = std::ceil(std::sqrt(second / (8 * chordError)));
    if (!(needed <= mostChords)) {
      throw std::invalid_argument(fmt::format(
          "\"chord_error\" is {:.2g} m, which needs {:.0f} cones between points {} and {} of the profile; {} are "
          "the most, allow a larger error",
          chordError, needed, i + 1, i + 2, mostChords));
    }
    const int chords = std::max(static_cast<int>(needed), 1);
    for (int k = 1; k <= chords; ++k) {
      Vec2 point = k == chords ? points[i + 1] : at(p, double(k) / chords);
      if (point.x < 0 || (point.x == 0 && k < chords)) {
        throw std::invalid_argument(fmt::format(
            "the spline passes the axis between points {} and {} of the profile; add a point there", i + 1, i + 2));
      }
      curve.push_back(point);
    }
  }
  return curve;
}

}  // namespace goniolux::geometry
