// The stage `plot`: pictures of the results, drawn by the helper program goniolux-plot. Where drawing is not possible,
// the stage says so in a warning and the data stay.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/diagnostics.h"
#include "pipeline/outline.h"
#include "pipeline/plan_map.h"
#include "project/results.h"

namespace goniolux::pipeline {

struct PlotRequest {
  std::string folder;  ///< where pictures go (made if need be)
  std::vector<std::string> formats{"png", "svg"};
  std::string grid;  ///< only this one; "" = all
  MapOptions map;
};

struct PlotOutcome {
  std::vector<std::string> pictures, figures;  ///< paths of what was written
  core::Diagnostics warnings;
};

/// Writes NAME.figure.json for each grid and has it drawn as NAME.png and NAME.svg. Throws core::RunError where the
/// disk says no.
PlotOutcome drawPlots(const project::Results& results, const Outline* outline, const PlotRequest& request);

/// Has the helper program draw a figure's file as each of the pictures. A sentence why when it did not, "" when it did.
std::string drawFigure(const std::string& figure, const std::vector<std::string>& pictures);

/// The outline beside the results, if there is one that belongs to them; `warnings` says why not.
std::optional<Outline> outlineFor(const project::Results& results, const std::string& folder,
                                  core::Diagnostics& warnings);

}  // namespace goniolux::pipeline
