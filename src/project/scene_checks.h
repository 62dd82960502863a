// Checks of a read project that need its geometry but no tracer: what stands outside every room, and eyes inside
// solids.
#pragma once

#include "project/project.h"

namespace goniolux::project {

/// Errors: a grid wholly outside, a view's or observer's eye inside a solid. Warnings: luminaires or some grid points
/// outside, surfaces that reflect everything.
void checkScene(const Project& project, core::Diagnostics& diagnostics);

}  // namespace goniolux::project
