// Placement: entries of the project moved and turned as a person would write it: a luminaire's position, a box's
// corners, else a step of the transform. Metres and degrees, world frame of the project.
#pragma once

#include <string>

#include "core/vector.h"
#include "project/project_text.h"

namespace goniolux::gui {

/// What the project's unit of length is, in metres; 1 where it says none.
double metresPerUnit(const core::Value& root);

/// Moves a luminaire ("/luminaires/2"), an object, an observer or a view. False where the entry has nothing to move.
bool moveIn(project::ProjectText& text, const std::string& pointer, const core::Vec3& metres);

/// Turns a luminaire about the vertical through its own centre, or an object about the one through `center` (m);
/// anticlockwise seen from above. False where the entry has nothing to turn.
bool turnIn(project::ProjectText& text, const std::string& pointer, double degrees, const core::Vec3& center);

}  // namespace goniolux::gui
