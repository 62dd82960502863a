#include "plot/vtk/polar_painter.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "plot/label_placement.h"
#include "plot/levels.h"
#include "plot/number_text.h"

namespace goniolux::plot {
namespace {

using core::Vec2;
using Align = TextStyle::Align;

constexpr Rgb ringGrey{0xc4, 0xc4, 0xc4};
constexpr Rgb curveColours[] = {{0x1b, 0x4f, 0x9c},
                                {0xc2, 0x55, 0x0a}};  // told apart also without colour: the second is dashed
constexpr double top = 165, bottom = 130, left = 40;

Polyline arc(const Vec2& center, double radius, double fromDegrees, double toDegrees) {
  Polyline points;
  for (double d = fromDegrees; d <= toDegrees + 1e-9; d += 2) {
    points.push_back(center + radius * Vec2(std::sin(d * core::degree), -std::cos(d * core::degree)));
  }
  return points;
}

std::vector<Polyline> dashed(const Polyline& line, double on, double off) {
  std::vector<LineLabel> gaps;
  for (double s = on; s < lengthOf(line); s += on + off) gaps.push_back({{}, s, s + off});
  return withGaps(line, gaps);
}

}  // namespace

PolarPainter::PolarPainter(const PolarDiagram& diagram) : diagram_(diagram) {
  double highest = 0, upwards = 0;
  for (const PolarCurve& curve : diagram.curves) {
    for (const auto& [angle, value] : curve.points) {
      highest = std::max(highest, value);
      if (std::abs(angle) > 92) upwards = std::max(upwards, value);
    }
  }
  if (!(highest > 0)) highest = 1;
  const std::vector<double> ticks = axisTicks(0, highest, 4);
  const double step = ticks[1] - ticks[0];
  for (double ring = step; rings_.empty() || rings_.back() < highest * (1 - 1e-9); ring += step) rings_.push_back(ring);
  if (upwards < 0.02 * highest) upTo_ = 105;
  const double above = upTo_ > 150 ? radius_ : -radius_ * std::cos(upTo_ * core::degree);
  height_ = static_cast<int>(std::lround(top + above + radius_ + bottom + 30));
  center_ = {width() / 2.0, height_ - top - above - 20};
}

Vec2 PolarPainter::at(double degrees, double intensity) const {
  const double r = radius_ * intensity / rings_.back();
  return center_ + r * Vec2(std::sin(degrees * core::degree), -std::cos(degrees * core::degree));
}

void PolarPainter::paintRings(Ink& ink) const {
  for (const double ring : rings_) ink.line(arc(center_, radius_ * ring / rings_.back(), -upTo_, upTo_), ringGrey, 1);
  const int last = upTo_ > 150 ? 180 : 90;
  for (int gamma = 0; gamma <= last; gamma += 15) {
    for (const int side : {-1, 1}) {
      if (side < 0 && (gamma == 0 || gamma == 180)) continue;
      const bool main = gamma % 30 == 0;
      ink.line({center_, at(side * gamma, rings_.back())}, ringGrey, main ? 1.2 : 0.6);
      if (!main) continue;
      const Vec2 outside =
          center_ + (radius_ + 24) * Vec2(std::sin(side * gamma * core::degree), -std::cos(gamma * core::degree));
      ink.text(fmt::format("{}°", gamma), outside, {15, false, grey, 0, Align::center});
    }
  }
}

void PolarPainter::paint(Ink& ink) const {
  const double high = height_;
  ink.text(diagram_.title, {left, high - 44}, fitting(diagram_.title, {28, true}, width() - 2 * left));
  ink.text(diagram_.subtitle, {left, high - 82}, fitting(diagram_.subtitle, {18, false, grey}, width() - 2 * left));
  std::string facts;
  for (const std::string& fact : diagram_.facts) facts += (facts.empty() ? "" : "     ") + fact;
  ink.text(facts, {left, high - 116}, fitting(facts, {17}, width() - 2 * left));

  paintRings(ink);
  // Ring values along the horizontal, where luminaires give the least.
  for (const double ring : rings_) {
    const TextStyle style{15, false, black, 0, Align::center};
    const std::string text = levelText(ring);
    const Vec2 place = at(90, ring) + Vec2(0, -14), half = textSize(text, style) / 2.0 + 3.0;
    ink.rectangle(place - half, place + half, white, 220);
    ink.text(text, place, style);
  }
  // The dashed one on top: where both are one, it shows both.
  for (std::size_t k = 0; k < diagram_.curves.size(); ++k) {
    Polyline line;
    for (const auto& [angle, value] : diagram_.curves[k].points) {
      if (std::abs(angle) <= upTo_) line.push_back(at(angle, value));
    }
    for (const Polyline& part : k == 0 ? std::vector<Polyline>{line} : dashed(line, 12, 7))
      ink.line(part, curveColours[k], 2.6);
  }
  double x = left;
  for (std::size_t k = 0; k < diagram_.curves.size(); ++k) {
    const Polyline sample{{x, 70}, {x + 46, 70}};
    for (const Polyline& part : k == 0 ? std::vector<Polyline>{sample} : dashed(sample, 12, 7))
      ink.line(part, curveColours[k], 2.6);
    ink.text(diagram_.curves[k].name, {x + 58, 70}, {16});
    x += 58 + textSize(diagram_.curves[k].name, {16}).x + 50;
  }
  ink.text("values in " + diagram_.unit, {width() - left, 70}, {16, false, grey, 0, Align::right});
  ink.text(diagram_.footer, {left, 26}, fitting(diagram_.footer, {12, false, grey}, width() - 2 * left));
}

}  // namespace goniolux::plot
