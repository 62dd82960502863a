#include "plot/figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "plot/palette.h"

namespace goniolux::plot {
namespace {

using core::Value;
using core::Vec2;

Value toJson(const Vec2& v) {
  return Value::Array{v.x, v.y};
}

Value toJson(const Polyline& line) {
  Value::Array list;
  for (const Vec2& point : line) {
    list.emplace_back(point.x);
    list.emplace_back(point.y);
  }
  return list;
}

Value toJson(const std::vector<Polyline>& lines) {
  Value::Array list;
  for (const Polyline& line : lines) list.push_back(toJson(line));
  return list;
}

[[noreturn]] void bad(const Value& where, const std::string& what) {
  throw core::InputError(where.position(), "bad-figure", what + "; figures are written by `goniolux plot`");
}

const Value& member(const Value& object, const char* key) {
  const Value* value = object.find(key);
  if (!value) bad(object, fmt::format("\"{}\" is missing", key));
  return *value;
}

std::string text(const Value& object, const char* key) {
  const Value& value = member(object, key);
  if (!value.isString()) bad(value, fmt::format("\"{}\" must be text", key));
  return value.string();
}

double number(const Value& value, const char* what) {
  if (!value.isNumber()) bad(value, fmt::format("{} must be a number", what));
  return value.number();
}

int wholeNumber(const Value& object, const char* key, int minimum, int maximum) {
  const Value& value = member(object, key);
  const double n = number(value, key);
  if (!(n >= minimum && n <= maximum) || n != std::floor(n)) {
    bad(value, fmt::format("\"{}\" must be a whole number from {} to {}", key, minimum, maximum));
  }
  return static_cast<int>(n);
}

const Value::Array& list(const Value& value, const char* what) {
  if (!value.isArray()) bad(value, fmt::format("{} must be a list", what));
  return value.array();
}

Vec2 vector2(const Value& value, const char* what) {
  const Value::Array& entries = list(value, what);
  if (entries.size() != 2) bad(value, fmt::format("{} must be two numbers", what));
  return {number(entries[0], what), number(entries[1], what)};
}

Polyline polyline(const Value& value, const char* what) {
  const Value::Array& entries = list(value, what);
  if (entries.size() % 2 != 0) bad(value, fmt::format("{} must hold pairs of numbers", what));
  Polyline line;
  for (std::size_t i = 0; i < entries.size(); i += 2)
    line.emplace_back(number(entries[i], what), number(entries[i + 1], what));
  return line;
}

std::vector<Polyline> polylines(const Value& object, const char* key) {
  std::vector<Polyline> lines;
  for (const Value& entry : list(member(object, key), key)) lines.push_back(polyline(entry, key));
  return lines;
}

void readValues(const Value& document, PlanMap& map) {
  if (const Value* json = document.find("grid"); json && !json->isNull()) {
    MapGrid grid;
    grid.origin = vector2(member(*json, "origin"), "\"origin\"");
    grid.u = vector2(member(*json, "u"), "\"u\"");
    grid.v = vector2(member(*json, "v"), "\"v\"");
    grid.nu = wholeNumber(*json, "nu", 1, 100000);
    grid.nv = wholeNumber(*json, "nv", 1, 100000);
    if (!(std::abs(grid.u.x * grid.v.y - grid.u.y * grid.v.x) > 0)) bad(*json, "the grid has no area");
    map.grid = grid;
  }
  map.points = polyline(member(document, "points"), "\"points\"");
  bool any = false;
  for (const Value& entry : list(member(document, "values"), "\"values\"")) {
    map.values.push_back(entry.isNull() ? std::numeric_limits<double>::quiet_NaN() : number(entry, "a value"));
    any = any || !entry.isNull();
  }
  if (map.values.size() != map.points.size()) bad(member(document, "values"), "there must be one value per point");
  if (!any) bad(member(document, "values"), "there is no value to draw");
  if (map.grid && static_cast<double>(map.grid->nu) * map.grid->nv != static_cast<double>(map.points.size())) {
    bad(member(document, "grid"), "\"nu\" times \"nv\" must be the number of points");
  }
  map.lowest = number(member(document, "lowest"), "\"lowest\"");
  map.highest = number(member(document, "highest"), "\"highest\"");
  if (!(map.highest > map.lowest)) bad(member(document, "highest"), "\"highest\" must be above \"lowest\"");
  for (const Value& level : list(member(document, "levels"), "\"levels\"")) {
    map.levels.push_back(number(level, "a level"));
    if (map.levels.size() > 1 && !(map.levels.back() > map.levels[map.levels.size() - 2])) {
      bad(level, "levels must be ascending");
    }
  }
}

}  // namespace

std::string figureKind(const core::Value& document) {
  if (!document.isObject()) bad(document, "a figure is an object with \"format\": \"goniolux-figure\"");
  if (text(document, "format") != "goniolux-figure") bad(member(document, "format"), "this is no figure");
  wholeNumber(document, "version", 1, 1);
  std::string kind = text(document, "kind");
  if (kind != "plan-map" && kind != "polar-diagram" && kind != "line-chart" && kind != "photometric-solid") {
    bad(member(document, "kind"),
        "there is no such kind of figure; there are plan-map, polar-diagram, line-chart and photometric-solid");
  }
  return kind;
}

core::Value toJson(const PlanMap& map) {
  Value json;
  json.set("format", "goniolux-figure");
  json.set("version", 1);
  json.set("kind", "plan-map");
  json.set("title", map.title);
  json.set("subtitle", map.subtitle);
  json.set("facts", Value::arrayOf(map.facts));
  json.set("footer", map.footer);
  json.set("legend_title", map.legendTitle);
  json.set("unit", map.unit);
  json.set("x_title", map.xTitle);
  json.set("y_title", map.yTitle);
  json.set("width", map.width);
  json.set("height", map.height);
  if (map.grid) {
    Value grid;
    grid.set("origin", toJson(map.grid->origin));
    grid.set("u", toJson(map.grid->u));
    grid.set("v", toJson(map.grid->v));
    grid.set("nu", map.grid->nu);
    grid.set("nv", map.grid->nv);
    json.set("grid", grid);
  }
  json.set("points", toJson(map.points));
  json.set("values", Value::arrayOf(map.values));
  json.set("lowest", map.lowest);
  json.set("highest", map.highest);
  json.set("levels", Value::arrayOf(map.levels));
  json.set("palette", map.palette);
  json.set("banded", map.banded);
  json.set("room_lines", toJson(map.roomLines));
  json.set("object_lines", toJson(map.objectLines));
  Value::Array luminaires;
  for (const MapLuminaire& luminaire : map.luminaires) {
    Value entry;
    entry.set("name", luminaire.name);
    entry.set("position", toJson(luminaire.position));
    entry.set("footprint", toJson(luminaire.footprint));
    luminaires.push_back(std::move(entry));
  }
  json.set("luminaires", std::move(luminaires));
  if (!map.words.empty()) {
    Value words = Value::Object{};
    for (const auto& [english, word] : map.words) words.set(english, word);
    json.set("words", words);
  }
  return json;
}

PlanMap planMapFromJson(const core::Value& document) {
  if (figureKind(document) != "plan-map") bad(member(document, "kind"), "a plan-map is expected");
  PlanMap map;
  map.title = text(document, "title");
  map.subtitle = text(document, "subtitle");
  for (const Value& fact : list(member(document, "facts"), "\"facts\"")) {
    if (!fact.isString()) bad(fact, "\"facts\" must hold texts");
    map.facts.push_back(fact.string());
  }
  map.footer = text(document, "footer");
  map.legendTitle = text(document, "legend_title");
  map.unit = text(document, "unit");
  map.xTitle = text(document, "x_title");
  map.yTitle = text(document, "y_title");
  map.width = wholeNumber(document, "width", 0, 8000);
  map.height = wholeNumber(document, "height", 0, 8000);
  readValues(document, map);
  map.palette = text(document, "palette");
  if (!findPalette(map.palette))
    bad(member(document, "palette"), fmt::format("there is no palette \"{}\"", map.palette));
  const Value& banded = member(document, "banded");
  if (!banded.isBoolean()) bad(banded, "\"banded\" must be true or false");
  map.banded = banded.boolean();
  map.roomLines = polylines(document, "room_lines");
  map.objectLines = polylines(document, "object_lines");
  for (const Value& entry : list(member(document, "luminaires"), "\"luminaires\"")) {
    map.luminaires.push_back({text(entry, "name"), vector2(member(entry, "position"), "\"position\""),
                              polyline(member(entry, "footprint"), "\"footprint\"")});
  }
  if (const Value* words = document.find("words")) {
    if (!words->isObject()) bad(*words, "\"words\" must be an object of texts");
    for (const auto& [english, word] : words->object()) map.words[english] = text(*words, english.c_str());
  }
  return map;
}

const std::string& PlanMap::word(const std::string& english) const {
  const auto found = words.find(english);
  return found == words.end() ? english : found->second;
}

}  // namespace goniolux::plot
