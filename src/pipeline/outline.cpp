#include "pipeline/outline.h"

#include <fmt/format.h>

#include <cmath>

namespace goniolux::pipeline {
namespace {

using core::Value;
using core::Vec3;

struct Box {
  Vec3 low{1e300}, high{-1e300};
  void add(const Vec3& point) {
    low = glm::min(low, point);
    high = glm::max(high, point);
  }
  [[nodiscard]] double planArea() const { return std::max(high.x - low.x, 0.0) * std::max(high.y - low.y, 0.0); }
};

void addPolygon(std::vector<Vec3>& footprint, const Vec3& center, const Vec3& alongHalf, const Vec3& acrossHalf) {
  footprint = {center - alongHalf - acrossHalf, center + alongHalf - acrossHalf, center + alongHalf + acrossHalf,
               center - alongHalf + acrossHalf};
}

void addCircle(std::vector<Vec3>& footprint, const Vec3& center, const Vec3& x, const Vec3& y, double radius) {
  constexpr int sides = 32;
  for (int i = 0; i < sides; ++i) {
    const double angle = 2 * core::pi * i / sides;
    footprint.push_back(center + radius * (std::cos(angle) * x + std::sin(angle) * y));
  }
}

Box boxOf(const std::vector<Triangle>& triangles) {
  Box box;
  for (const Triangle& triangle : triangles) {
    for (const Vec3& corner : triangle) box.add(corner);
  }
  return box;
}

// ---- the document ----

double rounded(double length) {
  return std::round(length * 1e6) / 1e6 + 0.0;
}

Value toJson(const Vec3& v) {
  return Value::Array{rounded(v.x), rounded(v.y), rounded(v.z)};
}

Value toJson(const std::vector<Segment>& segments) {
  Value::Array list;
  list.reserve(segments.size());
  for (const Segment& segment : segments) {
    list.push_back(Value::Array{rounded(segment.from.x), rounded(segment.from.y), rounded(segment.from.z),
                                rounded(segment.to.x), rounded(segment.to.y), rounded(segment.to.z)});
  }
  return list;
}

[[noreturn]] void damaged(const Value& where, const std::string& what) {
  throw core::InputError(where.position(), "damaged-outline",
                         what +
                             "; make the outline again with `goniolux illuminate`, or remove the file: plots are then "
                             "drawn without furniture");
}

const Value& member(const Value& object, const char* key, Value::Kind kind) {
  const Value* value = object.find(key);
  if (!value || value->kind() != kind)
    damaged(value ? *value : object, fmt::format("\"{}\" is missing or no {}", key,
                                                 kind == Value::Kind::array    ? "list"
                                                 : kind == Value::Kind::string ? "text"
                                                                               : "true or false"));
  return *value;
}

std::vector<double> numbers(const Value& value, std::size_t count) {
  std::vector<double> result;
  if (!value.isArray() || value.array().size() != count) damaged(value, fmt::format("{} numbers are expected", count));
  for (const Value& entry : value.array()) {
    if (!entry.isNumber()) damaged(entry, "a number is expected");
    result.push_back(entry.number());
  }
  return result;
}

Vec3 vector3(const Value& value) {
  const std::vector<double> n = numbers(value, 3);
  return {n[0], n[1], n[2]};
}

std::vector<Segment> segments(const Value& list) {
  std::vector<Segment> result;
  for (const Value& entry : list.array()) {
    const std::vector<double> n = numbers(entry, 6);
    result.push_back({{n[0], n[1], n[2]}, {n[3], n[4], n[5]}});
  }
  return result;
}

}  // namespace

LuminaireOutline outlineOf(const scene::Luminaire& luminaire) {
  using Shape = emitter::Opening::Shape;
  LuminaireOutline outline{luminaire.name, luminaire.type, luminaire.center, luminaire.frame.aim, {}};
  const emitter::Opening& opening = luminaire.opening;
  const Vec3 center = luminaire.center;
  const emitter::OpeningAxes axes = emitter::axesOf(opening, luminaire.frame);
  const Vec3 radii = 0.5 * emitter::diametersOf(opening);
  switch (opening.shape) {
    case Shape::point:
      break;
    case Shape::rectangle:
    case Shape::box:
      addPolygon(outline.footprint, center, axes.x * (opening.length / 2), axes.y * (opening.width / 2));
      break;
    case Shape::disc:
    case Shape::cylinder:
      addCircle(outline.footprint, center, axes.x * radii.x, axes.y * radii.y, 1);
      break;
    case Shape::sphere:
      addCircle(outline.footprint, center, axes.x * radii.x, axes.y * radii.y, 1);
      break;
    case Shape::revolution: {
      double radius = 0;
      for (const core::Vec2& point : opening.profile) radius = std::max(radius, point.x);
      addCircle(outline.footprint, center, luminaire.frame.c0, luminaire.frame.c90, radius);
      break;
    }
    case Shape::line:
      outline.footprint = {center - opening.axis * (opening.length / 2), center + opening.axis * (opening.length / 2)};
      break;
    case Shape::tube: {
      const double planLength = std::hypot(opening.axis.x, opening.axis.y);
      if (planLength < 1e-6) {  // upright: its cross-section
        addCircle(outline.footprint, center, {1, 0, 0}, {0, 1, 0}, opening.diameter / 2);
      } else {
        const Vec3 across(-opening.axis.y / planLength, opening.axis.x / planLength, 0);
        addPolygon(outline.footprint, center, opening.axis * (opening.length / 2), across * (opening.diameter / 2));
      }
      break;
    }
  }
  return outline;
}

Outline outlineOf(const project::Project& project) {
  Outline outline;
  outline.project = project.name;
  outline.projectHash = project.hash;

  const std::vector<scene::Object>& objects = project.environment.objects;
  std::vector<std::vector<Triangle>> surfaces;
  Box whole;
  for (const scene::Object& object : objects) {
    surfaces.push_back(coveringTriangles(object));
    const Box box = boxOf(surfaces.back());
    if (box.low.x <= box.high.x) {
      whole.add(box.low);
      whole.add(box.high);
    }
  }
  for (const scene::Luminaire& luminaire : project.environment.luminaires) {
    outline.luminaires.push_back(outlineOf(luminaire));
    if (objects.empty()) whole.add(luminaire.center);
  }
  if (whole.low.x <= whole.high.x) {
    outline.low = whole.low;
    outline.high = whole.high;
  }

  std::vector<Triangle> covers;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const bool isRoom = objects[i].facesInward || boxOf(surfaces[i]).planArea() > 0.5 * whole.planArea();
    outline.objects.push_back({objects[i].name, isRoom, featureEdges(objects[i]), {}});
    if (!isRoom) covers.insert(covers.end(), surfaces[i].begin(), surfaces[i].end());
  }
  const double tolerance = 1e-5 * std::max(glm::distance(outline.low, outline.high), 1e-3);
  const PlanCovers furniture(std::move(covers)), nothing({});
  for (ObjectOutline& object : outline.objects) {
    // Under its furniture a room's floor line is still the room.
    object.plan = (object.isRoom ? nothing : furniture).visible(object.edges, tolerance);
  }
  return outline;
}

Value toJson(const Outline& outline) {
  Value json;
  json.set("format", "goniolux-outline");
  json.set("version", 1);
  json.set("project", outline.project);
  json.set("project_hash", outline.projectHash);
  json.set("low", toJson(outline.low));
  json.set("high", toJson(outline.high));
  Value::Array objects, luminaires;
  for (const ObjectOutline& object : outline.objects) {
    Value entry;
    entry.set("name", object.name);
    entry.set("room", object.isRoom);
    entry.set("edges", toJson(object.edges));
    entry.set("plan", toJson(object.plan));
    objects.push_back(std::move(entry));
  }
  for (const LuminaireOutline& luminaire : outline.luminaires) {
    Value entry;
    entry.set("name", luminaire.name);
    entry.set("type", luminaire.type);
    entry.set("position", toJson(luminaire.position));
    entry.set("aim", toJson(luminaire.aim));
    Value::Array footprint;
    for (const Vec3& corner : luminaire.footprint) footprint.push_back(toJson(corner));
    entry.set("footprint", std::move(footprint));
    luminaires.push_back(std::move(entry));
  }
  json.set("objects", std::move(objects));
  json.set("luminaires", std::move(luminaires));
  return json;
}

Outline outlineFromJson(const Value& document) {
  if (!document.isObject()) damaged(document, "an object with \"format\": \"goniolux-outline\" is expected");
  if (member(document, "format", Value::Kind::string).string() != "goniolux-outline") {
    damaged(*document.find("format"), "this is no outline");
  }
  const Value* version = document.find("version");
  if (!version || !version->isNumber() || version->number() != 1) damaged(document, "its version is not 1");

  Outline outline;
  outline.project = member(document, "project", Value::Kind::string).string();
  outline.projectHash = member(document, "project_hash", Value::Kind::string).string();
  outline.low = vector3(member(document, "low", Value::Kind::array));
  outline.high = vector3(member(document, "high", Value::Kind::array));
  for (const Value& entry : member(document, "objects", Value::Kind::array).array()) {
    outline.objects.push_back(
        {member(entry, "name", Value::Kind::string).string(), member(entry, "room", Value::Kind::boolean).boolean(),
         segments(member(entry, "edges", Value::Kind::array)), segments(member(entry, "plan", Value::Kind::array))});
  }
  for (const Value& entry : member(document, "luminaires", Value::Kind::array).array()) {
    LuminaireOutline luminaire{member(entry, "name", Value::Kind::string).string(),
                               member(entry, "type", Value::Kind::string).string(),
                               vector3(member(entry, "position", Value::Kind::array)),
                               vector3(member(entry, "aim", Value::Kind::array)),
                               {}};
    for (const Value& corner : member(entry, "footprint", Value::Kind::array).array()) {
      luminaire.footprint.push_back(vector3(corner));
    }
    outline.luminaires.push_back(std::move(luminaire));
  }
  return outline;
}

}  // namespace goniolux::pipeline
