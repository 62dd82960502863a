// Engine: a project made ready to calculate: its world, tracer, plan and solver. The stages that calculate share it.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "pipeline/stage.h"
#include "planner/plan.h"
#include "project/project.h"
#include "scene/world.h"
#include "solver/solver.h"
#include "tracer/tracer.h"

namespace goniolux::pipeline {

/// Which accuracy `--accuracy` sets.
enum class AccuracyOf { grids, images, both };

/// The project named by the request (its text, where the request brings one) with the command line's overrides applied.
/// Throws core::InputError.
project::Project readProjectFor(const StageRequest& request, AccuracyOf accuracy);
/// Where the results go: -o, else "results" in the project's folder.
std::string resultsFolder(const StageRequest& request, const project::Project& project);

struct Engine {
  /// Throws core::InputError for projects that have no answer (pipeline/answerable.h) and for settings that do not fit.
  Engine(const project::Project& project, bool forColour);

  [[nodiscard]] solver::Problem problem() const { return {world, tracer, plan.quadrature, plan.accuracy, plan.tree}; }

  std::vector<std::string> hidden;  ///< sentences: luminaires that a closed object shuts in
  scene::World world;
  tracer::Tracer tracer;
  planner::Plan plan;
  std::unique_ptr<solver::Solver> solver;
};

/// What was left out, as sentences for the results.
std::vector<std::string> leftOutSentences(const Engine& engine);
/// The plan as `plan --json` gives it, without the forecast: what will be done, why, and what is left out.
core::Value planDocument(const project::Project& project, const Engine& engine);
/// The version of this program.
std::string programVersion();

}  // namespace goniolux::pipeline
