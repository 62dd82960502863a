#include "plot/label_placement.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace goniolux::plot {
namespace {

using core::Vec2;

std::array<Vec2, 4> corners(const LabelBox& box) {
  const Vec2 x = Vec2(std::cos(box.angle), std::sin(box.angle)) * (box.width / 2);
  const Vec2 y = Vec2(-std::sin(box.angle), std::cos(box.angle)) * (box.height / 2);
  return {box.center - x - y, box.center + x - y, box.center + x + y, box.center - x + y};
}

/// True if the direction separates the two boxes (separating-axis test for rectangles).
bool separates(const Vec2& axis, const std::array<Vec2, 4>& a, const std::array<Vec2, 4>& b) {
  double aLow = 1e300, aHigh = -1e300, bLow = 1e300, bHigh = -1e300;
  for (std::size_t i = 0; i < 4; ++i) {
    const double pa = glm::dot(axis, a[i]), pb = glm::dot(axis, b[i]);
    aLow = std::min(aLow, pa);
    aHigh = std::max(aHigh, pa);
    bLow = std::min(bLow, pb);
    bHigh = std::max(bHigh, pb);
  }
  return aHigh < bLow || bHigh < aLow;
}

/// A polyline by its arc length.
class Arc {
 public:
  explicit Arc(const Polyline& line) : line_(line) {
    at_.push_back(0);
    for (std::size_t i = 1; i < line.size(); ++i) at_.push_back(at_.back() + glm::distance(line[i - 1], line[i]));
  }
  [[nodiscard]] double length() const { return at_.back(); }
  [[nodiscard]] Vec2 point(double s) const {
    const auto above = std::upper_bound(at_.begin(), at_.end(), s);
    const auto i = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(above - at_.begin(), 1, std::ssize(at_) - 1));
    const double step = at_[i] - at_[i - 1];
    const double f = step > 0 ? std::clamp((s - at_[i - 1]) / step, 0.0, 1.0) : 0;
    return glm::mix(line_[i - 1], line_[i], f);
  }
  /// The points from..to, both ends included.
  [[nodiscard]] Polyline part(double from, double to) const {
    Polyline part{point(from)};
    for (std::size_t i = 0; i < line_.size(); ++i) {
      if (at_[i] > from && at_[i] < to) part.push_back(line_[i]);
    }
    part.push_back(point(to));
    return part;
  }

 private:
  const Polyline& line_;
  std::vector<double> at_;
};

/// How far the line strays from the chord between two of its arc lengths.
double sag(const Arc& arc, double from, double to) {
  const Vec2 a = arc.point(from), chord = arc.point(to) - a;
  const double length = glm::length(chord);
  if (!(length > 0)) return 1e300;
  double largest = 0;
  for (int k = 1; k < 8; ++k) {
    const Vec2 d = arc.point(from + (to - from) * k / 8) - a;
    largest = std::max(largest, std::abs(chord.x * d.y - chord.y * d.x) / length);
  }
  return largest;
}

}  // namespace

bool overlap(const LabelBox& a, const LabelBox& b) {
  const std::array<Vec2, 4> ca = corners(a), cb = corners(b);
  for (const double angle : {a.angle, b.angle}) {
    const Vec2 x(std::cos(angle), std::sin(angle)), y(-x.y, x.x);
    if (separates(x, ca, cb) || separates(y, ca, cb)) return false;
  }
  return true;
}

bool LabelPlacement::isFree(const LabelBox& box, bool mindSoftLines, std::size_t owner) const {
  for (const Vec2& corner : corners(box)) {
    if (corner.x < low_.x || corner.y < low_.y || corner.x > high_.x || corner.y > high_.y) return false;
  }
  const double reach = std::hypot(box.width, box.height) / 2;
  const auto crosses = [&](const Line& line) {
    if ((line.soft && !mindSoftLines) || (owner != 0 && line.owner == owner)) return false;
    const Vec2 along = line.to - line.from, middle = (line.from + line.to) / 2.0;
    const double length = glm::length(along);
    if (glm::distance(middle, box.center) > reach + length / 2) return false;
    return overlap(box, {middle, length, 0, std::atan2(along.y, along.x)});
  };
  return std::none_of(taken_.begin(), taken_.end(), [&](const LabelBox& other) { return overlap(box, other); }) &&
         std::none_of(lines_.begin(), lines_.end(), crosses);
}

void LabelPlacement::avoidLine(const Polyline& line, bool softly, std::size_t owner) {
  for (std::size_t i = 1; i < line.size(); ++i) lines_.push_back({line[i - 1], line[i], softly, owner});
}

std::vector<LineLabel> LabelPlacement::alongLine(const Polyline& line, double width, double height, double spacing,
                                                 std::size_t owner) {
  std::vector<LineLabel> labels;
  if (line.size() < 2) return labels;
  const Arc arc(line);
  if (arc.length() < 2 * width) return labels;

  struct Candidate {
    LineLabel label;
    double badness = 0;
  };
  std::vector<Candidate> candidates;
  constexpr double step = 5;
  for (double s = width; s <= arc.length() - width; s += step) {
    const double from = s - width / 2, to = s + width / 2;
    const double stray = sag(arc, from, to);
    if (stray > 0.35 * height) continue;
    const Vec2 a = arc.point(from), b = arc.point(to);
    double angle = std::atan2(b.y - a.y, b.x - a.x);
    if (angle > core::pi / 2) angle -= core::pi;
    if (angle <= -core::pi / 2) angle += core::pi;
    // Straight, then level, then towards the middle of the line.
    const double badness = stray / height + 0.15 * std::abs(std::sin(angle)) + 0.2 * std::abs(s / arc.length() - 0.5);
    candidates.push_back({{{(a + b) / 2.0, width, height, angle}, from, to}, badness});
  }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.badness < b.badness; });
  for (const bool mindSoftLines : {true, false}) {
    if (!labels.empty()) break;
    for (const Candidate& candidate : candidates) {
      const bool apart = std::all_of(labels.begin(), labels.end(), [&](const LineLabel& other) {
        const double away = std::abs(candidate.label.from - other.from);
        return away >= spacing;
      });
      if (!apart || !isFree(candidate.label.box, mindSoftLines, owner)) continue;
      occupy(candidate.label.box);
      labels.push_back(candidate.label);
    }
  }
  std::sort(labels.begin(), labels.end(), [](const LineLabel& a, const LineLabel& b) { return a.from < b.from; });
  return labels;
}

double lengthOf(const Polyline& line) {
  double length = 0;
  for (std::size_t i = 1; i < line.size(); ++i) length += glm::distance(line[i - 1], line[i]);
  return length;
}

std::vector<Polyline> withGaps(const Polyline& line, const std::vector<LineLabel>& labels) {
  if (line.size() < 2 || labels.empty()) return {line};
  const Arc arc(line);
  std::vector<Polyline> parts;
  double from = 0;
  for (const LineLabel& label : labels) {
    if (label.from > from) parts.push_back(arc.part(from, label.from));
    from = label.to;
  }
  if (arc.length() > from) parts.push_back(arc.part(from, arc.length()));
  return parts;
}

}  // namespace goniolux::plot
