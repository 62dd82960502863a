// The rough variant of the model "dielectric" (see rough_dielectric.cpp).
#pragma once

#include <memory>

#include "reflection/bsdf.h"

namespace goniolux::reflection {

/// alpha in (0, 1].
std::unique_ptr<Bsdf> makeRoughDielectric(Medium medium, double alpha);

}  // namespace goniolux::reflection
