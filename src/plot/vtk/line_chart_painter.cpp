#include "plot/vtk/line_chart_painter.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "plot/label_placement.h"
#include "plot/levels.h"
#include "plot/number_text.h"

namespace goniolux::plot {
namespace {

using core::Vec2;
using Align = TextStyle::Align;

constexpr Rgb grid{0xdd, 0xdd, 0xdd}, guide{0x80, 0x80, 0x80}, pale{0xf1, 0xe2, 0xa6};
// Told apart also without colour, by their dashes.
constexpr Rgb colours[] = {{0x1b, 0x4f, 0x9c}, {0xc2, 0x55, 0x0a}, {0x2d, 0x7d, 0x46},
                           {0x7a, 0x3b, 0x8f}, {0x8a, 0x6d, 0x00}, {0x44, 0x44, 0x44}};
constexpr double dashes[][2] = {{0, 0}, {12, 7}, {4, 5}, {18, 5}, {8, 4}, {2, 4}};
constexpr double left = 110, right = 40, top = 150, bottom = 150;

std::vector<Polyline> dashed(const Polyline& line, double on, double off) {
  if (on <= 0) return {line};
  std::vector<LineLabel> gaps;
  for (double s = on; s < lengthOf(line); s += on + off) gaps.push_back({{}, s, s + off});
  return withGaps(line, gaps);
}

Polyline ring(const Vec2& middle, double radius) {
  Polyline corners;
  constexpr int count = 24;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * core::pi * i / count;
    corners.push_back(middle + radius * Vec2(std::cos(angle), std::sin(angle)));
  }
  return corners;
}

}  // namespace

double LineChartPainter::Range::fraction(double value) const {
  return logarithmic ? std::log(value / low) / std::log(high / low) : (value - low) / (high - low);
}

std::vector<double> LineChartPainter::Range::ticks(int wanted) const {
  return logarithmic ? decadeTicks(low, high) : axisTicks(low, high, wanted);
}

LineChartPainter::LineChartPainter(const LineChart& chart, int width, int height)
    : chart_(chart), width_(width), height_(height) {
  constexpr double huge = std::numeric_limits<double>::max();
  Vec2 low(huge), high(-huge);
  for (const ChartCurve& curve : chart.curves)
    for (const Vec2& point : curve.points) {
      low = glm::min(low, point);
      high = glm::max(high, point);
    }
  const bool marked = std::any_of(chart.curves.begin(), chart.curves.end(), [](const auto& c) { return c.marked; });
  if (marked) {  // room for the dots
    constexpr double room = 1.25;
    if (chart.x.logarithmic) low.x /= room, high.x *= room;
    if (chart.y.logarithmic) {
      low.y /= room, high.y *= room;
      for (const double value : chart.guides)
        if (value > 0) low.y = std::min(low.y, value / room);
      for (const ChartLevel& level : chart.levels) {
        low.y = std::min(low.y, level.y / room);
        high.y = std::max(high.y, level.y * room * room);  // for the words on it
      }
    }
  }
  x_ = {low.x, high.x > low.x ? high.x : low.x + 1, chart.x.logarithmic};
  if (chart.y.logarithmic) {
    y_ = {low.y, high.y > low.y ? high.y : 10 * low.y, true};
  } else {
    y_ = {std::min(0.0, low.y), high.y > 0 ? 1.05 * high.y : 1, false};
  }
}

Vec2 LineChartPainter::at(const Vec2& point) const {
  return {left + (width() - left - right) * x_.fraction(point.x),
          bottom + (height() - top - bottom) * y_.fraction(point.y)};
}

void LineChartPainter::paintAxes(Ink& ink) const {
  const Vec2 low(left, bottom), high(width() - right, height() - top);
  for (const double tick : x_.ticks(10)) {
    const double x = at({tick, y_.low}).x;
    ink.line({{x, low.y}, {x, high.y}}, grid, 1);
    ink.text(levelText(tick), {x, low.y - 20}, {15, false, black, 0, Align::center});
  }
  for (const double tick : y_.ticks(6)) {
    const double y = at({x_.low, tick}).y;
    ink.line({{low.x, y}, {high.x, y}}, grid, 1);
    ink.text(levelText(tick), {low.x - 10, y}, {15, false, black, 0, Align::right});
  }
  for (const double value : chart_.guides) {
    if (value < y_.low || value > y_.high) continue;
    const double y = at({x_.low, value}).y;
    ink.line({{low.x, y}, {high.x, y}}, guide, 1.6);
  }
  for (const ChartLevel& level : chart_.levels) {
    if (level.y < y_.low || level.y > y_.high) continue;
    const double y = at({x_.low, level.y}).y, x = level.from > x_.low ? at({level.from, level.y}).x : low.x;
    for (const Polyline& part : dashed({{x, y}, {high.x, y}}, 3, 5)) ink.line(part, guide, 1.6);
    ink.text(level.text, {high.x - 10, y + 12}, {14, false, grey, 0, Align::right});
  }
  ink.line({low, {high.x, low.y}, high, {low.x, high.y}, low}, black, 1.2);
  ink.text(chart_.x.title, {(low.x + high.x) / 2, low.y - 48}, {16, false, black, 0, Align::center});
  ink.text(chart_.y.title, {28, (low.y + high.y) / 2}, {16, false, black, core::pi / 2, Align::center});
}

void LineChartPainter::paint(Ink& ink) const {
  const double high = height(), edge = 40;
  ink.text(chart_.title, {edge, high - 44}, fitting(chart_.title, {28, true}, width() - 2 * edge));
  ink.text(chart_.subtitle, {edge, high - 82}, fitting(chart_.subtitle, {18, false, grey}, width() - 2 * edge));
  std::string facts;
  for (const std::string& fact : chart_.facts) facts += (facts.empty() ? "" : "     ") + fact;
  ink.text(facts, {edge, high - 116}, fitting(facts, {17}, width() - 2 * edge));
  Polyline front;
  for (const Vec2& point : chart_.front) front.push_back(at(point));
  if (front.size() > 1) ink.line(front, pale, 14);
  paintAxes(ink);
  double x = left, y = 68;  // of the legend, in rows where one is too short
  for (std::size_t k = 0; k < chart_.curves.size(); ++k) {
    Polyline line;
    for (const Vec2& point : chart_.curves[k].points) line.push_back(at(point));
    for (const Polyline& part : dashed(line, dashes[k][0], dashes[k][1])) ink.line(part, colours[k], 2.4);
    if (chart_.curves[k].marked)
      for (const Vec2& point : line) ink.area(ring(point, 5), colours[k]);
    const double entry = 54 + textSize(chart_.curves[k].name, {16}).x;
    if (x > left && x + entry > width() - edge) x = left, y -= 20;
    const Polyline sample{{x, y}, {x + 44, y}};
    for (const Polyline& part : dashed(sample, dashes[k][0], dashes[k][1])) ink.line(part, colours[k], 2.4);
    ink.text(chart_.curves[k].name, {x + 54, y}, {16});
    x += entry + 34;
  }
  if (front.size() > 1 && !chart_.frontName.empty()) {
    if (x > left && x + 54 + textSize(chart_.frontName, {16}).x > width() - edge) x = left, y -= 20;
    ink.line({{x, y}, {x + 44, y}}, pale, 14);
    ink.text(chart_.frontName, {x + 54, y}, {16});
  }
  for (const ChartNote& note : chart_.notes) {
    const Vec2 place = at(note.point);
    if (!note.ring) {
      ink.text(note.text, place + Vec2(0, 15), {12, false, grey, 0, Align::center});
      continue;
    }
    Polyline circle = ring(place, 11);
    circle.push_back(circle.front());
    ink.line(circle, black, 2);
    const TextStyle style{16, true};
    const bool fits = place.x + 18 + textSize(note.text, style).x < width() - right;
    TextStyle aligned = style;
    if (!fits) aligned.align = Align::right;
    ink.text(note.text, {place.x + (fits ? 18 : -18), place.y + 16}, aligned);
  }
  ink.text(chart_.footer, {edge, 24}, fitting(chart_.footer, {12, false, grey}, width() - 2 * edge));
}

}  // namespace goniolux::plot
