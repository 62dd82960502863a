#include "report/drawings.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/markup.h"
#include "core/vector.h"

namespace goniolux::report {
namespace {

using core::escapedMarkup;
using core::Vec2;

constexpr const char* amber = "#d9921a";
constexpr const char* petrol = "#0f5c73";
constexpr const char* font = "font-family=\"Lato, 'DejaVu Sans', sans-serif\"";

struct Box {
  Vec2 low{1e300}, high{-1e300};
  void include(const Vec2& p) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  [[nodiscard]] bool isEmpty() const { return low.x > high.x; }
};

/// The largest of 1, 2, 5 times a power of ten that is not above `limit`.
double roundBelow(double limit) {
  const double power = std::pow(10.0, std::floor(std::log10(limit)));
  for (const double step : {5.0, 2.0, 1.0})
    if (step * power <= limit * (1 + 1e-9)) return step * power;
  return power;
}

class PlanDrawing {
 public:
  PlanDrawing(const Plan& plan, const Words& words) : plan_(plan), words_(words) {
    for (const auto* lines : {&plan.roomLines, &plan.objectLines})
      for (const plot::Polyline& line : *lines)
        for (const Vec2& p : line) box_.include(p);
    for (const Plan::Symbol& symbol : plan.luminaires) box_.include(symbol.position);
  }

  std::string draw() {
    if (box_.isEmpty()) return "";
    const Vec2 size = glm::max(box_.high - box_.low, Vec2(0.1));
    constexpr double wide = 680, high = 700;
    scale_ = std::min(wide / size.x, high / size.y);
    const double width = size.x * scale_ + 2 * rim, height = size.y * scale_ + 2 * rim + 34;
    std::string svg = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.1f} {1:.1f}\" width=\"{0:.0f}\" "
        "height=\"{1:.0f}\" {2}>",
        width, height, font);
    for (const plot::Polyline& line : plan_.objectLines) svg += path(line, "none", "#b4bcc3", 0.7);
    for (const plot::Polyline& line : plan_.roomLines) svg += path(line, "none", "#1d2329", 2.2);
    for (const Plan::Area& area : plan_.grids) svg += areaOf(area);
    for (const Plan::Symbol& symbol : plan_.luminaires) svg += symbolOf(symbol);
    return svg + scaleBar(height) + "</svg>";
  }

 private:
  static constexpr double rim = 14;

  [[nodiscard]] Vec2 at(const Vec2& p) const {
    return {rim + (p.x - box_.low.x) * scale_, rim + (box_.high.y - p.y) * scale_};
  }
  [[nodiscard]] std::string path(const plot::Polyline& line, const char* fill, const char* stroke, double width,
                                 const char* more = "") const {
    std::string points;
    for (const Vec2& p : line) points += fmt::format("{:.1f},{:.1f} ", at(p).x, at(p).y);
    return fmt::format(
        "<polyline points=\"{}\" fill=\"{}\" stroke=\"{}\" stroke-width=\"{}\" stroke-linejoin=\"round\" {}/>", points,
        fill, stroke, width, more);
  }
  [[nodiscard]] std::string areaOf(const Plan::Area& area) const {
    if (area.corners.empty()) return "";
    plot::Polyline closed = area.corners;
    closed.push_back(closed.front());
    Vec2 corner = at(closed.front());
    for (const Vec2& p : closed) corner = {std::min(corner.x, at(p).x), std::max(corner.y, at(p).y)};
    return path(closed, "none", petrol, 0.9, "stroke-dasharray=\"5 3\"") +
           fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"9\" fill=\"{}\">{}</text>", corner.x + 5,
                       corner.y - 5, petrol, escapedMarkup(area.name));
  }
  [[nodiscard]] std::string symbolOf(const Plan::Symbol& symbol) const {
    plot::Polyline shape = symbol.footprint;
    const Vec2 centre = at(symbol.position);
    std::string svg;
    if (shape.size() > 2) {
      shape.push_back(shape.front());
      svg = path(shape, "#fbe7bf", amber, 1.3, "fill-opacity=\"0.85\"");
    } else if (shape.size() == 2) {
      svg = path(shape, "none", amber, 3.5);
    }
    constexpr double radius = 8;
    return svg +
           fmt::format(
               "<circle cx=\"{0:.1f}\" cy=\"{1:.1f}\" r=\"{2}\" fill=\"#ffffff\" stroke=\"{3}\" stroke-width=\"1.2\"/>"
               "<text x=\"{0:.1f}\" y=\"{4:.1f}\" font-size=\"10\" font-weight=\"bold\" text-anchor=\"middle\" "
               "fill=\"#7a4e06\">{5}</text>",
               centre.x, centre.y, radius, amber, centre.y + 3.6, escapedMarkup(symbol.letter));
  }
  [[nodiscard]] std::string scaleBar(double height) const {
    const double unit = scale_ / words_.factor("m");  // pixels per metre or foot
    const double length = roundBelow(140 / unit);
    const double y = height - 16;
    std::string svg;
    for (int i = 0; i < 4; ++i)
      svg += fmt::format(
          "<rect x=\"{:.1f}\" y=\"{}\" width=\"{:.1f}\" height=\"4\" fill=\"{}\" stroke=\"#1d2329\" "
          "stroke-width=\"0.6\"/>",
          rim + i * length * unit / 4, y, length * unit / 4, i % 2 == 0 ? "#1d2329" : "#ffffff");
    return svg + fmt::format("<text x=\"{:.1f}\" y=\"{}\" font-size=\"10\" fill=\"#1d2329\">{} {}</text>",
                             rim + length * unit + 7, y + 5, words_.number(length, length < 1 ? 1 : 0),
                             words_.unitName("m"));
  }

  const Plan& plan_;
  const Words& words_;
  Box box_;
  double scale_ = 1;
};

}  // namespace

std::string planSvg(const Plan& plan, const Words& words) {
  return PlanDrawing(plan, words).draw();
}

std::string polarSvg(const plot::PolarDiagram& diagram, const Words& words) {
  double highest = 0, upward = 0;
  for (const plot::PolarCurve& curve : diagram.curves) {
    for (const auto& [angle, intensity] : curve.points) {
      highest = std::max(highest, intensity);
      if (std::abs(angle) > 90) upward = std::max(upward, intensity);
    }
  }
  if (!(highest > 0)) return "";
  // Three to five rings.
  double step = roundBelow(highest / 2.5);
  while (highest / step > 5) step *= 2;
  const int rings = static_cast<int>(std::ceil(highest / step - 1e-9));
  constexpr double radius = 150, middle = 178;
  const bool both = upward > 0.02 * highest;
  const bool upper = both;
  const double top = upper ? radius + 44 : 40;  // the legend stands above
  const double height = top + radius + 34;
  const double perCandela = radius / (rings * step);
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 356 {0:.0f}\" width=\"356\" height=\"{0:.0f}\" {1}>",
      height, font);
  const auto at = [&](double angle, double intensity) {
    return Vec2{middle + perCandela * intensity * std::sin(angle * core::degree),
                top + perCandela * intensity * std::cos(angle * core::degree)};
  };
  const double span = upper ? 180 : 90;
  for (int ring = 1; ring <= rings; ++ring) {
    std::string points;
    for (double a = -span; a <= span; a += 3)
      points += fmt::format("{:.1f},{:.1f} ", at(a, ring * step).x, at(a, ring * step).y);
    svg += fmt::format("<polyline points=\"{}\" fill=\"none\" stroke=\"#cfd6db\" stroke-width=\"0.8\"/>", points);
  }
  for (int angle = -static_cast<int>(span); angle <= static_cast<int>(span); angle += 30) {
    const Vec2 end = at(angle, rings * step), mark = at(angle, rings * step + 13 / perCandela);
    svg +=
        fmt::format("<line x1=\"{}\" y1=\"{}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"#cfd6db\" stroke-width=\"0.8\"/>",
                    middle, top, end.x, end.y);
    if (angle != -180)
      svg += fmt::format(
          "<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"9.5\" fill=\"#5a6670\" text-anchor=\"middle\">{}°</text>",
          mark.x, mark.y + 3, std::abs(angle));
  }
  const std::array<const char*, 2> strokes{amber, petrol};
  for (std::size_t c = 0; c < diagram.curves.size(); ++c) {
    std::string points;
    for (const auto& [angle, intensity] : diagram.curves[c].points) {
      if (!upper && std::abs(angle) > 90) continue;
      const Vec2 p = at(angle, intensity);
      points += fmt::format("{:.1f},{:.1f} ", p.x, p.y);
    }
    svg += fmt::format(
        "<polyline points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.9\" stroke-linejoin=\"round\"{}/>",
        points, strokes[c % 2], c == 0 ? "" : " stroke-dasharray=\"6 3\"");
  }
  for (int ring = 1; ring <= rings; ++ring) {
    const Vec2 p = at(0, ring * step);
    svg += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"9.5\" fill=\"#1d2329\">{}</text>", p.x + 4, p.y - 3,
                       words.number(ring * step, step < 1 ? 1 : 0));
  }
  double x = 8;
  for (std::size_t c = 0; c < diagram.curves.size(); ++c) {
    svg += fmt::format(
        "<line x1=\"{0}\" y1=\"12\" x2=\"{1}\" y2=\"12\" stroke=\"{2}\" stroke-width=\"2\"{3}/>"
        "<text x=\"{4}\" y=\"15.5\" font-size=\"9.5\" fill=\"#1d2329\">{5}</text>",
        x, x + 20, strokes[c % 2], c == 0 ? "" : " stroke-dasharray=\"6 3\"", x + 25,
        escapedMarkup(words(diagram.curves[c].name)));
    x += 150;
  }
  return svg + fmt::format(
                   "<text x=\"348\" y=\"15.5\" font-size=\"9.5\" fill=\"#5a6670\" text-anchor=\"end\">{}</text></svg>",
                   escapedMarkup(diagram.unit));
}

}  // namespace goniolux::report
