// Calculations: what the interface asks of the engine, as work for jobs. Nothing is calculated here: each is a call of
// the stages that the command line calls, on the text that is open.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/gui/jobs/job.h"
#include "pipeline/outline.h"
#include "pipeline/stage.h"
#include "project/project.h"
#include "project/results.h"

namespace goniolux::gui {

/// The project as it is open.
struct Source {
  std::string text, file;
};

struct GridsOutcome {
  std::shared_ptr<const project::Results> results;
  std::shared_ptr<const pipeline::Outline> outline;
  bool isFinal = false;
};

/// All grids. `deliver` gets what is known after each round, and at the end everything; it is called on the GUI thread.
Job::Work gridsWork(Source source, std::function<void(GridsOutcome)> deliver);

/// Results that an earlier run left beside the project, where they belong to this very text.
Job::Work earlierResultsWork(Source source, std::function<void(GridsOutcome)> deliver);

/// Writes results into a folder as `goniolux illuminate` does; `deliver` gets the paths.
Job::Work writeResultsWork(Source source, std::shared_ptr<const project::Results> results, std::string folder,
                           std::function<void(std::vector<std::string>)> deliver);

/// The report on a project that is saved as it is, as `goniolux report` makes it, into a .pdf or .html file: the
/// results are written first, and pictures that were rendered are made for a display.
Job::Work reportWork(Source source, std::shared_ptr<const project::Results> results, std::string file,
                     std::string language, std::function<void()> deliver);

/// A stage by its verb. `deliver` gets its report.
Job::Work stageWork(const std::string& verb, pipeline::StageRequest request,
                    std::function<void(const pipeline::StageReport&)> deliver);

/// "goniolux VERB …": the command that does the same.
QString commandLine(const std::string& verb, const pipeline::StageRequest& request);

}  // namespace goniolux::gui
