#include <algorithm>

#include "solver/path_solver.h"
#include "solver/solver.h"
#include "solver/tree_solver.h"

namespace goniolux::solver {

const std::vector<SolverType>& solverTypes() {
  static const std::vector<SolverType> types = {
      {"path", "Unbiased spectral path tracing",
       "closed-form direct light, next-event estimation, planar mirrors by images; no bias, only noise",
       makePathSolver},
      {"gather", "Final gathering from a light solution",
       "closed-form direct light; paths end in a view-independent solution of the interreflection, whose error is "
       "measured by paths that go on, and taken away",
       makeGatherSolver},
      {"tree", "The paper's intersection tree",
       "one tree of reflected and refracted rays a sample, adaptive depth, phong, whitted and hall; interreflection by "
       "an "
       "ambient term only",
       makeTreeSolver},
  };
  return types;
}

const SolverType* findSolverType(const std::string& name) {
  const auto& types = solverTypes();
  const auto found = std::find_if(types.begin(), types.end(), [&](const SolverType& t) { return t.name == name; });
  return found == types.end() ? nullptr : &*found;
}

}  // namespace goniolux::solver
