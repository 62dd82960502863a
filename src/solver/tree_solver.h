// The solver `tree`: the paper's ray tracing with one intersection tree per sample (intersection_tree.h), local shading
// by the paper's reflection models or by BSDFs, depth control, and the ambient term in place of interreflection.
#pragma once

#include <memory>

#include "solver/solver.h"

namespace goniolux::solver {

std::unique_ptr<Solver> makeTreeSolver(const Problem& problem);

}  // namespace goniolux::solver
