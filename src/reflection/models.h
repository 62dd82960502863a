// The entries of the reflection-model registry, one function per model's file.
#pragma once

#include "reflection/bsdf.h"

namespace goniolux::reflection {

ReflectionModel lambertModel();
ReflectionModel mirrorModel();

}  // namespace goniolux::reflection
