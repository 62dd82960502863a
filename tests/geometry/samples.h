// One or more examples of every registered object type with what is known of them in closed form: the registry's tests
// loop over these, and fail when a type has none.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/parameter.h"

namespace goniolux::geometry::test {

struct Sample {
  std::string type, title;
  core::Arguments arguments;
  double area = 0;
  double volume = 0;         ///< 0 for open shapes
  double tolerance = 1e-12;  ///< relative, of what our own area and volume promise
};

/// Files that samples need are written into `folder`.
std::vector<Sample> samples(const std::filesystem::path& folder);

}  // namespace goniolux::geometry::test
