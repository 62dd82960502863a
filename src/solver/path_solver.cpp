#include "solver/path_solver.h"

#include <stdexcept>

#include "solver/path_kernel.h"

namespace goniolux::solver {

extern template class PathSolver<1>;
extern template class PathSolver<4>;
extern template class PathSolver<8>;
extern template class PathSolver<16>;
extern template class PathSolver<32>;
extern template class PathSolver<96>;
extern template class PathSolver<480>;

std::unique_ptr<Solver> makePathSolver(const Problem& problem) {
  const std::size_t nodes = problem.quadrature.wavelengths.size();
  if (nodes <= 1) return std::make_unique<PathSolver<1>>(problem);
  if (nodes <= 4) return std::make_unique<PathSolver<4>>(problem);
  if (nodes <= 8) return std::make_unique<PathSolver<8>>(problem);
  if (nodes <= 16) return std::make_unique<PathSolver<16>>(problem);
  if (nodes <= 32) return std::make_unique<PathSolver<32>>(problem);
  if (nodes <= 96) return std::make_unique<PathSolver<96>>(problem);
  if (nodes <= 480) return std::make_unique<PathSolver<480>>(problem);
  throw std::invalid_argument("at most 480 spectral samples");
}

}  // namespace goniolux::solver
