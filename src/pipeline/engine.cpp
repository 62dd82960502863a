#include "pipeline/engine.h"

#include <fmt/format.h>

#include <filesystem>

#include "pipeline/answerable.h"

namespace goniolux::pipeline {

project::Project readProjectFor(const StageRequest& request, AccuracyOf accuracy) {
  const CommonOptions& common = request.common;
  project::Overrides overrides;
  overrides.settings = common.set;
  const auto set = [&](const std::string& key, const std::string& value) {
    overrides.settings.push_back(key + "=" + value);
  };
  if (common.accuracy) {
    if (accuracy != AccuracyOf::images) set("accuracy.grid", *common.accuracy);
    if (accuracy != AccuracyOf::grids) set("accuracy.image", *common.accuracy);
  }
  if (common.solver) set("solver", *common.solver);
  if (common.spectral) set("spectral", *common.spectral);
  if (common.seed) set("seed", std::to_string(*common.seed));
  if (common.timeLimit_s) set("time_limit_s", fmt::format("{}", *common.timeLimit_s));
  overrides.scene = common.scene;
  if (request.projectText) return project::readProjectText(*request.projectText, request.inputs.at(0), overrides);
  return project::readProject(request.inputs.at(0), overrides);
}

std::string resultsFolder(const StageRequest& request, const project::Project& project) {
  if (request.common.output) return *request.common.output;
  return (std::filesystem::path(project.folder) / "results").string();
}

Engine::Engine(const project::Project& project, bool forColour)
    : hidden(hiddenLuminaires(project)),
      world((refuseWhatHasNoAnswer(project), scene::buildWorld(project.environment))),
      tracer(world),
      plan(planner::makePlan(project, world, forColour)),
      solver(solver::findSolverType(plan.solver)->make(problem())) {}

std::vector<std::string> leftOutSentences(const Engine& engine) {
  std::vector<std::string> sentences = engine.solver->leftOut();
  sentences.insert(sentences.end(), engine.hidden.begin(), engine.hidden.end());
  for (const planner::Omission& omission : engine.plan.leftOut) {
    if (omission.bound > 0)
      sentences.push_back(fmt::format("{}: at most {:.2g} {}", omission.what, omission.bound, omission.unit));
    else
      sentences.push_back(fmt::format("{}: {}", omission.what, omission.unit));
  }
  return sentences;
}

std::string programVersion() {
  return GONIOLUX_VERSION;
}

}  // namespace goniolux::pipeline
