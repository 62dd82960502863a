// Sphere, intersected exactly.
#pragma once

#include "geometry/objects.h"

namespace goniolux::geometry {

/// One part, "surface"; closed, outward.
Shape makeSphere(const core::Vec3& center, double radius);

ObjectType sphereType();

}  // namespace goniolux::geometry
