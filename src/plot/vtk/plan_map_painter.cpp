#include "plot/vtk/plan_map_painter.h"

#include <algorithm>
#include <cmath>

#include "plot/number_text.h"

namespace goniolux::plot {
namespace {

using core::Vec2;

constexpr int labelSize = 16, valueSize = 12;

Polyline onPage(const Polyline& line, const MapLayout& layout) {
  Polyline page;
  page.reserve(line.size());
  for (const Vec2& point : line) page.push_back(layout.toPage(point));
  return page;
}

/// Ink that can be read on a colour.
Rgb inkOn(const Rgb& ground) {
  return lightness(ground) < 55 ? white : black;
}

void linesWithCasing(Ink& ink, const std::vector<Polyline>& lines, const MapLayout& layout, const Rgb& colour,
                     double width) {
  std::vector<Polyline> parts;
  for (const Polyline& line : lines) {
    for (Polyline& part : clipped(onPage(line, layout), layout.frame)) parts.push_back(std::move(part));
  }
  for (const Polyline& part : parts) ink.line(part, white, width + 2.4, 190);
  for (const Polyline& part : parts) ink.line(part, colour, width);
}

std::size_t indexOfExtreme(const PlanMap& map, bool highest) {
  std::size_t best = map.values.size();
  for (std::size_t i = 0; i < map.values.size(); ++i) {
    if (std::isnan(map.values[i])) continue;
    if (best == map.values.size() || (highest ? map.values[i] > map.values[best] : map.values[i] < map.values[best]))
      best = i;
  }
  return best;
}

}  // namespace

PlanMapPainter::PlanMapPainter(const PlanMap& map, const MapLayout& layout) : map_(map), layout_(layout), scale_(map) {
  if (!map.grid) return;
  fine_.emplace(map);
  picture_ = fine_->picture(layout, scale_, 2);
  for (const FineMap::Isoline& isoline : fine_->isolines(map.levels)) {
    for (Polyline& part : clipped(onPage(isoline.points, layout), layout.frame)) {
      isolines_.push_back({isoline.level, std::move(part)});
    }
  }
}

void PlanMapPainter::paint(Ink& ink) const {
  LabelPlacement labels(layout_.frame.low, layout_.frame.high);
  for (const Polyline& line : map_.roomLines) labels.avoidLine(onPage(line, layout_));
  for (const Polyline& line : map_.objectLines) labels.avoidLine(onPage(line, layout_), true);
  for (const MapLuminaire& luminaire : map_.luminaires) {
    for (const Polyline& stroke :
         luminaireStrokes(layout_.toPage(luminaire.position), onPage(luminaire.footprint, layout_))) {
      labels.avoidLine(stroke, true);
    }
  }
  if (fine_) paintColours(ink);
  paintObjects(ink);
  paintLuminaires(ink);
  paintExtremes(ink, labels);
  if (fine_) {
    paintIsolines(ink, labels);
    paintValues(ink, labels);
  } else {
    paintDots(ink, labels);
  }
  paintAxes(ink, map_, layout_);
  paintTitles(ink, map_, layout_);
  paintLegend(ink, map_, layout_, scale_);
}

void PlanMapPainter::paintColours(Ink& ink) const {
  ink.image(layout_.frame.low, layout_.frame.high, picture_);
}

void PlanMapPainter::paintIsolines(Ink& ink, LabelPlacement& labels) const {
  const TextStyle style{labelSize, false, black, 0, TextStyle::Align::center};
  for (std::size_t i = 0; i < isolines_.size(); ++i) labels.avoidLine(isolines_[i].points, false, i + 1);
  for (std::size_t i = 0; i < isolines_.size(); ++i) {
    const FineMap::Isoline& isoline = isolines_[i];
    const std::string text = levelText(isoline.level);
    const Vec2 size = textSize(text, style);
    const std::vector<LineLabel> placed = labels.alongLine(isoline.points, size.x + 10, size.y + 6, 420, i + 1);
    const Rgb colour = inkOn(scale_.colour(isoline.level));
    for (const Polyline& part : withGaps(isoline.points, placed)) ink.line(part, colour, 1.3);
    for (const LineLabel& label : placed) {
      TextStyle turned = style;
      turned.angle = label.box.angle;
      turned.colour = colour;
      ink.text(text, label.box.center, turned);
    }
  }
}

void PlanMapPainter::paintObjects(Ink& ink) const {
  linesWithCasing(ink, map_.objectLines, layout_, {0x30, 0x30, 0x30}, 2);
  linesWithCasing(ink, map_.roomLines, layout_, {0x22, 0x22, 0x22}, 3);
}

void PlanMapPainter::paintLuminaires(Ink& ink) const {
  for (const MapLuminaire& luminaire : map_.luminaires) {
    if (!layout_.shown.contains(luminaire.position)) continue;
    paintLuminaire(ink, layout_.toPage(luminaire.position), onPage(luminaire.footprint, layout_));
  }
}

void PlanMapPainter::paintExtremes(Ink& ink, LabelPlacement& labels) const {
  if (!showsExtremes(map_)) return;
  const std::size_t low = indexOfExtreme(map_, false), high = indexOfExtreme(map_, true);
  if (low == map_.values.size() || low == high) return;
  for (const std::size_t i : {low, high}) {
    const Vec2 at = layout_.toPage(map_.points[i]);
    paintExtreme(ink, at, i == high);
    labels.occupy({at, 22, 22, 0});
  }
}

void PlanMapPainter::paintDots(Ink& ink, LabelPlacement& labels) const {
  const TextStyle style{valueSize + 1, false, black, 0, TextStyle::Align::center};
  for (std::size_t i = 0; i < map_.points.size(); ++i) {
    if (!layout_.shown.contains(map_.points[i])) continue;
    const Vec2 at = layout_.toPage(map_.points[i]);
    const auto circle = [&](double radius) {
      Polyline corners;
      for (int k = 0; k < 24; ++k) {
        corners.push_back(at + radius * Vec2(std::cos(core::pi * k / 12), std::sin(core::pi * k / 12)));
      }
      return corners;
    };
    const bool excluded = std::isnan(map_.values[i]);
    ink.area(circle(8.5), black);
    ink.area(circle(7.5), excluded ? Rgb{0xec, 0xec, 0xec} : scale_.colour(map_.values[i]));
    labels.occupy({at, 18, 18, 0});
  }
  for (std::size_t i = 0; i < map_.points.size(); ++i) {
    if (std::isnan(map_.values[i]) || !layout_.shown.contains(map_.points[i])) continue;
    const std::string text = pointText(map_.values[i]);
    const Vec2 at = layout_.toPage(map_.points[i]), size = textSize(text, style);
    for (const Vec2& shift : {Vec2(0, 20), Vec2(0, -20), Vec2(14 + size.x / 2, 0), Vec2(-14 - size.x / 2, 0)}) {
      const LabelBox box{at + shift, size.x + 4, size.y + 4, 0};
      if (!labels.isFree(box)) continue;
      labels.occupy(box);
      ink.text(text, at + shift, style);
      break;
    }
  }
}

void PlanMapPainter::paintValues(Ink& ink, LabelPlacement& labels) const {
  // Every k-th point along each edge, so that neighbours stand at least 100 pixels apart.
  const MapGrid& grid = *map_.grid;
  const auto stepAlong = [&](const Vec2& edge, int count) {
    return std::max(1, static_cast<int>(std::ceil(100 * count / (glm::length(edge) * layout_.scale))));
  };
  const int stepU = stepAlong(grid.u, grid.nu), stepV = stepAlong(grid.v, grid.nv);
  const TextStyle style{valueSize, false, black, 0, TextStyle::Align::center};
  for (int j = (grid.nv - 1) % stepV / 2; j < grid.nv; j += stepV) {
    for (int i = (grid.nu - 1) % stepU / 2; i < grid.nu; i += stepU) {
      const auto index = static_cast<std::size_t>(j) * static_cast<std::size_t>(grid.nu) + static_cast<std::size_t>(i);
      const double value = map_.values[index];
      if (std::isnan(value) || !layout_.shown.contains(map_.points[index])) continue;
      const Vec2 at = layout_.toPage(map_.points[index]);
      const std::string text = pointText(value);
      const Vec2 size = textSize(text, style);
      const double up = size.y / 2 + 6, aside = size.x / 2 + 7;
      for (const Vec2& shift : {Vec2(0, up), Vec2(0, -up), Vec2(aside, 0), Vec2(-aside, 0)}) {
        const LabelBox box{at + shift, size.x + 4, size.y + 4, 0};
        if (!labels.isFree(box) || !labels.isFree({at, 5, 5, 0})) continue;
        labels.occupy(box);
        labels.occupy({at, 5, 5, 0});
        TextStyle readable = style;
        readable.colour = inkOn(scale_.colour(value));
        ink.rectangle(at - Vec2(1.5), at + Vec2(1.5), readable.colour);
        ink.text(text, at + shift, readable);
        break;
      }
    }
  }
}

std::vector<Polyline> luminaireStrokes(const Vec2& position, const Polyline& footprint) {
  constexpr double least = 7;  // a smaller opening is drawn as a symbol of this half size
  double reach = 0;
  for (const Vec2& corner : footprint) reach = std::max(reach, glm::distance(corner, position));
  Polyline outline = footprint;
  if (reach < least) {
    outline.clear();
    for (int k = 0; k < 24; ++k) {
      outline.push_back(position + least * Vec2(std::cos(core::pi * k / 12), std::sin(core::pi * k / 12)));
    }
  }
  const std::size_t corners = outline.size();
  std::vector<Polyline> strokes;
  if (corners > 2) outline.push_back(outline.front());
  strokes.push_back(outline);
  const bool slender =
      corners == 4 && std::min(glm::distance(outline[0], outline[1]), glm::distance(outline[1], outline[2])) < 8;
  if (corners >= 4 && !slender) {
    // A cross from corner to corner; of a circle, along its diagonals.
    const std::size_t quarter = corners / 4, start = corners == 4 ? 0 : corners / 8;
    strokes.push_back({outline[start], outline[(start + 2 * quarter) % corners]});
    strokes.push_back({outline[(start + quarter) % corners], outline[(start + 3 * quarter) % corners]});
  }
  return strokes;
}

void paintLuminaire(Ink& ink, const Vec2& position, const Polyline& footprint) {
  const std::vector<Polyline> strokes = luminaireStrokes(position, footprint);
  ink.area(strokes.front(), white, 120);
  for (const Polyline& stroke : strokes) ink.line(stroke, white, 4, 180);
  for (const Polyline& stroke : strokes) ink.line(stroke, black, 1.5);
}

void paintExtreme(Ink& ink, const Vec2& at, bool highest) {
  const auto triangle = [&](double r) {
    const double up = highest ? 1 : -1;
    return Polyline{at + Vec2(-0.87 * r, -0.5 * r * up), at + Vec2(0.87 * r, -0.5 * r * up), at + Vec2(0, r * up)};
  };
  ink.area(triangle(10), white);
  ink.area(triangle(6.5), black);
}

}  // namespace goniolux::plot
