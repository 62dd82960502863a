#include "geometry/objects.h"

#include <algorithm>

#include "geometry/box.h"
#include "geometry/cone.h"
#include "geometry/cylinder.h"
#include "geometry/disc.h"
#include "geometry/mesh_import.h"
#include "geometry/polygon.h"
#include "geometry/polyhedron.h"
#include "geometry/rectangle.h"
#include "geometry/revolution.h"
#include "geometry/sphere.h"

namespace goniolux::geometry {

const std::vector<ObjectType>& objectTypes() {
  static const std::vector<ObjectType> types{
      // clang-format off
      boxType(),
      rectangleType(),
      polygonType(),
      discType(),
      sphereType(),
      cylinderType(),
      coneType(),
      revolutionType(),
      polyhedronType(),
      meshType(),
      // clang-format on
  };
  return types;
}

const ObjectType* findObjectType(const std::string& name) {
  const auto& types = objectTypes();
  const auto it = std::find_if(types.begin(), types.end(), [&](const ObjectType& type) { return type.name == name; });
  return it == types.end() ? nullptr : &*it;
}

const std::vector<std::string>& plannedObjectTypes() {
  static const std::vector<std::string> names{"torus", "quadric", "parametric"};
  return names;
}

}  // namespace goniolux::geometry
