// What stands around a plan map: titles, axes, legend, key to the symbols, footer.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "plot/levels.h"
#include "plot/number_text.h"
#include "plot/vtk/plan_map_painter.h"

namespace goniolux::plot {
namespace {

using core::Vec2;
using Align = TextStyle::Align;

bool anyExcluded(const PlanMap& map) {
  return std::any_of(map.values.begin(), map.values.end(), [](double value) { return std::isnan(value); });
}

}  // namespace

void paintTitles(Ink& ink, const PlanMap& map, const MapLayout& layout) {
  const double left = 40, width = layout.width - 2 * left, top = layout.height;
  ink.text(map.title, {left, top - 44}, fitting(map.title, {30, true}, width));
  ink.text(map.subtitle, {left, top - 84}, fitting(map.subtitle, {20, false, grey}, width));
  std::string facts;
  for (const std::string& fact : map.facts) facts += (facts.empty() ? "" : "     ") + fact;
  ink.text(facts, {left, top - 122}, fitting(facts, {19}, width));
  ink.text(map.footer, {left, 26}, fitting(map.footer, {12, false, grey}, width));
}

void paintAxes(Ink& ink, const PlanMap& map, const MapLayout& layout) {
  const Rectangle& frame = layout.frame;
  ink.line({frame.low, {frame.high.x, frame.low.y}, frame.high, {frame.low.x, frame.high.y}, frame.low}, grey, 1);
  const TextStyle tick{15, false, black, 0, Align::center};
  const auto ticks = [](double low, double high, double pixels) {
    return axisTicks(low, high, std::clamp(static_cast<int>(pixels / 110), 2, 12));
  };
  const Vec2 size = frame.size();
  double widest = 0;
  for (const double x : ticks(layout.shown.low.x, layout.shown.high.x, size.x)) {
    const double at = layout.toPage({x, layout.shown.low.y}).x;
    ink.line({{at, frame.low.y}, {at, frame.low.y - 7}}, grey, 1);
    ink.text(levelText(x), {at, frame.low.y - 20}, tick);
  }
  TextStyle beside = tick;
  beside.align = Align::right;
  for (const double y : ticks(layout.shown.low.y, layout.shown.high.y, size.y)) {
    const double at = layout.toPage({layout.shown.low.x, y}).y;
    ink.line({{frame.low.x, at}, {frame.low.x - 7, at}}, grey, 1);
    ink.text(levelText(y), {frame.low.x - 12, at}, beside);
    widest = std::max(widest, textSize(levelText(y), beside).x);
  }
  TextStyle title{16, false, black, 0, Align::center};
  ink.text(map.xTitle, {(frame.low.x + frame.high.x) / 2, frame.low.y - 48}, title);
  title.angle = core::pi / 2;
  ink.text(map.yTitle, {frame.low.x - 32 - widest, (frame.low.y + frame.high.y) / 2}, title);
}

void paintLegend(Ink& ink, const PlanMap& map, const MapLayout& layout, const ColourScale& scale) {
  const Rectangle& bar = layout.legend;
  const double height = bar.size().y;
  ink.text(map.legendTitle, {bar.low.x, layout.frame.high.y - 8}, fitting(map.legendTitle, {17, true}, 190));
  ink.text(map.word("in") + " " + map.unit, {bar.low.x, layout.frame.high.y - 32}, {15, false, grey});

  const std::vector<double>& edges = scale.edges();
  const auto fields = static_cast<int>(edges.size()) - 1;
  const int slices = map.banded ? fields : std::max(fields, 200);
  for (int k = 0; k < slices; ++k) {
    const double from = static_cast<double>(k) / slices, to = static_cast<double>(k + 1) / slices;
    ink.rectangle({bar.low.x, bar.low.y + from * height}, {bar.high.x, bar.low.y + to * height},
                  scale.atFraction((from + to) / 2));
  }
  ink.line({bar.low, {bar.high.x, bar.low.y}, bar.high, {bar.low.x, bar.high.y}, bar.low}, black, 1);

  const int every = std::max(1, static_cast<int>(std::ceil(22.0 * fields / height)));
  for (int k = 0; k <= fields; ++k) {
    const double y = bar.low.y + height * k / fields;
    const bool end = k == 0 || k == fields;
    if (!end) ink.line({{bar.low.x, y}, {bar.high.x, y}}, black, 1);
    if (!end && k % every != 0) continue;
    ink.line({{bar.high.x, y}, {bar.high.x + 6, y}}, black, 1);
    const double value = edges[static_cast<std::size_t>(k)];
    const std::string text = end ? pointText(value) : levelText(value);
    ink.text(text, {bar.high.x + 12, y}, {15, false, end ? grey : black});
  }

  // Key to the symbols, under the bar.
  double y = bar.low.y - 36;
  const double middle = bar.low.x + 12, words = bar.low.x + 34;
  const auto row = [&](const char* text) {
    ink.text(map.word(text), {words, y}, {14});
    y -= 25;
  };
  if (!map.luminaires.empty()) {
    paintLuminaire(ink, {middle, y},
                   {{middle - 9, y - 9}, {middle + 9, y - 9}, {middle + 9, y + 9}, {middle - 9, y + 9}});
    row("luminaire");
  }
  if (showsExtremes(map)) {
    paintExtreme(ink, {middle, y - 1}, true);
    row("highest value");
    paintExtreme(ink, {middle, y + 1}, false);
    row("lowest value");
  }
  if (anyExcluded(map)) {
    ink.rectangle({middle - 10, y - 8}, {middle + 10, y + 8}, {0xec, 0xec, 0xec});
    for (int k = -1; k < 3; ++k) {
      const double x = middle - 10 + 7.0 * k;
      for (const Polyline& part :
           clipped({{x, y + 8}, {x + 16, y - 8}}, {{middle - 10, y - 8}, {middle + 10, y + 8}})) {
        ink.line(part, {0x9a, 0x9a, 0x9a}, 1.5);
      }
    }
    row("not counted");
  }
}

}  // namespace goniolux::plot
