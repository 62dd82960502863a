#include "solver/free_view.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "geometry/quadric_intersect.h"

namespace goniolux::solver {

using core::Vec3;
using geometry::Bounds;

namespace {

constexpr std::uint32_t leafSize = 4;
constexpr double largeShare = 0.5;  // of the scene's extent along an axis

}  // namespace

/// The hull of a point and a box, by its bounding box and the lines that touch the box as seen along each axis.
class FreeView::Shaft {
 public:
  Shaft(const Vec3& point, const Bounds& target, double tolerance)
      : point_(point), target_(target), tolerance_(tolerance) {
    hull_ = target;
    hull_.add(point);
    center_ = 0.5 * (target.min + target.max);
    halfExtent_ = 0.5 * (target.max - target.min);
    for (int axis = 0; axis < 3; ++axis) addLines((axis + 1) % 3, (axis + 2) % 3);
  }

  /// The box is wholly outside: beside the hull's box, or beyond one of the lines. Touching is outside.
  [[nodiscard]] bool misses(const Bounds& box) const {
    for (int a = 0; a < 3; ++a)
      if (box.min[a] >= hull_.max[a] - tolerance_ || box.max[a] <= hull_.min[a] + tolerance_)
        return thin(a) ? beside(box, a) : true;
    for (int l = 0; l < lines_; ++l) {
      const Line& line = line_[static_cast<std::size_t>(l)];
      // The corner of the box that is farthest inside.
      const double p = line.nx > 0 ? box.min[line.a] : box.max[line.a];
      const double q = line.ny > 0 ? box.min[line.b] : box.max[line.b];
      if (line.nx * p + line.ny * q >= line.offset - tolerance_) return true;
    }
    return false;
  }

  /// The whole shaft lies on one side of a plane.
  [[nodiscard]] bool isBeside(const Vec3& normal, double offset) const {
    const double here = glm::dot(point_, normal) - offset;
    const double middle = glm::dot(center_, normal) - offset, reach = glm::dot(halfExtent_, glm::abs(normal));
    return std::min(here, middle - reach) >= -tolerance_ || std::max(here, middle + reach) <= tolerance_;
  }

  [[nodiscard]] bool missesTriangle(const std::array<Vec3, 3>& corners) const {
    for (int l = 0; l < lines_; ++l) {
      const Line& line = line_[static_cast<std::size_t>(l)];
      const auto side = [&](const Vec3& x) { return line.nx * x[line.a] + line.ny * x[line.b]; };
      if (std::min({side(corners[0]), side(corners[1]), side(corners[2])}) >= line.offset - tolerance_) return true;
    }
    return false;
  }

 private:
  struct Line {
    int a, b;
    double nx, ny, offset;  ///< inside: nx x + ny y < offset
  };

  // A shaft without extent along an axis (both ends in one plane) has no inside there: only what is truly beside it
  // misses it.
  [[nodiscard]] bool thin(int a) const { return hull_.max[a] - hull_.min[a] <= 2 * tolerance_; }
  [[nodiscard]] bool beside(const Bounds& box, int a) const {
    return box.min[a] > hull_.max[a] + tolerance_ || box.max[a] < hull_.min[a] - tolerance_;
  }

  // In the plane of axes a and b: the lines from the point that touch the box, where the point is outside of it.
  void addLines(int a, int b) {
    const double px = point_[a], py = point_[b];
    const std::array<std::array<double, 2>, 4> corners{{{target_.min[a], target_.min[b]},
                                                        {target_.max[a], target_.min[b]},
                                                        {target_.min[a], target_.max[b]},
                                                        {target_.max[a], target_.max[b]}}};
    for (const auto& c : corners) {
      const double dx = c[0] - px, dy = c[1] - py, length = std::sqrt(dx * dx + dy * dy);
      if (length <= tolerance_) return;
      const double nx = dy / length, ny = -dx / length, offset = nx * px + ny * py;
      double low = 0, high = 0;
      for (const auto& other : corners) {
        const double side = nx * other[0] + ny * other[1] - offset;
        low = std::min(low, side);
        high = std::max(high, side);
      }
      if (high <= tolerance_)
        line_[static_cast<std::size_t>(lines_++)] = {a, b, nx, ny, offset};
      else if (low >= -tolerance_)
        line_[static_cast<std::size_t>(lines_++)] = {a, b, -nx, -ny, -offset};
    }
  }

  Vec3 point_, center_, halfExtent_;
  Bounds target_, hull_;
  double tolerance_;
  std::array<Line, 12> line_{};
  int lines_ = 0;
};

FreeView::FreeView(const scene::World& world) : tolerance_(1e-9 * world.radius) {
  std::vector<Blocker> blockers;
  blockers.reserve(world.triangles.size() + world.patches.size());
  for (std::size_t t = 0; t < world.triangles.size(); ++t) {
    Blocker& blocker = blockers.emplace_back();
    for (std::size_t c = 0; c < 3; ++c) {
      blocker.corners[c] = world.vertices[world.triangles[t][c]];
      blocker.box.add(blocker.corners[c]);
    }
    const Vec3 normal = glm::cross(blocker.corners[1] - blocker.corners[0], blocker.corners[2] - blocker.corners[0]);
    const double length = glm::length(normal);
    if (!(length > 0)) {
      blockers.pop_back();  // without area it blocks nothing
      continue;
    }
    blocker.normal = normal / length;
    blocker.offset = glm::dot(blocker.normal, blocker.corners[0]);
    blocker.emitter = world.surfaces[world.triangleSurfaces[t]].emitter;
  }
  for (const scene::PlacedPatch& patch : world.patches) {
    Blocker& blocker = blockers.emplace_back();
    blocker.box = geometry::boundsOf(patch.patch);
    blocker.emitter = world.surfaces[patch.surface].emitter;
  }
  for (const Bounds& box : scene::instanceBounds(world)) blockers.emplace_back().box = box;  // they emit nothing

  std::vector<Bounds> boxes;
  boxes.reserve(blockers.size());
  for (const Blocker& blocker : blockers) boxes.push_back(blocker.box);
  order_.resize(boxes.size());
  std::iota(order_.begin(), order_.end(), 0u);
  // Walls, floor and ceiling stand apart, or the boxes of everything would be as large as theirs.
  Bounds all;
  for (const Bounds& box : boxes) all.add(box.min), all.add(box.max);
  const auto isLarge = [&](std::uint32_t i) {
    const Vec3 share = boxes[i].extent() / glm::max(all.extent(), Vec3(1e-300));
    return std::max({share.x, share.y, share.z}) > largeShare;
  };
  const auto large = static_cast<std::uint32_t>(
      boxes.empty() ? 0 : std::stable_partition(order_.begin(), order_.end(), isLarge) - order_.begin());
  const auto count = static_cast<std::uint32_t>(boxes.size());
  nodes_.emplace_back();
  if (large == 0 || large == count) {
    split(0, 0, count, boxes);
  } else {
    nodes_.resize(3);
    nodes_[0] = {all, 1, 0};
    split(1, 0, large, boxes);
    split(2, large, count - large, boxes);
  }
  blockers_.reserve(blockers.size());
  for (const std::uint32_t i : order_) blockers_.push_back(blockers[i]);
  order_.clear();
}

void FreeView::split(std::uint32_t node, std::uint32_t first, std::uint32_t count, const std::vector<Bounds>& boxes) {
  Bounds all, centers;
  for (std::uint32_t i = first; i < first + count; ++i) {
    all.add(boxes[order_[i]]);
    centers.add(boxes[order_[i]].center());
  }
  nodes_[node].box = all;
  nodes_[node].first = first;
  nodes_[node].count = count;
  if (count <= leafSize) return;
  const Vec3 extent = centers.extent();
  const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
  const std::uint32_t half = count / 2;
  const auto begin = order_.begin() + first;
  std::nth_element(begin, begin + half, begin + count,
                   [&](std::uint32_t a, std::uint32_t b) { return boxes[a].center()[axis] < boxes[b].center()[axis]; });
  const auto children = static_cast<std::uint32_t>(nodes_.size());
  nodes_.resize(nodes_.size() + 2);
  nodes_[node].first = children;
  nodes_[node].count = 0;
  split(children, first, half, boxes);
  split(children + 1, first + half, count - half, boxes);
}

bool FreeView::isFree(const Vec3& point, const Bounds& target, std::uint32_t own) const {
  if (target.empty() || nodes_.front().box.empty()) return false;
  const Shaft shaft(point, target, tolerance_);
  std::array<std::uint32_t, 64> stack{};
  int depth = 0;
  stack[static_cast<std::size_t>(depth++)] = 0;
  while (depth > 0) {
    const Node& node = nodes_[stack[static_cast<std::size_t>(--depth)]];
    if (shaft.misses(node.box)) continue;
    if (node.count == 0) {
      stack[static_cast<std::size_t>(depth++)] = node.first;
      stack[static_cast<std::size_t>(depth++)] = node.first + 1;
      continue;
    }
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      const Blocker& blocker = blockers_[i];
      if (blocker.emitter == own) continue;
      // A room's walls: most shafts lie on their inner side.
      const bool isTriangle = blocker.normal != Vec3(0);
      if (isTriangle && shaft.isBeside(blocker.normal, blocker.offset)) continue;
      if (shaft.misses(blocker.box)) continue;
      if (isTriangle && shaft.missesTriangle(blocker.corners)) continue;
      return false;
    }
  }
  return true;
}

}  // namespace goniolux::solver
