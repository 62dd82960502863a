// The registry of object types (the paper's object managers): adding one is a file of its own and a line in
// objects.cpp. What every entry promises is held by tests/geometry/registry_test.cpp, which loops over the registry.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/parameter.h"
#include "geometry/shape.h"

namespace goniolux::geometry {

struct ObjectType {
  std::string name, title;
  std::vector<core::Parameter> parameters;
  std::vector<std::string> parts;  ///< part names it offers, e.g. floor, xmin; empty: the shape's file says (mesh)
  /// Builds the shape. Arguments hold every required key and every default. Throws std::invalid_argument with a
  /// sentence (what is wrong; what to do) when values do not fit together.
  Shape (*make)(const core::Arguments& arguments);
  /// Names for several parts at once, e.g. "walls" -> xmin, xmax, ymin, ymax. In "materials" a part's own name wins
  /// over a group's, a group's over "*".
  std::map<std::string, std::vector<std::string>> partGroups = {};
  bool isClosed = false;  ///< bounds a volume whatever its arguments (a mesh or an uncapped cylinder may not)
};

const std::vector<ObjectType>& objectTypes();
const ObjectType* findObjectType(const std::string& name);

}  // namespace goniolux::geometry
