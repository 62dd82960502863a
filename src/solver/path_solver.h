// Unbiased spectral path tracing.
#pragma once

#include <memory>

#include "solver/solver.h"

namespace goniolux::solver {

/// Chooses the kernel compiled for the width that holds the quadrature's nodes (1, 4, 8, 16, 32, 96 or 480).
std::unique_ptr<Solver> makePathSolver(const Problem& problem);

}  // namespace goniolux::solver
