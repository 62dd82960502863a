#include "geometry/arguments.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace goniolux::geometry {
namespace {

// A value of another kind than the entry declares is the reader's mistake, but still no reason to crash.
template <typename T>
const T* find(const core::Arguments& arguments, const std::string& key) {
  const auto it = arguments.find(key);
  if (it == arguments.end()) return nullptr;
  const T* value = std::get_if<T>(&it->second);
  if (!value) throw std::invalid_argument(fmt::format("\"{}\" is of the wrong kind", key));
  return value;
}

[[noreturn]] void refuseNonFinite(const std::string& key) {
  throw std::invalid_argument(fmt::format("\"{}\" is not a finite number; give plain numbers", key));
}

}  // namespace

std::optional<double> optionalNumber(const core::Arguments& arguments, const std::string& key) {
  const double* value = find<double>(arguments, key);
  if (!value) return std::nullopt;
  if (!std::isfinite(*value)) refuseNonFinite(key);
  return *value;
}

std::optional<core::Vec3> optionalVector(const core::Arguments& arguments, const std::string& key) {
  const core::Vec3* value = find<core::Vec3>(arguments, key);
  if (!value) return std::nullopt;
  if (!std::isfinite(value->x) || !std::isfinite(value->y) || !std::isfinite(value->z)) refuseNonFinite(key);
  return *value;
}

std::optional<std::string> optionalText(const core::Arguments& arguments, const std::string& key) {
  const std::string* value = find<std::string>(arguments, key);
  return value ? std::optional<std::string>(*value) : std::nullopt;
}

core::Vec3 requiredVector(const core::Arguments& arguments, const std::string& key) {
  const auto value = optionalVector(arguments, key);
  if (!value) throw std::invalid_argument(fmt::format("\"{0}\" is missing; add \"{0}\": [x, y, z]", key));
  return *value;
}

double radiusOrDiameter(const core::Arguments& arguments, const std::string& radiusKey,
                        const std::string& diameterKey) {
  const auto radius = optionalNumber(arguments, radiusKey);
  const auto diameter = optionalNumber(arguments, diameterKey);
  if (radius.has_value() == diameter.has_value()) {
    throw std::invalid_argument(
        fmt::format("give either \"{}\" or \"{}\"{}", radiusKey, diameterKey, radius ? ", not both" : ""));
  }
  const double value = radius ? *radius : *diameter / 2;
  if (!(value > 0)) {
    throw std::invalid_argument(fmt::format("\"{}\" must be above 0", radius ? radiusKey : diameterKey));
  }
  return value;
}

core::Parameter radiusParameter(const std::string& key, const std::string& title, const std::string& help) {
  return {.key = key,
          .title = title,
          .unit = std::string("m"),
          .kind = core::ParameterKind::length,
          .required = false,
          .defaultText = {},
          .minimum = 0,
          .minimumIsAllowed = false,
          .help = help,
          .source = {}};
}

core::Parameter pointParameter(const std::string& key, const std::string& title, bool required,
                               const std::string& defaultText, const std::string& help) {
  return {.key = key,
          .title = title,
          .unit = std::string("m"),
          .kind = core::ParameterKind::point,
          .required = required,
          .defaultText = defaultText,
          .help = help,
          .source = {}};
}

}  // namespace goniolux::geometry
