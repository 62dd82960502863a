// Grid: the points at which a photometric quantity is wanted.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/diagnostics.h"
#include "core/vector.h"

namespace goniolux::analysis {

struct Grid {
  std::string name;
  std::string quantity = "illuminance";      ///< a name of the metric registry
  std::vector<core::Vec3> points;            ///< values run u fastest
  std::vector<core::Vec3> normals;           ///< unit, one per point
  std::optional<std::array<int, 2>> counts;  ///< for a regular grid: along u, along v
  core::Vec3 axis{0, 0, 1};                  ///< unit, of cylindrical quantities
  core::Vec3 origin{0}, u{0}, v{0};          ///< regular grid: corner and full edges
  core::SourcePosition position;
};

struct Observer {
  std::string name, quantity = "ugr";
  core::Vec3 eye{0}, direction{1, 0, 0};
  core::SourcePosition position;
};

/// A limit on a quantity of a grid or observer; `key` as in the project file: "mean_lx", "min_lx", "max_lx", "u0",
/// "ud", "ugr".
struct Limit {
  std::string key;
  std::optional<double> minimum, maximum;
};
struct Requirement {
  std::string grid, observer;  ///< one of the two is set
  std::vector<Limit> limits;
  core::SourcePosition position;
  std::string clause = {};  ///< where the limits stand in a standard; "" = the project's own
};

}  // namespace goniolux::analysis
