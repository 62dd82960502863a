#include "project/arguments_reader.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

namespace goniolux::project {
namespace {

using core::ParameterKind;

std::optional<std::vector<core::Vec2>> readProfile(const core::Value& value, const Key& key, Reading& reading) {
  auto pairs = readPairs(value, key, reading);
  if (pairs) {
    for (core::Vec2& pair : *pairs) pair *= reading.metresPerUnit;
  }
  return pairs;
}

std::optional<std::vector<std::vector<int>>> readFaces(const core::Value& value, const Key& key, Reading& reading) {
  std::vector<std::vector<int>> faces;
  const auto refuse = [&](const core::Value& at) {
    reading.error(at, "wrong-type",
                  fmt::format("\"{}\" must be a list of faces, each a list of vertex numbers", key.name));
    return std::nullopt;
  };
  if (!value.isArray() || value.array().empty()) return refuse(value);
  for (const core::Value& face : value.array()) {
    if (!face.isArray()) return refuse(face);
    std::vector<int>& corners = faces.emplace_back();
    for (const core::Value& corner : face.array()) {
      const bool whole = corner.isNumber() && corner.number() == std::floor(corner.number());
      if (!whole || corner.number() < 0 || corner.number() > 1e9) return refuse(corner);
      corners.push_back(static_cast<int>(corner.number()));
    }
  }
  return faces;
}

std::optional<std::vector<std::vector<core::Vec3>>> readLoops(const core::Value& value, const Key& key,
                                                              Reading& reading) {
  std::vector<std::vector<core::Vec3>> loops;
  if (!value.isArray()) {
    reading.error(value, "wrong-type", fmt::format("\"{}\" must be a list of lists of points", key.name));
    return std::nullopt;
  }
  for (const core::Value& loop : value.array()) {
    if (!loop.isArray()) {
      reading.error(loop, "wrong-type", fmt::format("each of \"{}\" must be a list of points", key.name));
      return std::nullopt;
    }
    std::vector<core::Vec3>& corners = loops.emplace_back();
    for (const core::Value& corner : loop.array()) {
      const auto point = readPoint(corner, key, reading);
      if (!point) return std::nullopt;
      corners.push_back(*point);
    }
  }
  return loops;
}

template <typename T>
std::optional<core::Argument> argument(std::optional<T> value) {
  return value ? std::optional<core::Argument>(std::move(*value)) : std::nullopt;
}

std::optional<core::Argument> readGiven(SectionReader& section, const core::Parameter& parameter, Reading& reading) {
  const std::string& name = parameter.key;
  const core::Value& value = *section.find(name);
  const Key key{.name = name};
  switch (parameter.kind) {
    case ParameterKind::number:
      return argument(section.number(name));
    case ParameterKind::length:
      return argument(section.length(name));
    case ParameterKind::text:
      return argument(section.text(name));
    case ParameterKind::file:
      return argument(reading.file(value, Library::none));
    case ParameterKind::direction:
      return argument(section.direction(name));
    case ParameterKind::point:
      return argument(section.point(name));
    case ParameterKind::points2:
      return argument(readProfile(value, key, reading));
    case ParameterKind::points3:
      return argument(section.points(name));
    case ParameterKind::faces:
      return argument(readFaces(value, key, reading));
    case ParameterKind::loops3:
      return argument(readLoops(value, key, reading));
    case ParameterKind::boolean:
    case ParameterKind::refractiveIndex:
    case ParameterKind::spectrum:
      break;  // no object type has one; materials read theirs with their role
  }
  reading.notSupported(value.position(), fmt::format("\"{}\" as a spectrum", name));
  return std::nullopt;
}

/// A default as the registry writes it, in SI: a number or a text. Vectors have theirs in the shape's maker.
std::optional<core::Argument> defaultOf(const core::Parameter& parameter) {
  if (parameter.defaultText.empty()) return std::nullopt;
  switch (parameter.kind) {
    case ParameterKind::number:
    case ParameterKind::length:
      return std::strtod(parameter.defaultText.c_str(), nullptr);
    case ParameterKind::text:
      return parameter.defaultText;
    case ParameterKind::direction:
    case ParameterKind::point: {
      core::Diagnostics faults;
      const core::Value value = core::parseJson(parameter.defaultText, parameter.key, faults);
      if (faults.hasErrors() || !value.isArray() || value.array().size() != 3) return std::nullopt;
      const auto& list = value.array();
      return core::Vec3(list[0].number(), list[1].number(), list[2].number());
    }
    default:
      return std::nullopt;
  }
}

}  // namespace

std::optional<core::Arguments> readArguments(SectionReader& section, const std::vector<core::Parameter>& parameters,
                                             Reading& reading) {
  core::Arguments arguments;
  bool complete = true;
  for (const core::Parameter& parameter : parameters) {
    const bool given = section.has(parameter.key);
    const auto value = given ? readGiven(section, parameter, reading) : defaultOf(parameter);
    if (value) arguments[parameter.key] = *value;
    if (!value && (given || parameter.required)) complete = false;
  }
  return complete ? std::optional(std::move(arguments)) : std::nullopt;
}

}  // namespace goniolux::project
