// Cone: a right circular cone or frustum with optional end caps, intersected exactly.
#pragma once

#include "geometry/objects.h"

namespace goniolux::geometry {

ObjectType coneType();

}  // namespace goniolux::geometry
