// Parameter: how a registry entry describes one of its settings. The project reader, the schema, the help texts and the
// forms of the interface read the same description.
#pragma once

#include <limits>
#include <map>
#include <string>
#include <variant>
#include <vector>

#include "core/vector.h"

namespace goniolux::core {

enum class ParameterKind {
  number,           ///< double
  length,           ///< double; the project's units in the file, metres inside
  text,             ///< std::string
  file,             ///< std::string: resolved path
  spectrum,         ///< a SPECTRUM of the project format
  refractiveIndex,  ///< a SPECTRUM, or Cauchy's or Sellmeier's formula
  boolean,          ///< double: 0 or 1
  direction,        ///< Vec3, any length but 0
  point,            ///< Vec3, lengths
  points2,          ///< list of Vec2, lengths
  points3,          ///< list of Vec3, lengths
  faces,            ///< list of lists of vertex indices (points3 of another key)
  loops3,           ///< list of lists of Vec3, lengths (holes)
};

struct Parameter {
  std::string key, title, unit;
  ParameterKind kind = ParameterKind::number;
  bool required = false;
  std::string defaultText;  ///< as a user would write it; "" = none
  double minimum = -std::numeric_limits<double>::infinity();
  double maximum = std::numeric_limits<double>::infinity();
  bool minimumIsAllowed = true;  ///< false: the value must be above the minimum
  std::string help, source;
};

/// Values by parameter key, checked against their descriptions and converted to SI.
using Argument = std::variant<double, std::string, Vec3, std::vector<Vec2>, std::vector<Vec3>,
                              std::vector<std::vector<int>>, std::vector<std::vector<Vec3>>>;
using Arguments = std::map<std::string, Argument>;

}  // namespace goniolux::core
