#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "plot/figure.h"

namespace goniolux::plot {
namespace {

using core::Vec2;
using Key = std::pair<long long, long long>;

Key keyOf(const Vec2& point, double cell) {
  return {std::llround(point.x / cell), std::llround(point.y / cell)};
}

}  // namespace

std::vector<Polyline> joined(const std::vector<std::pair<Vec2, Vec2>>& segments, double tolerance) {
  std::multimap<Key, std::size_t> ends;
  std::vector<bool> used(segments.size(), false);
  std::map<std::pair<Key, Key>, bool> known;  // a segment drawn twice is drawn once
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const Key a = keyOf(segments[i].first, tolerance), b = keyOf(segments[i].second, tolerance);
    if (a == b || std::exchange(known[std::minmax(a, b)], true)) {
      used[i] = true;
      continue;
    }
    ends.emplace(a, i);
    ends.emplace(b, i);
  }
  const auto takeAt = [&](const Vec2& point) -> const std::pair<Vec2, Vec2>* {
    const auto [first, last] = ends.equal_range(keyOf(point, tolerance));
    for (auto it = first; it != last; ++it) {
      if (!used[it->second]) {
        used[it->second] = true;
        return &segments[it->second];
      }
    }
    return nullptr;
  };
  const auto grow = [&](Polyline& line) {
    while (const auto* next = takeAt(line.back())) {
      const bool forward = keyOf(next->first, tolerance) == keyOf(line.back(), tolerance);
      line.push_back(forward ? next->second : next->first);
    }
  };
  std::vector<Polyline> lines;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    if (used[i]) continue;
    used[i] = true;
    Polyline line{segments[i].first, segments[i].second};
    grow(line);
    std::reverse(line.begin(), line.end());
    grow(line);
    lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace goniolux::plot
