// The files of a results folder that `illuminate` writes: grids.json, summary.tsv, one CSV and one .vtp per grid, and
// the scene's outline.
#pragma once

#include <string>
#include <vector>

#include "pipeline/outline.h"
#include "project/results.h"

namespace goniolux::pipeline {

/// A grid's points with value, half-width and its parts, as a surface between the points (a list of points stays
/// points).
std::string gridVtp(const project::Results& results, const project::GridResult& grid);
/// The same as an unstructured grid (.vtu).
std::string gridVtu(const project::Results& results, const project::GridResult& grid);
/// The scene's edges and the luminaires' openings as lines.
std::string outlineVtp(const Outline& outline);

/// Writes grids.json, NAME.csv, NAME.vtp, outline.json and outline.vtp into the folder (made if need be; each file
/// replaced only when whole) and returns their paths. Throws core::RunError where the disk says no.
std::vector<std::string> writeResultFiles(const std::string& folder, const project::Results& results,
                                          const Outline& outline);

}  // namespace goniolux::pipeline
