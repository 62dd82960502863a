// What a tree is evaluated with: the finishes of a world as local shadings, and its lamps' spectra.
#pragma once

#include "solver/intersection_tree.h"
#include "solver/solver.h"

namespace goniolux::solver {

/// One for each of World::materials, or all by the model that the settings force.
Shadings makeShadings(const scene::World& world, const spectrum::SpectralQuadrature& quadrature,
                      const TreeSettings& settings);
TreeLighting treeLighting(const scene::World& world, const spectrum::SpectralQuadrature& quadrature,
                          const TreeSettings& settings);

}  // namespace goniolux::solver
