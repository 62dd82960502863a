#include "geometry/coincidence.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

namespace goniolux::geometry {

using core::Vec2;
using core::Vec3;

namespace {

using Polygon = std::vector<Vec2>;

// The part of a convex polygon on the left of the line from p to q. — Sutherland & Hodgman, CACM 17 (1974)
Polygon clipped(const Polygon& polygon, const Vec2& p, const Vec2& q) {
  const auto side = [&](const Vec2& x) { return (q.x - p.x) * (x.y - p.y) - (q.y - p.y) * (x.x - p.x); };
  Polygon result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 &from = polygon[i], &to = polygon[(i + 1) % polygon.size()];
    const double a = side(from), b = side(to);
    if (a >= 0) result.push_back(from);
    if ((a > 0 && b < 0) || (a < 0 && b > 0)) result.push_back(from + a / (a - b) * (to - from));
  }
  return result;
}

// The middle of what two triangles in a plane have in common, if it is wider than the tolerance.
std::optional<Vec3> commonPlace(const VisibleFace& f, const VisibleFace& g, double tolerance) {
  Vec3 x, y;
  core::perpendiculars(f.normal, x, y);
  const auto flat = [&](const VisibleFace& face) {
    Polygon p;
    for (const Vec3* corner : {&face.a, &face.b, &face.c}) {
      const Vec3 v = *corner - f.a;
      p.emplace_back(glm::dot(v, x), glm::dot(v, y));
    }
    const Vec2 u = p[1] - p[0], w = p[2] - p[0];
    if (u.x * w.y - u.y * w.x < 0) std::swap(p[1], p[2]);
    return p;
  };
  const Polygon second = flat(g);
  Polygon common = flat(f);
  for (std::size_t i = 0; i < 3 && !common.empty(); ++i) common = clipped(common, second[i], second[(i + 1) % 3]);
  if (common.size() < 3) return std::nullopt;
  Vec2 middle(0);
  double area = 0, round = 0;
  for (std::size_t i = 0; i < common.size(); ++i) {
    const Vec2 &p = common[i], &q = common[(i + 1) % common.size()];
    middle += p / double(common.size());
    area += 0.5 * (p.x * q.y - p.y * q.x);
    round += glm::distance(p, q);
  }
  if (!(area > 0.5 * tolerance * round)) return std::nullopt;  // a strip as narrow as the tolerance
  return f.a + middle.x * x + middle.y * y;
}

}  // namespace

std::vector<Coincidence> coincidentFaces(const std::vector<VisibleFace>& faces, double tolerance) {
  // Planes are sorted by their normal's direction on a grid, made to agree in sign, then by distance from the origin.
  struct Entry {
    std::array<long, 3> direction;
    double offset, low, high;  // low, high: along one axis of the plane's own, to end the search early
    std::uint32_t face;
  };
  std::vector<Entry> entries;
  for (std::uint32_t i = 0; i < faces.size(); ++i) {
    Vec3 n = faces[i].normal;
    const int largest = std::abs(n.x) >= std::abs(n.y) && std::abs(n.x) >= std::abs(n.z) ? 0
                        : std::abs(n.y) >= std::abs(n.z)                                 ? 1
                                                                                         : 2;
    if (n[largest] < 0) n = -n;
    const std::array<long, 3> direction{std::lround(n.x * 1e4), std::lround(n.y * 1e4), std::lround(n.z * 1e4)};
    const int along = (largest + 1) % 3;
    const auto [low, high] = std::minmax({faces[i].a[along], faces[i].b[along], faces[i].c[along]});
    entries.push_back({direction, glm::dot(n, faces[i].a), low, high, i});
  }
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    return std::tie(a.direction, a.offset) < std::tie(b.direction, b.offset);
  });
  std::vector<Coincidence> found;
  std::set<std::pair<std::uint32_t, std::uint32_t>> known;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const VisibleFace& f = faces[entries[i].face];
    for (std::size_t j = i + 1; j < entries.size() && entries[j].direction == entries[i].direction &&
                                entries[j].offset - entries[i].offset <= tolerance;
         ++j) {
      const VisibleFace& g = faces[entries[j].face];
      if (f.object == g.object || f.finish == g.finish || entries[i].high < entries[j].low ||
          entries[j].high < entries[i].low)
        continue;
      if (!f.bothSides && !g.bothSides && glm::dot(f.normal, g.normal) < 0) continue;
      const std::pair<std::uint32_t, std::uint32_t> pair = std::minmax(f.object, g.object);
      if (known.contains(pair)) continue;
      if (const auto place = commonPlace(f, g, tolerance)) {
        known.insert(pair);
        found.push_back({pair.first, pair.second, *place, f.object == pair.first ? f.normal : g.normal});
      }
    }
  }
  std::sort(found.begin(), found.end(), [](const Coincidence& a, const Coincidence& b) {
    return std::tie(a.first, a.second) < std::tie(b.first, b.second);
  });
  return found;
}

}  // namespace goniolux::geometry
