// The section "settings" of a project, and the settings given on the command line.
#pragma once

#include <string>
#include <vector>

#include "core/document.h"
#include "project/project.h"
#include "project/reading.h"

namespace goniolux::project {

/// The settings of a project (`section` may be nullptr) with "KEY=VALUE" overrides laid over them, e.g.
/// "tree.cutoff=0.01".
Settings readSettings(const core::Value* section, const std::vector<std::string>& overrides, Reading& reading);

/// Every setting that changes results (not the time limit), as an object in the format's own words.
core::Value settingsDocument(const Settings& settings);

}  // namespace goniolux::project
