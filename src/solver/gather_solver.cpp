#include "solver/path_solver.h"

#include <stdexcept>

#include "solver/gather_kernel.h"

namespace goniolux::solver {

extern template class GatherSolver<1>;
extern template class GatherSolver<4>;
extern template class GatherSolver<8>;
extern template class GatherSolver<16>;
extern template class GatherSolver<32>;
extern template class GatherSolver<96>;
extern template class GatherSolver<480>;

std::unique_ptr<Solver> makeGatherSolver(const Problem& problem) {
  const std::size_t nodes = problem.quadrature.wavelengths.size();
  if (nodes <= 1) return std::make_unique<GatherSolver<1>>(problem);
  if (nodes <= 4) return std::make_unique<GatherSolver<4>>(problem);
  if (nodes <= 8) return std::make_unique<GatherSolver<8>>(problem);
  if (nodes <= 16) return std::make_unique<GatherSolver<16>>(problem);
  if (nodes <= 32) return std::make_unique<GatherSolver<32>>(problem);
  if (nodes <= 96) return std::make_unique<GatherSolver<96>>(problem);
  if (nodes <= 480) return std::make_unique<GatherSolver<480>>(problem);
  throw std::invalid_argument("at most 480 spectral samples");
}

}  // namespace goniolux::solver
