// Single values of the project file: numbers, vectors, texts, lists of pairs.
#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "project/section_reader.h"

namespace goniolux::project {
namespace {

const char* kindOf(const core::Value& value) {
  switch (value.kind()) {
    case core::Value::Kind::null:
      return "null";
    case core::Value::Kind::boolean:
      return "true or false";
    case core::Value::Kind::number:
      return "a number";
    case core::Value::Kind::string:
      return "a text";
    case core::Value::Kind::array:
      return "a list";
    case core::Value::Kind::object:
      return "an object";
  }
  return "something else";
}

void wrongType(const core::Value& value, const Key& key, const char* expected, Reading& reading) {
  reading.error(value, "wrong-type", fmt::format("\"{}\" is {}; {} is expected", key.name, kindOf(value), expected));
}

std::string limits(const Key& key) {
  const bool low = std::isfinite(key.minimum), high = std::isfinite(key.maximum);
  if (low && high && key.minimumIsAllowed) return fmt::format("it lies between {} and {}", key.minimum, key.maximum);
  if (low && high) return fmt::format("it must be above {} and at most {}", key.minimum, key.maximum);
  if (low) return fmt::format("it must be {} {}", key.minimumIsAllowed ? "at least" : "above", key.minimum);
  return fmt::format("it must be at most {}", key.maximum);
}

bool isVector(const core::Value& value, std::size_t size) {
  if (!value.isArray() || value.array().size() != size) return false;
  for (const core::Value& component : value.array()) {
    if (!component.isNumber()) return false;
  }
  return true;
}

}  // namespace

std::optional<double> readNumber(const core::Value& value, const Key& key, Reading& reading) {
  if (!value.isNumber()) {
    wrongType(value, key, "a number", reading);
    return std::nullopt;
  }
  const double number = value.number();
  const bool tooSmall = key.minimumIsAllowed ? number < key.minimum : number <= key.minimum;
  if (tooSmall || number > key.maximum) {
    reading.error(value, "out-of-range", fmt::format("\"{}\" is {}; {}", key.name, number, limits(key)));
    return std::nullopt;
  }
  return number;
}

std::optional<core::Vec3> readVector(const core::Value& value, const Key& key, Reading& reading) {
  if (!isVector(value, 3)) {
    wrongType(value, key, "a list of three numbers [x, y, z]", reading);
    return std::nullopt;
  }
  const auto& list = value.array();
  return core::Vec3(list[0].number(), list[1].number(), list[2].number());
}

std::optional<core::Vec3> readPoint(const core::Value& value, const Key& key, Reading& reading) {
  auto point = readVector(value, key, reading);
  if (!point) return std::nullopt;
  // Beyond this, distances no longer fit a float with any precision: a slip of units or of the pen.
  constexpr double farthest = 1e7;
  *point *= reading.metresPerUnit;
  for (int axis = 0; axis < 3; ++axis) {
    if (std::abs((*point)[axis]) > farthest) {
      reading.error(value, "out-of-range",
                    fmt::format("\"{}\" lies {} m from the origin; coordinates may reach 10 000 km", key.name,
                                std::abs((*point)[axis])));
      return std::nullopt;
    }
  }
  return point;
}

std::optional<core::Vec3> readDirection(const core::Value& value, const Key& key, Reading& reading) {
  const auto vector = readVector(value, key, reading);
  if (!vector) return std::nullopt;
  const double largest = std::max({std::abs(vector->x), std::abs(vector->y), std::abs(vector->z)});
  if (!(largest > 0)) {
    reading.error(value, "zero-vector",
                  fmt::format("\"{}\" has no length; give a direction, e.g. [0, 0, 1]", key.name));
    return std::nullopt;
  }
  return glm::normalize(*vector / largest);  // scaled first: the squares of very long or short vectors would not fit
}

std::optional<std::string> readText(const core::Value& value, const Key& key, Reading& reading) {
  if (!value.isString()) {
    wrongType(value, key, "a text in quotes", reading);
    return std::nullopt;
  }
  return value.string();
}

std::optional<std::vector<core::Vec2>> readPairs(const core::Value& value, const Key& key, Reading& reading) {
  std::vector<core::Vec2> pairs;
  if (!value.isArray() || value.array().empty()) {
    wrongType(value, key, "a list of pairs [[a, b], …]", reading);
    return std::nullopt;
  }
  for (const core::Value& pair : value.array()) {
    if (!isVector(pair, 2)) {
      wrongType(pair, key, "a pair of numbers", reading);
      return std::nullopt;
    }
    pairs.emplace_back(pair.array()[0].number(), pair.array()[1].number());
  }
  return pairs;
}

std::optional<double> fractionFromText(const std::string& text) {
  double number = 0;
  const char* end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, number);
  if (result.ec != std::errc()) return std::nullopt;
  const std::string rest(result.ptr, end);
  const std::size_t sign = rest.find_first_not_of(' ');
  if (sign != std::string::npos) {
    if (rest[sign] != '%' || rest.find_first_not_of(' ', sign + 1) != std::string::npos) return std::nullopt;
    number /= 100;
  }
  if (!(number > 0) || !(number < 1)) return std::nullopt;
  return number;
}

}  // namespace goniolux::project
