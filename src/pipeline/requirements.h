// Requirements: limits of a project held against intervals: pass, fail, or undecided when the limit lies inside the
// interval.
#pragma once

#include <vector>

#include "project/project.h"
#include "project/results.h"

namespace goniolux::pipeline {

std::vector<project::RequirementResult> judge(const project::Project& project, const project::Results& results);
bool anyFailed(const project::Results& results);

}  // namespace goniolux::pipeline
