// The registry of object types (the paper's object managers): adding one is a file of its own and a line in objects.cpp.
#pragma once

#include <string>
#include <vector>

#include "core/parameter.h"
#include "geometry/shape.h"

namespace goniolux::geometry {

struct ObjectType {
  std::string name, title;
  std::vector<core::Parameter> parameters;
  std::vector<std::string> parts;  ///< part names it offers, e.g. floor, walls, ceiling
  /// Builds the shape. Arguments hold every required key and every default. Throws std::invalid_argument with a sentence
  /// (what is wrong; what to do) when values do not fit together.
  Shape (*make)(const core::Arguments& arguments);
};

const std::vector<ObjectType>& objectTypes();
const ObjectType* findObjectType(const std::string& name);

}  // namespace goniolux::geometry
