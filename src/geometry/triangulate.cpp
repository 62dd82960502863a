#include "geometry/triangulate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "geometry/bounds.h"

namespace goniolux::geometry {

using core::Vec2;
using core::Vec3;
using Triangle = std::array<std::uint32_t, 3>;

namespace {

constexpr std::size_t maximumVertices = 5'000;  // O(n^2), some seconds

// A vertex on the integer grid; differences below 2^30, products below 2^60.
struct Point {
  std::int64_t x = 0, y = 0;
  bool operator==(const Point&) const = default;
};

// Twice the signed area of abc: exact.
std::int64_t turn(const Point& a, const Point& b, const Point& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

bool withinBox(const Point& a, const Point& b, const Point& p) {
  return std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y &&
         p.y <= std::max(a.y, b.y);
}

bool onSegment(const Point& a, const Point& b, const Point& p) {
  return turn(a, b, p) == 0 && withinBox(a, b, p);
}

int sign(std::int64_t value) {
  return (value > 0) - (value < 0);
}

// Closed segments share at least one point.
bool touch(const Point& a, const Point& b, const Point& c, const Point& d) {
  const int abc = sign(turn(a, b, c)), abd = sign(turn(a, b, d)), cda = sign(turn(c, d, a)), cdb = sign(turn(c, d, b));
  if (abc * abd < 0 && cda * cdb < 0) return true;
  return onSegment(a, b, c) || onSegment(a, b, d) || onSegment(c, d, a) || onSegment(c, d, b);
}

class Triangulator {
 public:
  explicit Triangulator(const std::vector<std::vector<Vec2>>& rings) {
    snap(rings);
    checkRings();
    orient();
  }

  std::vector<Triangle> run() {
    ring_ = rings_[0];
    for (std::size_t hole = 1; hole < rings_.size(); ++hole) waiting_.push_back(hole);
    while (!waiting_.empty()) bridgeOne();
    clipEars();
    return std::move(triangles_);
  }

 private:
  const Point& at(std::uint32_t index) const { return points_[index]; }

  void snap(const std::vector<std::vector<Vec2>>& rings) {
    Vec2 low(std::numeric_limits<double>::infinity()), high(-low);
    std::size_t count = 0;
    for (const auto& ring : rings) {
      for (const Vec2& p : ring) low = glm::min(low, p), high = glm::max(high, p);
      count += ring.size();
    }
    if (count > maximumVertices) {
      throw std::invalid_argument(
          fmt::format("has {} vertices; {} are the most, use a mesh instead", count, maximumVertices));
    }
    const double extent = std::max(high.x - low.x, high.y - low.y);
    const double scale = extent > 0 ? 0x1p29 / extent : 0.0;
    for (const auto& ring : rings) {
      std::vector<std::uint32_t> indices;
      for (const Vec2& p : ring) {
        indices.push_back(static_cast<std::uint32_t>(points_.size()));
        points_.push_back({std::llround((p.x - low.x) * scale), std::llround((p.y - low.y) * scale)});
      }
      rings_.push_back(std::move(indices));
    }
  }

  static std::string nameOf(std::size_t ring) { return ring == 0 ? "the outline" : fmt::format("hole {}", ring); }

  // Number of a vertex within its ring, from 1, as a person counts.
  std::size_t numberOf(std::size_t ring, std::uint32_t index) const { return index - rings_[ring].front() + 1; }

  void checkRings() const {
    for (std::size_t r = 0; r < rings_.size(); ++r) {
      if (rings_[r].size() < 3) {
        throw std::invalid_argument(
            fmt::format("needs at least 3 vertices in {}, but has {}", nameOf(r), rings_[r].size()));
      }
      if (areaOf(rings_[r]) == 0) throw std::invalid_argument(fmt::format("has no area in {}", nameOf(r)));
    }
    // Every pair of edges; neighbours share their corner and may share nothing else.
    for (std::size_t r = 0; r < rings_.size(); ++r) {
      const auto& ring = rings_[r];
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const std::uint32_t a = ring[i], b = ring[(i + 1) % ring.size()];
        if (at(a) == at(b)) {
          throw std::invalid_argument(fmt::format("has the same point twice in {} (vertices {} and {}); leave one out",
                                                  nameOf(r), numberOf(r, a), numberOf(r, b)));
        }
        for (std::size_t s = r; s < rings_.size(); ++s) {
          const auto& other = rings_[s];
          for (std::size_t j = s == r ? i + 1 : 0; j < other.size(); ++j) {
            const std::uint32_t c = other[j], d = other[(j + 1) % other.size()];
            bool bad = false;
            if (b == c || a == d) {
              const Point &corner = b == c ? at(b) : at(a), &before = b == c ? at(a) : at(b),
                          &after = b == c ? at(d) : at(c);
              // Neighbours overlap only if the path turns straight back.
              bad = turn(before, corner, after) == 0 &&
                    (onSegment(corner, before, after) || onSegment(corner, after, before));
            } else {
              bad = touch(at(a), at(b), at(c), at(d));
            }
            if (!bad) continue;
            throw std::invalid_argument(fmt::format(
                "crosses or touches itself: the edge after vertex {} of {} meets the edge after vertex {} of {}",
                numberOf(r, a), nameOf(r), numberOf(s, c), nameOf(s)));
          }
        }
      }
    }
    for (std::size_t r = 1; r < rings_.size(); ++r) {
      if (!inside(at(rings_[r][0]), rings_[0])) {
        throw std::invalid_argument(fmt::format("has {} outside its outline", nameOf(r)));
      }
      for (std::size_t s = 1; s < rings_.size(); ++s) {
        if (s != r && inside(at(rings_[r][0]), rings_[s])) {
          throw std::invalid_argument(fmt::format("has {} inside {}", nameOf(r), nameOf(s)));
        }
      }
    }
  }

  // Twice the signed area; in long double, as sums of products may pass 63 bits: only its sign and zero matter.
  long double areaOf(const std::vector<std::uint32_t>& ring) const {
    long double sum = 0;
    for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
      sum += static_cast<long double>(turn(at(ring[0]), at(ring[i]), at(ring[i + 1])));
    }
    return sum;
  }

  // Crossing parity with half-open edges; rings do not touch, so the point is never on one.
  bool inside(const Point& p, const std::vector<std::uint32_t>& ring) const {
    bool in = false;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point &a = at(ring[i]), &b = at(ring[(i + 1) % ring.size()]);
      if ((a.y > p.y) == (b.y > p.y)) continue;
      if ((turn(a, b, p) > 0) == (b.y > a.y)) in = !in;
    }
    return in;
  }

  void orient() {
    for (std::size_t r = 0; r < rings_.size(); ++r) {
      if ((areaOf(rings_[r]) > 0) != (r == 0)) std::reverse(rings_[r].begin(), rings_[r].end());
    }
  }

  // Direction to p leaves the corner `i` of the ring into the polygon.
  bool intoCorner(const std::vector<std::uint32_t>& ring, std::size_t i, const Point& p) const {
    const Point &previous = at(ring[(i + ring.size() - 1) % ring.size()]), &corner = at(ring[i]),
                &next = at(ring[(i + 1) % ring.size()]);
    const bool leftOfNext = turn(corner, next, p) > 0, rightOfPrevious = turn(corner, previous, p) < 0;
    return turn(previous, corner, next) > 0 ? leftOfNext && rightOfPrevious : leftOfNext || rightOfPrevious;
  }

  // A segment between two vertices passes no other vertex or edge of the ring.
  bool sees(const std::vector<std::uint32_t>& ring, const Point& p, const Point& q) const {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point &a = at(ring[i]), &b = at(ring[(i + 1) % ring.size()]);
      const bool sharesA = a == p || a == q, sharesB = b == p || b == q;
      if (sharesA && sharesB) continue;
      if (sharesA || sharesB) {
        if (onSegment(p, q, sharesA ? b : a)) return false;
      } else if (touch(a, b, p, q)) {
        return false;
      }
    }
    return true;
  }

  // Joins the hole that reaches farthest right to the ring by its shortest free bridge. The hole's rightmost vertex
  // sees a vertex of the ring (Eberly, "Triangulation by Ear Clipping", 2002, section 5), hence one is always found.
  void bridgeOne() {
    const auto rightmost = [&](std::size_t hole) {
      return *std::max_element(rings_[hole].begin(), rings_[hole].end(),
                               [&](auto a, auto b) { return at(a).x < at(b).x; });
    };
    const auto chosen = std::max_element(waiting_.begin(), waiting_.end(),
                                         [&](auto a, auto b) { return at(rightmost(a)).x < at(rightmost(b)).x; });
    const std::size_t hole = *chosen;
    waiting_.erase(chosen);
    const std::uint32_t from = rightmost(hole);
    const Point& p = at(from);

    std::vector<std::size_t> order(ring_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto distance = [&](std::size_t i) {
      return std::hypot(static_cast<double>(at(ring_[i]).x - p.x), static_cast<double>(at(ring_[i]).y - p.y));
    };
    std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return distance(a) < distance(b); });
    for (const std::size_t i : order) {
      const Point& q = at(ring_[i]);
      if (!intoCorner(ring_, i, p) || !sees(ring_, p, q) || !sees(rings_[hole], p, q)) continue;
      if (!std::all_of(waiting_.begin(), waiting_.end(), [&](auto other) { return sees(rings_[other], p, q); }))
        continue;
      std::vector<std::uint32_t> bridge = rings_[hole];
      std::rotate(bridge.begin(), std::find(bridge.begin(), bridge.end(), from), bridge.end());
      bridge.push_back(from);
      bridge.push_back(ring_[i]);
      ring_.insert(ring_.begin() + static_cast<std::ptrdiff_t>(i) + 1, bridge.begin(), bridge.end());
      return;
    }
    throw std::invalid_argument(
        fmt::format("has {} where no bridge to the outline was found; split it in two", nameOf(hole)));
  }

  bool isEar(std::size_t i) const {
    const std::size_t n = ring_.size();
    const Point &a = at(ring_[(i + n - 1) % n]), &b = at(ring_[i]), &c = at(ring_[(i + 1) % n]);
    if (turn(a, b, c) <= 0) return false;
    for (std::size_t j = 0; j < n; ++j) {
      const Point& p = at(ring_[j]);
      if (p == a || p == b || p == c) continue;
      if (turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0) return false;
    }
    return true;
  }

  void clipEars() {
    std::size_t i = 0, tried = 0;
    while (ring_.size() > 3) {
      const std::size_t n = ring_.size();
      if (tried == n) throw std::invalid_argument("could not be cut into triangles; split it into simpler polygons");
      i %= n;
      if (isEar(i)) {
        triangles_.push_back({ring_[(i + n - 1) % n], ring_[i], ring_[(i + 1) % n]});
        ring_.erase(ring_.begin() + static_cast<std::ptrdiff_t>(i));
        tried = 0;
        // Going on with the vertex after next keeps fans, and so slivers, rare.
        ++i;
      } else {
        ++i, ++tried;
      }
    }
    triangles_.push_back({ring_[0], ring_[1], ring_[2]});
  }

  std::vector<Point> points_;
  std::vector<std::vector<std::uint32_t>> rings_;
  std::vector<std::size_t> waiting_;
  std::vector<std::uint32_t> ring_;
  std::vector<Triangle> triangles_;
};

// Twice the area times the unit normal. — Newell's method; Sutherland, Sproull, Schumacker, ACM Computing Surveys 6
// (1974)
Vec3 newellNormal(const std::vector<Vec3>& ring) {
  Vec3 sum(0);
  for (std::size_t i = 0; i < ring.size(); ++i) {
    sum += glm::cross(ring[i] - ring[0], ring[(i + 1) % ring.size()] - ring[0]);
  }
  return sum;
}

}  // namespace

std::vector<Triangle> triangulate(const std::vector<std::vector<Vec2>>& rings) {
  return Triangulator(rings).run();
}

std::vector<Triangle> triangulateInSpace(const std::vector<std::vector<Vec3>>& rings, const std::string& what) {
  const auto refuse = [&](const std::string& why) { throw std::invalid_argument(what + " " + why); };
  if (rings.empty() || rings[0].size() < 3) refuse("needs at least 3 vertices");
  Bounds box;
  Vec3 middle(0);
  for (const auto& ring : rings) {
    for (const Vec3& p : ring) {
      if (!std::isfinite(p.x + p.y + p.z)) refuse("has a vertex that is not a finite point");
      box.add(p);
    }
  }
  for (const Vec3& p : rings[0]) middle += p / static_cast<double>(rings[0].size());
  const Vec3 sum = newellNormal(rings[0]);
  const double extent = glm::length(box.extent());
  if (!(glm::length(sum) > 1e-12 * extent * extent))
    refuse("has no area: its vertices lie on a line or its edges cross");
  const Vec3 normal = glm::normalize(sum);
  Vec3 x, y;
  core::perpendiculars(normal, x, y);
  std::vector<std::vector<Vec2>> flat(rings.size());
  for (std::size_t r = 0; r < rings.size(); ++r) {
    for (std::size_t i = 0; i < rings[r].size(); ++i) {
      const Vec3 p = rings[r][i] - middle;
      const double height = std::abs(glm::dot(p, normal));
      if (height > 1e-3 * extent) {
        refuse(fmt::format("is not flat: vertex {} of {} is {:.3g} m off the plane of the outline", i + 1,
                           r == 0 ? "the outline" : fmt::format("hole {}", r), height));
      }
      flat[r].emplace_back(glm::dot(p, x), glm::dot(p, y));
    }
  }
  try {
    return triangulate(flat);
  } catch (const std::invalid_argument& error) {
    refuse(error.what());
  }
  return {};
}

}  // namespace goniolux::geometry
