// How object managers take their arguments: typed, finite, or an exception with a sentence for the designer.
#pragma once

#include <optional>
#include <string>

#include "core/parameter.h"

namespace goniolux::geometry {

/// The value of `key`, or nothing when it was left out. Throws std::invalid_argument when it is not finite.
std::optional<double> optionalNumber(const core::Arguments& arguments, const std::string& key);
std::optional<core::Vec3> optionalVector(const core::Arguments& arguments, const std::string& key);
std::optional<std::string> optionalText(const core::Arguments& arguments, const std::string& key);

/// As above, but leaving it out is an std::invalid_argument too.
core::Vec3 requiredVector(const core::Arguments& arguments, const std::string& key);

/// A radius given as `radiusKey` or as twice that under `diameterKey`: exactly one, above 0; returns the radius.
double radiusOrDiameter(const core::Arguments& arguments, const std::string& radiusKey, const std::string& diameterKey);

/// A description of the parameter pair that radiusOrDiameter reads.
core::Parameter radiusParameter(const std::string& key, const std::string& title, const std::string& help);
core::Parameter pointParameter(const std::string& key, const std::string& title, bool required,
                               const std::string& defaultText, const std::string& help);

}  // namespace goniolux::geometry
