#include "plot/line_chart.h"

#include <cmath>

#include "plot/figure_members.h"

namespace goniolux::plot {
namespace {

using core::Value;

Value axisJson(const ChartAxis& axis) {
  Value json;
  json.set("title", axis.title);
  json.set("logarithmic", axis.logarithmic);
  return json;
}

ChartAxis axisFromJson(const Value& json) {
  return {figureText(json, "title"), figureMember(json, "logarithmic", Value::Kind::boolean).boolean()};
}

}  // namespace

std::vector<double> decadeTicks(double low, double high) {
  std::vector<double> ticks;
  for (double power = std::pow(10, std::floor(std::log10(low))); power <= high; power *= 10)
    for (const double factor : {1.0, 2.0, 5.0}) {
      const double tick = power * factor;
      if (tick >= low * (1 - 1e-9) && tick <= high * (1 + 1e-9)) ticks.push_back(tick);
    }
  return ticks;
}

Value toJson(const LineChart& chart) {
  Value json = figureHead("line-chart", chart.title, chart.subtitle, chart.facts, chart.footer);
  json.set("x", axisJson(chart.x));
  json.set("y", axisJson(chart.y));
  json.set("guides", Value::arrayOf(chart.guides));
  Value::Array curves;
  for (const ChartCurve& curve : chart.curves) {
    std::vector<double> xs, ys;
    for (const core::Vec2& point : curve.points) {
      xs.push_back(point.x);
      ys.push_back(point.y);
    }
    Value entry;
    entry.set("name", curve.name);
    entry.set("x", Value::arrayOf(xs));
    entry.set("y", Value::arrayOf(ys));
    entry.set("marked", curve.marked);
    curves.push_back(std::move(entry));
  }
  json.set("curves", std::move(curves));
  Value::Array notes;
  for (const ChartNote& note : chart.notes) {
    Value entry;
    entry.set("text", note.text);
    entry.set("x", note.point.x);
    entry.set("y", note.point.y);
    entry.set("ring", note.ring);
    notes.push_back(std::move(entry));
  }
  json.set("notes", std::move(notes));
  if (!chart.levels.empty()) {
    Value::Array levels;
    for (const ChartLevel& level : chart.levels) {
      Value entry;
      entry.set("text", level.text);
      entry.set("y", level.y);
      entry.set("from", level.from);
      levels.push_back(std::move(entry));
    }
    json.set("levels", std::move(levels));
  }
  if (!chart.front.empty()) {
    std::vector<double> xs, ys;
    for (const core::Vec2& point : chart.front) {
      xs.push_back(point.x);
      ys.push_back(point.y);
    }
    Value front;
    front.set("name", chart.frontName);
    front.set("x", Value::arrayOf(xs));
    front.set("y", Value::arrayOf(ys));
    json.set("front", std::move(front));
  }
  return json;
}

LineChart lineChartFromJson(const Value& document) {
  LineChart chart;
  chart.title = figureText(document, "title");
  chart.subtitle = figureText(document, "subtitle");
  chart.footer = figureText(document, "footer");
  chart.facts = figureTexts(document, "facts");
  chart.x = axisFromJson(figureMember(document, "x", Value::Kind::object));
  chart.y = axisFromJson(figureMember(document, "y", Value::Kind::object));
  chart.guides = figureNumbers(document, "guides");
  const Value& curves = figureMember(document, "curves", Value::Kind::array);
  for (const Value& curve : curves.array()) {
    const std::vector<double> xs = figureNumbers(curve, "x"), ys = figureNumbers(curve, "y");
    ChartCurve read;
    read.name = figureText(curve, "name");
    if (const Value* marked = curve.find("marked")) read.marked = marked->isBoolean() && marked->boolean();
    const std::size_t least = read.marked ? 1 : 2;
    if (xs.size() != ys.size() || xs.size() < least)
      badFigure(curve, "there must be one y per x, two at least, or one where points are marked");
    for (std::size_t i = 0; i < xs.size(); ++i) {
      if ((chart.x.logarithmic && xs[i] <= 0) || (chart.y.logarithmic && ys[i] <= 0))
        badFigure(curve, "a logarithmic axis needs values above 0");
      read.points.emplace_back(xs[i], ys[i]);
    }
    chart.curves.push_back(std::move(read));
  }
  if (chart.curves.empty() || chart.curves.size() > 6) badFigure(curves, "there must be one to six curves");
  if (const Value* notes = document.find("notes")) {
    if (!notes->isArray()) badFigure(*notes, "notes must be a list");
    for (const Value& note : notes->array()) {
      const Value* ring = note.find("ring");
      chart.notes.push_back({figureText(note, "text"),
                             {figureMember(note, "x", Value::Kind::number).number(),
                              figureMember(note, "y", Value::Kind::number).number()},
                             ring == nullptr || !ring->isBoolean() || ring->boolean()});
    }
  }
  if (const Value* levels = document.find("levels")) {
    if (!levels->isArray()) badFigure(*levels, "levels must be a list");
    for (const Value& level : levels->array()) {
      chart.levels.push_back({figureText(level, "text"), figureMember(level, "y", Value::Kind::number).number(),
                              figureMember(level, "from", Value::Kind::number).number()});
      if (chart.y.logarithmic && chart.levels.back().y <= 0)
        badFigure(level, "a logarithmic axis needs values above 0");
    }
  }
  if (const Value* front = document.find("front")) {
    const std::vector<double> xs = figureNumbers(*front, "x"), ys = figureNumbers(*front, "y");
    if (xs.size() != ys.size()) badFigure(*front, "there must be one y per x");
    for (std::size_t i = 0; i < xs.size(); ++i) {
      if ((chart.x.logarithmic && xs[i] <= 0) || (chart.y.logarithmic && ys[i] <= 0))
        badFigure(*front, "a logarithmic axis needs values above 0");
      chart.front.emplace_back(xs[i], ys[i]);
    }
    chart.frontName = figureText(*front, "name");
  }
  return chart;
}

}  // namespace goniolux::plot
