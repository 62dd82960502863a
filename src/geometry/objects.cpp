#include "geometry/objects.h"

#include <algorithm>

#include "geometry/box.h"
#include "geometry/cone.h"
#include "geometry/cylinder.h"
#include "geometry/disc.h"
#include "geometry/mesh_import.h"
#include "geometry/parametric.h"
#include "geometry/polygon.h"
#include "geometry/polyhedron.h"
#include "geometry/quadric.h"
#include "geometry/rectangle.h"
#include "geometry/revolution.h"
#include "geometry/sphere.h"
#include "geometry/torus.h"

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
      torusType(),
      quadricType(),
      revolutionType(),
      parametricType(),
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

}  // namespace goniolux::geometry
