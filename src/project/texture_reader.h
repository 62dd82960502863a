// The keys "texture" and "bump" of materials: how a finish changes from place to place.
#pragma once

#include "core/document.h"
#include "project/reading.h"
#include "scene/environment.h"

namespace goniolux::project {

/// Reads them for all materials of the section, which readMaterials has read before: makes the components of textured
/// finishes, and the environment's textures and reliefs.
void readTextures(const core::Value& section, scene::Environment& environment, Reading& reading);

}  // namespace goniolux::project
