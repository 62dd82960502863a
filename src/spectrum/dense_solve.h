// Small dense linear systems.
#pragma once

#include <cstddef>
#include <vector>

namespace goniolux::spectrum {

/// Gaussian elimination with partial pivoting. `system` holds n rows of n coefficients with the right-hand side as last
/// column, which the solution replaces. False when the matrix is singular; the content is then spoilt.
bool solveDense(std::vector<double>& system, std::size_t n);

}  // namespace goniolux::spectrum
