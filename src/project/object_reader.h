// The section "objects" of a project: shapes of the geometry registry with their materials and places.
#pragma once

#include <vector>

#include "core/document.h"
#include "material/material.h"
#include "project/reading.h"
#include "scene/environment.h"

namespace goniolux::project {

/// `materials`: what parts may refer to; objects hold indices into it.
std::vector<scene::Object> readObjects(const core::Value& section, const std::vector<material::Material>& materials,
                                       Reading& reading);

}  // namespace goniolux::project
