// Illuminate: grids and observers of a project to results (the paper's third step, asked at points).
#pragma once

#include <functional>

#include "core/kept_work.h"
#include "pipeline/engine.h"
#include "project/results.h"

namespace goniolux::pipeline {

/// Sees a grid as it is known after each round, while the work goes on; called from the thread that calculates.
using GridResultObserver = std::function<void(const project::GridResult&)>;

/// Calculates every grid of the project to the accuracy asked for. A run that is cancelled or out of time keeps what it
/// has and says so in Results::reachedText. Finished work goes to `keeping`, and what is there is not done anew.
project::Results calculateGrids(const project::Project& project, const Engine& engine, core::ProgressSink& progress,
                                const GridResultObserver& partial = {}, const core::Keeping& keeping = {});

/// Writes grids.json, a CSV and a .vtp per grid, and outline.json into the folder; returns the paths.
std::vector<std::string> writeResults(const project::Project& project, const project::Results& results,
                                      const std::string& folder);

/// The table that a person reads on a terminal.
std::string resultsText(const project::Results& results);

}  // namespace goniolux::pipeline
