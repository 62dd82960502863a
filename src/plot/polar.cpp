#include "plot/polar.h"

#include <fmt/format.h>

#include <cmath>

namespace goniolux::plot {
namespace {

using core::Value;

[[noreturn]] void bad(const Value& where, const std::string& what) {
  throw core::InputError(where.position(), "bad-figure", what + "; figures are written by goniolux itself");
}

const Value& member(const Value& object, const char* key, Value::Kind kind) {
  const Value* value = object.find(key);
  if (!value || value->kind() != kind)
    bad(value ? *value : object, fmt::format("\"{}\" is missing or of the wrong kind", key));
  return *value;
}

std::string text(const Value& object, const char* key) {
  return member(object, key, Value::Kind::string).string();
}

PolarCurve curveFromJson(const Value& json) {
  PolarCurve curve;
  curve.name = text(json, "name");
  const Value& degrees = member(json, "degrees", Value::Kind::array);
  const Value& values = member(json, "values", Value::Kind::array);
  if (degrees.array().size() != values.array().size() || degrees.array().size() < 2) {
    bad(values, "there must be one value per angle, two at least");
  }
  for (std::size_t i = 0; i < values.array().size(); ++i) {
    const Value &angle = degrees.array()[i], &value = values.array()[i];
    if (!angle.isNumber() || std::abs(angle.number()) > 180 || (i > 0 && angle.number() <= curve.points.back().first)) {
      bad(angle, "angles must ascend from -180 to 180");
    }
    if (!value.isNumber() || value.number() < 0) bad(value, "an intensity must be a number not below 0");
    curve.points.emplace_back(angle.number(), value.number());
  }
  return curve;
}

}  // namespace

core::Value toJson(const PolarDiagram& diagram) {
  Value json;
  json.set("format", "goniolux-figure");
  json.set("version", 1);
  json.set("kind", "polar-diagram");
  json.set("title", diagram.title);
  json.set("subtitle", diagram.subtitle);
  json.set("facts", Value::arrayOf(diagram.facts));
  json.set("footer", diagram.footer);
  json.set("unit", diagram.unit);
  Value::Array curves;
  for (const PolarCurve& curve : diagram.curves) {
    Value::Array degrees, values;
    for (const auto& [angle, value] : curve.points) {
      degrees.emplace_back(angle);
      values.emplace_back(value);
    }
    Value entry;
    entry.set("name", curve.name);
    entry.set("degrees", std::move(degrees));
    entry.set("values", std::move(values));
    curves.push_back(std::move(entry));
  }
  json.set("curves", std::move(curves));
  return json;
}

PolarDiagram polarDiagramFromJson(const core::Value& document) {
  PolarDiagram diagram;
  diagram.title = text(document, "title");
  diagram.subtitle = text(document, "subtitle");
  diagram.footer = text(document, "footer");
  diagram.unit = text(document, "unit");
  for (const Value& fact : member(document, "facts", Value::Kind::array).array()) {
    if (!fact.isString()) bad(fact, "\"facts\" must hold texts");
    diagram.facts.push_back(fact.string());
  }
  const Value& curves = member(document, "curves", Value::Kind::array);
  for (const Value& curve : curves.array()) diagram.curves.push_back(curveFromJson(curve));
  if (diagram.curves.empty() || diagram.curves.size() > 2) bad(curves, "there must be one or two curves");
  return diagram;
}

}  // namespace goniolux::plot
