// Plan: what the asked accuracy needs and what it does not: which solver, how many wavelengths, what is left out and
// how much that can matter. A scene gets no more than it needs: grey finishes travel on one spectral sample.
#pragma once

#include <string>
#include <vector>

#include "core/document.h"
#include "project/project.h"
#include "scene/world.h"
#include "solver/solver.h"
#include "spectrum/spectral_quadrature.h"

namespace goniolux::planner {

struct Omission {
  std::string what;
  double bound = 0;  ///< in `unit`, of the asked quantity
  std::string unit;
};

struct Plan {
  std::string solver;
  spectrum::SpectralQuadrature quadrature;
  double accuracy = 0.01;     ///< relative, the finest that is asked of what will be calculated
  solver::TreeSettings tree;  ///< for the solver `tree`
  double spectralBound = 0;   ///< largest relative error of an illuminance over the likely light paths
  double melanopicBound = 0;  ///< the same of a melanopic quantity
  double colourBound = 0;     ///< largest CIEDE2000 over them
  std::vector<Omission> leftOut;
  std::vector<std::string> reasons;
};

/// `forColour`: pictures are wanted (all of X, Y, Z), not only photometric quantities. Throws core::InputError for a
/// solver or scheme that does not exist.
Plan makePlan(const project::Project& project, const scene::World& world, bool forColour);

/// "settings_used" of the results and the heart of `plan --json`.
core::Value toJson(const Plan& plan, const project::Project& project);

}  // namespace goniolux::planner
