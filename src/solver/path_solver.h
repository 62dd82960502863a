// Spectral path tracing: unbiased, or ending in a light solution.
#pragma once

#include <memory>

#include "solver/solver.h"

namespace goniolux::solver {

/// Chooses the kernel compiled for the width that holds the quadrature's nodes (1, 4, 8, 16, 32, 96 or 480).
std::unique_ptr<Solver> makePathSolver(const Problem& problem);
/// The same for paths that end in a light solution, which is calculated first.
std::unique_ptr<Solver> makeGatherSolver(const Problem& problem);

}  // namespace goniolux::solver
