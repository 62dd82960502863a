// What is doubtful about a project's geometry, found before any light is traced: every finding is a warning at the
// object, luminaire or grid of the project file, and names the place in metres.
#pragma once

#include <string>
#include <vector>

#include "core/diagnostics.h"
#include "geometry/coincidence.h"
#include "project/project.h"

namespace goniolux::pipeline {

/// Slivers and open glass, coincident surfaces, objects that reach out of the room, luminaires and grid points inside
/// objects, a scale that no building has.
void findInGeometry(const project::Project& project, core::Diagnostics& found);

/// The coincident surfaces alone; what has too many triangles to be searched is named in `found`.
std::vector<geometry::Coincidence> coincidencesOf(const project::Project& project, core::Diagnostics& found);

/// Holes that rays escape through (from luminaires and grids), luminaires that look at a surface right before them,
/// grid points that lie in a face, and surfaces that run through each other.
void findByRays(const project::Project& project, core::Diagnostics& found);

/// "(1.25, 0, 3) m"
std::string placeText(const core::Vec3& place);

}  // namespace goniolux::pipeline
