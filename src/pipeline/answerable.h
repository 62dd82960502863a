// Answerable: refuses projects to which there is no answer, before anything is calculated. What is merely doubtful is a
// warning of `check`; here stands what makes the numbers a matter of chance:
//
// - surfaces of different finishes in one place (the light meets the one or the other),
// - open bodies of glass (they have no inside, so that light cannot be refracted).
#pragma once

#include <string>
#include <vector>

#include "project/project.h"

namespace goniolux::pipeline {

/// Throws core::InputError with all that is found, at the places in the project file.
void refuseWhatHasNoAnswer(const project::Project& project);

/// Sentences for the results: luminaires whose centre lies inside a closed object, so that their light does not come
/// out.
std::vector<std::string> hiddenLuminaires(const project::Project& project);

}  // namespace goniolux::pipeline
