// Cylinder: a right circular cylinder with optional end caps, intersected exactly.
#pragma once

#include "geometry/objects.h"

namespace goniolux::geometry {

ObjectType cylinderType();

}  // namespace goniolux::geometry
