// Pattern: a number from 0 to 1 at every place of a surface. It mixes two finishes, or is the height of a relief.
// Immutable, thread safe.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/parameter.h"
#include "texture/projection.h"

namespace goniolux::texture {

class Pattern {
 public:
  virtual ~Pattern() = default;
  [[nodiscard]] virtual double at(const Place& place) const = 0;
  /// Over a whole repeat.
  [[nodiscard]] virtual double mean() const = 0;
  /// A step in repeats over which the slope of a relief is taken.
  [[nodiscard]] virtual double step() const { return 1e-3; }
};

/// The registry of procedures: adding one is a file of its own and a line in patterns.cpp. tests/texture loops over it.
struct PatternType {
  std::string name, title;
  std::vector<core::Parameter> parameters;  ///< numbers
  std::shared_ptr<const Pattern> (*make)(const core::Arguments& arguments) = nullptr;
};
const std::vector<PatternType>& patternTypes();
const PatternType* findPatternType(const std::string& name);

}  // namespace goniolux::texture
