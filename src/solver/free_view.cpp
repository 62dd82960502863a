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

}  // namespace

/// The hull of a point and a box, by its bounding box and the lines that touch the box as seen along each axis.
class FreeView::Shaft {
 public:
  Shaft(const Vec3& point, const Bounds& target, double tolerance)
      : point_(point), target_(target), tolerance_(tolerance) {
    hull_ = target;
    hull_.add(point);
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

  [[nodiscard]] bool misses(const Vec3& u, const Vec3& v, const Vec3& w) const {
    Bounds box;
    box.add(u), box.add(v), box.add(w);
    if (misses(box)) return true;
    for (int l = 0; l < lines_; ++l) {
      const Line& line = line_[static_cast<std::size_t>(l)];
      const auto side = [&](const Vec3& x) { return line.nx * x[line.a] + line.ny * x[line.b]; };
      if (std::min({side(u), side(v), side(w)}) >= line.offset - tolerance_) return true;
    }
    // The whole shaft on one side of the triangle's plane?
    const Vec3 normal = glm::cross(v - u, w - u);
    const double length = glm::length(normal);
    if (!(length > 0)) return true;
    const double here = glm::dot(point_ - u, normal) / length;
    double low = here, high = here;
    for (int corner = 0; corner < 8; ++corner) {
      const Vec3 x((corner & 1) != 0 ? target_.max.x : target_.min.x, (corner & 2) != 0 ? target_.max.y : target_.min.y,
                   (corner & 4) != 0 ? target_.max.z : target_.min.z);
      const double d = glm::dot(x - u, normal) / length;
      low = std::min(low, d);
      high = std::max(high, d);
    }
    return low >= -tolerance_ || high <= tolerance_;
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
      const double dx = c[0] - px, dy = c[1] - py, length = std::hypot(dx, dy);
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

  Vec3 point_;
  Bounds target_, hull_;
  double tolerance_;
  std::array<Line, 12> line_{};
  int lines_ = 0;
};

FreeView::FreeView(const scene::World& world) : world_(world) {
  std::vector<Bounds> boxes;
  boxes.reserve(world.triangles.size() + world.patches.size());
  for (const auto& t : world.triangles) {
    Bounds& box = boxes.emplace_back();
    for (const std::uint32_t corner : t) box.add(world.vertices[corner]);
  }
  for (const scene::PlacedPatch& patch : world.patches) {
    boxes.push_back(geometry::boundsOf(patch.patch));
    patchBoxes_.push_back(boxes.back());
  }
  // Instances by their boxes, after the patches.
  for (const Bounds& box : scene::instanceBounds(world)) {
    boxes.push_back(box);
    patchBoxes_.push_back(box);
  }
  order_.resize(boxes.size());
  std::iota(order_.begin(), order_.end(), 0u);
  nodes_.emplace_back();
  split(0, 0, static_cast<std::uint32_t>(boxes.size()), boxes);
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

bool FreeView::mayBlock(const Shaft& shaft, std::uint32_t primitive) const {
  const auto triangles = static_cast<std::uint32_t>(world_.triangles.size());
  if (primitive >= triangles) return !shaft.misses(patchBoxes_[primitive - triangles]);
  const auto& t = world_.triangles[primitive];
  return !shaft.misses(world_.vertices[t[0]], world_.vertices[t[1]], world_.vertices[t[2]]);
}

bool FreeView::isFree(const Vec3& point, const Bounds& target, std::uint32_t own) const {
  if (target.empty() || nodes_.front().box.empty()) return false;
  const Shaft shaft(point, target, 1e-9 * world_.radius);
  const auto triangles = static_cast<std::uint32_t>(world_.triangles.size());
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
      const std::uint32_t p = order_[i];
      if (p < triangles + world_.patches.size()) {  // instances emit nothing
        const std::uint32_t surface =
            p < triangles ? world_.triangleSurfaces[p] : world_.patches[p - triangles].surface;
        if (world_.surfaces[surface].emitter == own) continue;
      }
      if (mayBlock(shaft, p)) return false;
    }
  }
  return true;
}

}  // namespace goniolux::solver
