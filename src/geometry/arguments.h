// How object managers take their arguments: typed, finite, or an exception with a sentence for the designer.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "core/parameter.h"

namespace goniolux::geometry {

/// Throws std::invalid_argument: "KEY" is missing, or of the wrong kind.
[[noreturn]] void refuseMissing(const std::string& key);
[[noreturn]] void refuseKind(const std::string& key);

/// The value of `key`, or nothing when it was left out. A value of another kind than the entry declares is the reader's
/// mistake, but still no reason to crash.
template <typename T>
std::optional<T> optional(const core::Arguments& arguments, const std::string& key) {
  const auto it = arguments.find(key);
  if (it == arguments.end()) return std::nullopt;
  const T* value = std::get_if<T>(&it->second);
  if (!value) refuseKind(key);
  return *value;
}
template <typename T>
T required(const core::Arguments& arguments, const std::string& key) {
  auto value = optional<T>(arguments, key);
  if (!value) refuseMissing(key);
  return *std::move(value);
}

/// As above, but throws std::invalid_argument also when the value is not finite.
std::optional<double> optionalNumber(const core::Arguments& arguments, const std::string& key);
std::optional<core::Vec3> optionalVector(const core::Arguments& arguments, const std::string& key);
core::Vec3 requiredVector(const core::Arguments& arguments, const std::string& key);

/// A radius given as `radiusKey` or as twice that under `diameterKey`: exactly one, above 0; returns the radius.
double radiusOrDiameter(const core::Arguments& arguments, const std::string& radiusKey, const std::string& diameterKey);

/// A description of the parameter pair that radiusOrDiameter reads.
core::Parameter radiusParameter(const std::string& key, const std::string& title, const std::string& help);
core::Parameter pointParameter(const std::string& key, const std::string& title, bool required,
                               const std::string& defaultText, const std::string& help);

}  // namespace goniolux::geometry
