#include "geometry/revolution.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "geometry/arguments.h"
#include "geometry/bounds.h"
#include "geometry/placement.h"
#include "geometry/queries.h"

namespace goniolux::geometry {

using core::Vec2;
using core::Vec3;

namespace {

constexpr std::size_t mostPoints = 20'000;
constexpr double defaultChordError = 1e-4;  // of the profile's extent

double cross(const Vec2& a, const Vec2& b) {
  return a.x * b.y - a.y * b.x;
}

void checkPoints(const std::vector<Vec2>& profile) {
  if (profile.size() < 2) throw std::invalid_argument("the profile needs two or more points [r, z]");
  if (profile.size() > mostPoints) {
    throw std::invalid_argument(
        fmt::format("the profile has {} points; {} are the most, use fewer or a spline", profile.size(), mostPoints));
  }
  for (std::size_t i = 0; i < profile.size(); ++i) {
    const Vec2& p = profile[i];
    if (!std::isfinite(p.x + p.y)) {
      throw std::invalid_argument(fmt::format("point {} of the profile is not finite; give plain numbers", i + 1));
    }
    if (p.x < 0) {
      throw std::invalid_argument(
          fmt::format("point {} of the profile has the radius {} m; radii are 0 or more", i + 1, p.x));
    }
    if (i == 0) continue;
    if (p == profile[i - 1]) {
      throw std::invalid_argument(fmt::format("points {} and {} of the profile coincide; leave one out", i, i + 1));
    }
    if (p.x == 0 && profile[i - 1].x == 0) {
      throw std::invalid_argument(fmt::format(
          "points {} and {} of the profile both lie on the axis, where there is no surface; leave one out", i, i + 1));
    }
  }
}

// Segments that meet anywhere but at their common end. Sorted by their lowest z, so that a profile of many points that
// goes up costs little.
void checkCrossings(const std::vector<Vec2>& profile) {
  const std::size_t n = profile.size() - 1;
  const bool isRing = profile.front() == profile.back();
  std::vector<std::size_t> order(n);
  for (std::size_t i = 0; i < n; ++i) order[i] = i;
  const auto low = [&](std::size_t i) { return std::min(profile[i].y, profile[i + 1].y); };
  const auto high = [&](std::size_t i) { return std::max(profile[i].y, profile[i + 1].y); };
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return low(a) < low(b); });
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t m = k + 1; m < n && low(order[m]) <= high(order[k]); ++m) {
      const std::size_t i = std::min(order[k], order[m]), j = std::max(order[k], order[m]);
      const Vec2 &a = profile[i], &b = profile[i + 1], &c = profile[j], &d = profile[j + 1];
      bool bad = false;
      if (j == i + 1 || (isRing && i == 0 && j + 1 == n)) {
        // Neighbours may only not turn straight back.
        const Vec2 &corner = j == i + 1 ? b : a, &before = j == i + 1 ? a : b, &after = j == i + 1 ? d : c;
        bad = n > 2 && cross(before - corner, after - corner) == 0 && glm::dot(before - corner, after - corner) > 0;
      } else {
        const double abc = cross(b - a, c - a), abd = cross(b - a, d - a), cda = cross(d - c, a - c),
                     cdb = cross(d - c, b - c);
        bad = std::max(a.x, b.x) >= std::min(c.x, d.x) && std::max(c.x, d.x) >= std::min(a.x, b.x) && abc * abd <= 0 &&
              cda * cdb <= 0;
      }
      if (bad) {
        throw std::invalid_argument(
            fmt::format("the profile crosses or touches itself: the line after point {} meets the one after point {}",
                        i + 1, j + 1));
      }
    }
  }
}

// One straight piece of the profile turned about the axis; its front is on the right of the way from a to b.
QuadricPatch pieceOf(const Vec2& a, const Vec2& b, const Vec3& center, const Vec3& axis) {
  const Vec3 base = center + a.y * axis, top = center + b.y * axis;
  if (a.y == b.y) {
    const double outer = std::max(a.x, b.x);
    QuadricPatch ring = makeDiscPatch(base, b.x > a.x ? -axis : axis, outer, 0);
    ring.ratio = std::min(a.x, b.x) / outer;
    return ring;
  }
  QuadricPatch side = a.x == b.x ? makeCylinderPatch(base, top, a.x, 0) : makeConePatch(base, top, a.x, b.x, 0);
  side.turned = b.y < a.y;
  return side;
}

Shape make(const core::Arguments& arguments) {
  const auto points = required<std::vector<Vec2>>(arguments, "profile");
  const Vec3 center = optionalVector(arguments, "center").value_or(Vec3(0));
  const Vec3 axis = optionalVector(arguments, "axis").value_or(Vec3(0, 0, 1));
  const std::string curve = optional<std::string>(arguments, "curve").value_or("polyline");
  if (curve != "polyline" && curve != "spline") {
    throw std::invalid_argument(fmt::format("\"curve\" is \"{}\"; it can be polyline or spline", curve));
  }
  const auto asked = optionalNumber(arguments, "chord_error");
  if (curve == "polyline") {
    if (asked) throw std::invalid_argument("\"chord_error\" goes with \"curve\": \"spline\"; a polyline is exact");
    return makeRevolution(points, center, axis);
  }
  checkPoints(points);
  Vec2 low = points[0], high = points[0];
  for (const Vec2& p : points) low = glm::min(low, p), high = glm::max(high, p);
  const double chordError = asked.value_or(defaultChordError * glm::length(high - low));
  Shape shape = makeRevolution(splineProfile(points, chordError), center, axis);
  shape.chordError = chordError;
  // The first and the last rim of an open one are edges.
  for (std::size_t i = shape.closed ? 0 : 1; i + (shape.closed ? 0 : 1) < shape.patches.size(); ++i) {
    shape.patches[i].isFacet = true;
  }
  return shape;
}

}  // namespace

Shape makeRevolution(const std::vector<Vec2>& profile, const Vec3& center, const Vec3& axis) {
  if (!(glm::length(axis) > 0)) throw std::invalid_argument("\"axis\" has no length; give a direction, e.g. [0, 0, 1]");
  checkPoints(profile);
  checkCrossings(profile);
  Shape shape;
  shape.partNames = {"surface"};
  for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
    shape.patches.push_back(pieceOf(profile[i], profile[i + 1], center, glm::normalize(axis)));
  }
  const bool onAxis = profile.front().x == 0 && profile.back().x == 0;
  shape.closed = profile.size() > 2 && (onAxis || profile.front() == profile.back());
  if (shape.closed && volume(shape) < 0) {
    for (QuadricPatch& patch : shape.patches) patch.turned = !patch.turned;
  }
  return shape;
}

ObjectType revolutionType() {
  core::Parameter profile = pointParameter("profile", "Profile", true, "",
                                           "list of [r, z]: distance from the axis, height along it; closed when it "
                                           "begins and ends on the axis, or where it "
                                           "began");
  profile.kind = core::ParameterKind::points2;
  core::Parameter axis = pointParameter("axis", "Axis", false, "[0, 0, 1]", "direction of the profile's z");
  axis.kind = core::ParameterKind::direction;
  axis.unit = "";
  core::Parameter curve;
  curve.key = "curve";
  curve.title = "Curve";
  curve.kind = core::ParameterKind::text;
  curve.defaultText = "polyline";
  curve.help = "polyline: straight from point to point, exact; spline: a smooth curve through the points";
  ObjectType type;
  type.name = "revolution";
  type.title = "Surface of revolution";
  type.parameters = {
      profile, pointParameter("center", "Centre", false, "[0, 0, 0]", "the profile's [0, 0]"), axis, curve,
      radiusParameter("chord_error", "Chord error",
                      "largest distance between a spline and the cones that stand for it; when left out, "
                      "1/10000 of the profile's extent")};
  type.parts = {"surface"};
  type.make = make;
  return type;
}

}  // namespace goniolux::geometry
