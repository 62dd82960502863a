#include "geometry/arguments.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace goniolux::geometry {
namespace {

[[noreturn]] void refuseNonFinite(const std::string& key) {
  throw std::invalid_argument(fmt::format("\"{}\" is not a finite number; give plain numbers", key));
}

}  // namespace

void refuseMissing(const std::string& key) {
  throw std::invalid_argument(fmt::format("\"{}\" is missing; add it", key));
}

void refuseKind(const std::string& key) {
  throw std::invalid_argument(fmt::format("\"{}\" is of the wrong kind", key));
}

std::optional<double> optionalNumber(const core::Arguments& arguments, const std::string& key) {
  const auto value = optional<double>(arguments, key);
  if (value && !std::isfinite(*value)) refuseNonFinite(key);
  return value;
}

std::optional<core::Vec3> optionalVector(const core::Arguments& arguments, const std::string& key) {
  const auto value = optional<core::Vec3>(arguments, key);
  if (value && !std::isfinite(value->x + value->y + value->z)) refuseNonFinite(key);
  return value;
}

core::Vec3 requiredVector(const core::Arguments& arguments, const std::string& key) {
  const auto value = optionalVector(arguments, key);
  if (!value) refuseMissing(key);
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
