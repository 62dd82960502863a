// Repairs that change nothing that is meant: written as a new project file, the old one stays.
#pragma once

#include <string>
#include <vector>

#include "project/project.h"

namespace goniolux::pipeline {

/// Writes `file` (beside the project's own, for its paths to hold): the project with open surfaces that lie in another
/// surface lifted off it by 1/5000 of the scene's size (1 mm in an office of 5 m), and meshes with cracks no wider than
/// 1e-5 of their extent, doubled triangles or sides that disagree replaced by a mended model, if that makes them
/// closed. Returns a sentence for each repair; writes nothing when there is nothing to repair. Throws core::InputError
/// when the file is there already.
std::vector<std::string> repairProject(const project::Project& project, const std::string& file);

}  // namespace goniolux::pipeline
