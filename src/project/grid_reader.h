// The sections "grids", "observers" and "requirements" of a project: what is measured, and what is required of it.
#pragma once

#include <vector>

#include "analysis/grid.h"
#include "core/document.h"
#include "project/reading.h"

namespace goniolux::project {

/// Points of a regular grid are cell centres; values run u fastest.
std::vector<analysis::Grid> readGrids(const core::Value& section, Reading& reading);
std::vector<analysis::Observer> readObservers(const core::Value& section, Reading& reading);
/// `grids` and `observers`: names that requirements may refer to (also those of entries that were refused).
std::vector<analysis::Requirement> readRequirements(const core::Value& section, const std::vector<std::string>& grids,
                                                    const std::vector<std::string>& observers, Reading& reading);

/// The "name" texts of a list of sections, good or not, so that a refused entry raises no second error where it is
/// named.
std::vector<std::string> namesIn(const core::Value* section);

}  // namespace goniolux::project
