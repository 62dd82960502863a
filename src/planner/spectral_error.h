// How far a spectral quadrature is from a 1 nm calculation, on the light paths that a scene can have: one and two
// reflections on its own finishes, from its own sources.
#pragma once

#include <vector>

#include "spectrum/spectral_quadrature.h"

namespace goniolux::planner {

struct SpectralError {
  double luminance = 0;  ///< largest |Y - Y_1nm| / Y of the unreflected light
  double colour = 0;     ///< largest CIEDE2000 against 1 nm, the unreflected light as white
};

/// Sources are relative spectral powers; reflectances those of all finishes. Cost grows with sources x finishes^2.
SpectralError spectralError(const spectrum::SpectralQuadrature& quadrature,
                            const std::vector<spectrum::SpectralDistribution>& sources,
                            const std::vector<spectrum::SpectralDistribution>& reflectances);

}  // namespace goniolux::planner
