// The ladder of settings of a study.
#include <algorithm>
#include <cmath>

#include "core/text.h"
#include "emitter/near_field.h"
#include "photometry/intensity_distribution.h"
#include "pipeline/study.h"

namespace goniolux::pipeline {
namespace {

constexpr double gridLadder[] = {0.1, 0.05, 0.02, 0.01, 0.005};
constexpr double pictureLadder[] = {0.2, 0.1, 0.05, 0.02};
constexpr const char* fewWavelengths[] = {"xyz:3", "uniform:3", "uniform:9", "uniform:31"};
constexpr double changesAfter = 0.02;    // the rung that they follow
constexpr double changeAccuracy = 0.01;  // of grids: what few wavelengths and points spoil shows above it
constexpr double treeAccuracy = 0.05;    // its error does not depend on it

/// Has a size, and an intensity distribution that a point can have: uniform luminance over an opening has none, but for
/// a ball's.
bool canBeCut(const scene::Luminaire& luminaire) {
  return emitter::largestExtent(luminaire.opening) > 0 &&
         (luminaire.distribution || luminaire.opening.shape == emitter::Opening::Shape::sphere);
}

bool hasOpenings(const project::Project& project) {
  return std::any_of(project.environment.luminaires.begin(), project.environment.luminaires.end(), canBeCut);
}

/// The luminaire as n x n points of equal flux.
void addPoints(const scene::Luminaire& luminaire, int n, std::vector<scene::Luminaire>& to) {
  scene::Luminaire point = luminaire;
  if (!luminaire.distribution) {  // a ball of uniform luminance
    point.distribution = photometry::CosinePowerDistribution::isotropic(luminaire.flux_lm / (4 * core::pi));
    point.scale = 1;
  }
  point.opening = {};
  point.scale /= n * n;
  point.flux_lm /= n * n;
  for (const core::Vec3& place : emitter::cutPlaces(luminaire.opening, luminaire.frame, n)) {
    point.center = luminaire.center + place;
    to.push_back(point);
  }
}

std::vector<StudySetting> pictureSettings(const project::Project& project, const planner::Plan& plan) {
  const double asked = project.settings.accuracy.image;
  // A tree's line is its depths.
  const std::string line = plan.solver == "tree" ? "tree, depth" : plan.solver;
  std::vector<StudySetting> settings{{line, plan.solver, asked, "auto", true, "", 1 / (asked * asked)}};
  const auto add = [&](const StudySetting& setting) {
    const StudySetting& chosen = settings.front();
    if (setting.accuracy != chosen.accuracy || setting.line != chosen.line || !setting.change.empty())
      settings.push_back(setting);
  };
  for (const double accuracy : pictureLadder) {
    for (const solver::SolverType& type : solver::solverTypes())
      if (type.name != "tree") add({type.name, type.name, accuracy, "auto", true, "", 1 / (accuracy * accuracy)});
    if (accuracy != pictureLadder[0]) continue;
    for (const int depth : {1, 2, 3, 5, 15})
      add({"tree, depth", "tree", treeAccuracy, "auto", true, "tree.max_depth=" + std::to_string(depth)});
    for (const char* cutoff : {"0.5", "0.1", "0.02"})
      add({"tree, cut-off", "tree", treeAccuracy, "auto", true, std::string("tree.cutoff=") + cutoff});
    // So fine that the samples of a pixel end it.
    for (const int samples : {16, 64, 256})
      add({"samples of a pixel", plan.solver, 1e-4, "auto", true, "pixel.max_samples=" + std::to_string(samples),
           static_cast<double>(samples)});
    if (plan.quadrature.wavelengths.size() > 1)
      for (const char* scheme : fewWavelengths) add({"wavelengths", plan.solver, 0.05, scheme, true});
  }
  return settings;
}

}  // namespace

project::Project changed(project::Project project, const std::string& change) {
  const auto equals = change.find('=');
  if (equals == std::string::npos) return project;
  const std::string key = change.substr(0, equals);
  const double value = core::parseNumber(change.substr(equals + 1)).value_or(1);
  if (key == "tree.max_depth") project.settings.treeMaxDepth = static_cast<int>(value);
  if (key == "tree.cutoff") project.settings.treeCutoff = value;
  if (key == "pixel.max_samples") {
    project.settings.pixelMaxSamples = static_cast<int>(value);
    project.settings.pixelMinSamples = static_cast<int>(value);
    project.settings.pixelContrast = 1;
  }
  if (key == "luminaire.points") {
    std::vector<scene::Luminaire> points;
    for (const scene::Luminaire& luminaire : project.environment.luminaires) {
      if (canBeCut(luminaire))
        addPoints(luminaire, static_cast<int>(value), points);
      else
        points.push_back(luminaire);
    }
    project.environment.luminaires = std::move(points);
  }
  return project;
}

project::Project withSetting(const project::Project& project, const StudySetting& setting, std::uint64_t seed,
                             double seconds) {
  project::Project own = changed(project, setting.change);
  own.settings.solver = setting.solver;
  own.settings.seed = seed;
  own.settings.timeLimit_s = seconds;
  if (setting.spectral != "auto") {
    const auto colon = setting.spectral.find(':');
    own.settings.spectralScheme = setting.spectral.substr(0, colon);
    own.settings.spectralSamples = colon == std::string::npos ? 0 : std::stoi(setting.spectral.substr(colon + 1));
  }
  return own;
}

std::vector<StudySetting> studySettings(const project::Project& project, const planner::Plan& plan, bool ofPicture) {
  if (ofPicture) return pictureSettings(project, plan);
  const double asked = project.settings.accuracy.grid;
  std::vector<StudySetting> settings{{plan.solver, plan.solver, asked, "auto", false, "", 1 / (asked * asked)}};
  for (const double accuracy : gridLadder) {
    for (const solver::SolverType& type : solver::solverTypes()) {
      if (type.name == "tree" && accuracy != treeAccuracy) continue;
      if (type.name != plan.solver || accuracy != asked)
        settings.push_back({type.name, type.name, accuracy, "auto", false, "", 1 / (accuracy * accuracy)});
    }
    if (accuracy != changesAfter) continue;
    if (hasOpenings(project))
      for (const int n : {1, 2, 4})
        settings.push_back({"luminaires as points", plan.solver, changeAccuracy, "auto", false,
                            "luminaire.points=" + std::to_string(n)});
    if (plan.quadrature.wavelengths.size() > 1)
      for (const char* scheme : fewWavelengths)
        settings.push_back({"wavelengths", plan.solver, changeAccuracy, scheme, false});
  }
  return settings;
}

}  // namespace goniolux::pipeline
