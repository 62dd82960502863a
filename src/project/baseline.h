// Baseline: expected.json beside a project: what its values should be, with intervals, and what they were made from.
//
// Two kinds of values stand in one list: those of another source (a closed form, another program), whose origin the
// document's "source" says, and those of an earlier run of Goniolux (`verify --update`), marked "own", which carry the
// inputs' hashes and are renewed together. Values are photometric, in the unit that stands beside them.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "project/project.h"
#include "project/results.h"

namespace goniolux::project {

struct ExpectedValue {
  std::string grid, observer;  ///< one of the two
  std::string quantity;        ///< "mean", "min", "max", "u0", "point" (with index), "points" (all), "ugr"
  std::string unit;
  std::optional<std::size_t> index;
  bool own = false;
  core::Estimate estimate;                  ///< of a single value; of another source: all of it statistical
  std::vector<double> values, statistical;  ///< quantity "points": NaN where excluded
  std::vector<double> systematic;           ///< quantity "points": bound of the deterministic error
  std::optional<double> tolerance;          ///< absolute, beside the interval
};

/// How much a quantity may change without being told: relative to its value, or absolute.
struct Tolerance {
  double relative = 0, absolute = 0;
};

struct Baseline {
  std::string file;    ///< where it was read from
  std::string source;  ///< of the values that are not own
  double confidence = 0.95;
  std::vector<ExpectedValue> values;
  std::map<std::string, Tolerance> tolerances;  ///< by quantity
  // Of the own values:
  std::string programVersion;
  std::optional<double> accuracy;  ///< that was asked of the grids
  std::uint64_t seed = 0;
  std::vector<InputFile> inputs;
  std::map<std::string, std::string> entries;  ///< hash of each entry of project.json: "materials \"paint\"" …
};

/// Reads expected.json. Throws core::InputError with every fault and its place.
Baseline readBaseline(const std::string& file);
core::Value toJson(const Baseline& baseline);

/// The values of a run as own values: mean, minimum, maximum, U0 and all points of each grid, and each observer.
std::vector<ExpectedValue> ownValues(const Results& results);

/// A short hash of every entry of a project file by what it is called: "materials \"paint\"", "settings", … so that a
/// change can be named. Empty when the text cannot be parsed.
std::map<std::string, std::string> entryHashes(const std::string& projectText);

inline constexpr const char* baselineFileName = "expected.json";

}  // namespace goniolux::project
