// Hidden lines of a plan: a segment is cut, in closed form, by every triangle above it.
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include "pipeline/feature_edges.h"

namespace goniolux::pipeline {
namespace {

using core::Vec2;
using core::Vec3;
using Interval = std::pair<double, double>;

double cross2(const Vec2& a, const Vec2& b) {
  return a.x * b.y - a.y * b.x;
}

/// The part of the segment (as t in [0, 1]) that lies in the triangle's plan and more than `tolerance` below it.
std::optional<Interval> hiddenPart(const Segment& segment, const Triangle& triangle, double tolerance) {
  const Vec2 from(segment.from), along(Vec2(segment.to) - Vec2(segment.from));
  const Vec2 a(triangle[0]), ab(Vec2(triangle[1]) - a), ac(Vec2(triangle[2]) - a);
  const double area2 = cross2(ab, ac);
  const double size = std::max(glm::dot(ab, ab), glm::dot(ac, ac));
  if (!(std::abs(area2) > 1e-9 * size)) return std::nullopt;  // seen edge on

  // Barycentric coordinates and the height of the triangle above the segment are linear in t; each bounds the interval.
  double low = 0, high = 1;
  const auto bound = [&](double atZero, double slope, double minimum) {
    if (std::abs(slope) < 1e-15) {
      if (atZero < minimum) high = -1;
      return;
    }
    const double t = (minimum - atZero) / slope;
    if (slope > 0) {
      low = std::max(low, t);
    } else {
      high = std::min(high, t);
    }
  };
  const double v0 = cross2(from - a, ac) / area2, vt = cross2(along, ac) / area2;
  const double w0 = cross2(ab, from - a) / area2, wt = cross2(ab, along) / area2;
  constexpr double rim = -1e-9;  // points on the rim count as inside
  bound(v0, vt, rim);
  bound(w0, wt, rim);
  bound(1 - v0 - w0, -vt - wt, rim);
  const double ab_z = triangle[1].z - triangle[0].z, ac_z = triangle[2].z - triangle[0].z;
  const double above0 = triangle[0].z + v0 * ab_z + w0 * ac_z - segment.from.z;
  const double aboveSlope = vt * ab_z + wt * ac_z - (segment.to.z - segment.from.z);
  bound(above0, aboveSlope, tolerance);
  if (!(high > low)) return std::nullopt;
  return Interval{low, high};
}

}  // namespace

/// Triangles by the squares of the plan that they touch, so that a segment meets only those near it.
class PlanCovers::Index {
 public:
  Index(const std::vector<Triangle>& triangles, Vec2 low, Vec2 high) : low_(low) {
    cells_ = triangles.size() > 64 ? 64 : 1;
    cell_ = glm::max((high - low) / static_cast<double>(cells_), Vec2(1e-9));
    lists_.resize(static_cast<std::size_t>(cells_ * cells_));
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      const auto& [a, b, c] = triangles[i];
      forCells(glm::min(Vec2(a), glm::min(Vec2(b), Vec2(c))), glm::max(Vec2(a), glm::max(Vec2(b), Vec2(c))),
               [&](std::vector<std::size_t>& list) { list.push_back(i); });
    }
    seen_.assign(triangles.size(), 0);
  }

  template <typename Visit>
  void near(const Segment& segment, Visit visit) {
    ++round_;
    const Vec2 a(segment.from), b(segment.to);
    forCells(glm::min(a, b), glm::max(a, b), [&](const std::vector<std::size_t>& list) {
      for (const std::size_t i : list) {
        if (std::exchange(seen_[i], round_) != round_) visit(i);
      }
    });
  }

 private:
  int clamped(double position) const { return static_cast<int>(std::clamp(std::floor(position), 0.0, cells_ - 1.0)); }

  template <typename Visit>
  void forCells(Vec2 low, Vec2 high, Visit visit) {
    const Vec2 first = (low - low_) / cell_, last = (high - low_) / cell_;
    for (int y = clamped(first.y); y <= clamped(last.y); ++y) {
      for (int x = clamped(first.x); x <= clamped(last.x); ++x) visit(lists_[static_cast<std::size_t>(y * cells_ + x)]);
    }
  }

  Vec2 low_, cell_{1};
  int cells_ = 1;
  std::vector<std::vector<std::size_t>> lists_;
  std::vector<std::size_t> seen_;
  std::size_t round_ = 0;
};

PlanCovers::PlanCovers(std::vector<Triangle> covers) : covers_(std::move(covers)) {
  Vec2 low(std::numeric_limits<double>::max()), high(std::numeric_limits<double>::lowest());
  for (const Triangle& triangle : covers_) {
    for (const Vec3& corner : triangle) {
      low = glm::min(low, Vec2(corner));
      high = glm::max(high, Vec2(corner));
    }
  }
  if (covers_.empty()) low = high = Vec2(0);
  index_ = std::make_unique<Index>(covers_, low, high);
}

PlanCovers::~PlanCovers() = default;

std::vector<Segment> PlanCovers::visible(const std::vector<Segment>& segments, double tolerance) const {
  std::vector<Segment> visible;
  for (const Segment& segment : segments) {
    const double length = glm::distance(Vec2(segment.from), Vec2(segment.to));
    if (!(length > tolerance)) continue;
    std::vector<Interval> hidden;
    index_->near(segment, [&](std::size_t i) {
      if (const auto part = hiddenPart(segment, covers_[i], tolerance)) hidden.push_back(*part);
    });
    std::sort(hidden.begin(), hidden.end());
    double reached = 0;
    const auto keep = [&](double from, double to) {
      if ((to - from) * length <= tolerance) return;
      visible.push_back({glm::mix(segment.from, segment.to, from), glm::mix(segment.from, segment.to, to)});
    };
    for (const auto& [from, to] : hidden) {
      keep(reached, from);
      reached = std::max(reached, to);
    }
    keep(reached, 1);
  }
  return visible;
}

}  // namespace goniolux::pipeline
