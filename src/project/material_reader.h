// The section "materials" of a project: finishes by name.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/document.h"
#include "material/material.h"
#include "project/reading.h"

namespace goniolux::project {

/// All materials of the section, in the file's order. Materials with errors are left in by name, so that objects which
/// use them raise no second error.
std::vector<material::Material> readMaterials(const core::Value& section, Reading& reading);

}  // namespace goniolux::project
