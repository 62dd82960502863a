// What the report shows, gathered from a results folder and the project that it came from.
#pragma once

#include <optional>
#include <string>

#include "core/diagnostics.h"
#include "pipeline/outline.h"
#include "project/project.h"
#include "report/report.h"

namespace goniolux::pipeline {

/// Luminaires by the project's entries, with what their photometric files say.
std::vector<report::LuminaireType> luminaireTypes(const project::Project& project, core::Diagnostics& warnings);

/// Reflectances of the rooms' surfaces.
std::vector<report::Surface> roomSurfaces(const project::Project& project);

/// Plan area of the rooms: half of their faces' area as seen from above, which is the floor's where floor and ceiling
/// cover each other. Nothing when a room is not made of flat faces.
std::optional<double> floorArea(const project::Project& project);

/// The scene from above with the letters of the luminaires' entries.
report::Plan planOf(const Outline& outline, const project::Results& results,
                    const std::vector<report::LuminaireType>& types);

/// A sentence for each input that is not what the results were made from.
std::vector<std::string> staleInputs(const project::Results& results, const project::Project& project);

/// What each group of luminaires gives to each grid, from what `scenes` kept beside the results; empty where it kept
/// nothing, or what it kept does not add up to these results.
std::vector<report::Contribution> contributionsOf(const project::Results& results, const project::Project& project,
                                                  const std::string& resultsFolder);

/// The chart that `study` left in the project's folder.
std::optional<report::Picture> speedChartOf(const project::Project& project);

/// The grid's map in the reader's units and language; nothing, and a warning, when it cannot be drawn.
std::optional<report::Picture> gridMap(const project::Results& results, std::size_t grid, const Outline* outline,
                                       report::Language language, report::Units units, core::Diagnostics& warnings);

}  // namespace goniolux::pipeline
