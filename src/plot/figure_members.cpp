#include "plot/figure_members.h"

#include <fmt/format.h>

#include <cmath>

namespace goniolux::plot {

using core::Value;

void badFigure(const Value& where, const std::string& what) {
  throw core::InputError(where.position(), "bad-figure", what + "; figures are written by goniolux itself");
}

const Value& figureMember(const Value& object, const char* key, Value::Kind kind) {
  const Value* value = object.find(key);
  if (!value || value->kind() != kind)
    badFigure(value ? *value : object, fmt::format("\"{}\" is missing or of the wrong kind", key));
  return *value;
}

std::string figureText(const Value& object, const char* key) {
  return figureMember(object, key, Value::Kind::string).string();
}

std::vector<std::string> figureTexts(const Value& object, const char* key) {
  std::vector<std::string> texts;
  for (const Value& text : figureMember(object, key, Value::Kind::array).array()) {
    if (!text.isString()) badFigure(text, fmt::format("\"{}\" must hold texts", key));
    texts.push_back(text.string());
  }
  return texts;
}

std::vector<double> figureNumbers(const Value& object, const char* key) {
  std::vector<double> numbers;
  for (const Value& number : figureMember(object, key, Value::Kind::array).array()) {
    if (!number.isNumber() || !std::isfinite(number.number()))
      badFigure(number, fmt::format("\"{}\" must hold numbers", key));
    numbers.push_back(number.number());
  }
  return numbers;
}

Value figureHead(const char* kind, const std::string& title, const std::string& subtitle,
                 const std::vector<std::string>& facts, const std::string& footer) {
  Value json;
  json.set("format", "goniolux-figure");
  json.set("version", 1);
  json.set("kind", kind);
  json.set("title", title);
  json.set("subtitle", subtitle);
  json.set("facts", Value::arrayOf(facts));
  json.set("footer", footer);
  return json;
}

}  // namespace goniolux::plot
