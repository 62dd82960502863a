// Results for other programs: a spreadsheet, or unstructured grids for ParaView.
#pragma once

#include <string>

#include "pipeline/stage.h"

namespace goniolux::pipeline {

/// Is this a form of results, and not of the scene?
bool isResultsFormat(const std::string& format);

/// `export RESULTS --to ods|vtu`: RESULTS is a results folder, its grids.json, or a project whose results/ are meant.
/// Throws core::InputError where there are no results, core::RunError where the disk says no.
StageReport exportResults(const StageRequest& request, const std::string& format);

}  // namespace goniolux::pipeline
