// Light from the lamps of a modelled luminaire through its reflectors, by the project's tracer, into a table of
// candelas.
#pragma once

#include <memory>

#include "photometry/intensity_distribution.h"
#include "traced_luminaires/fixture.h"

namespace goniolux::traced {

struct TracedLight {
  std::shared_ptr<const photometry::TabulatedDistribution> distribution;  ///< cd
  double outputRatio = 0;                                                 ///< flux that leaves over lamp flux
  double averageHits = 0;                                                 ///< of surfaces per ray
  /// Largest relative standard error of a value of the table that is above a tenth of the largest one, from sixteen
  /// parts of the rays.
  double noise = 0;
};

/// 2^`logRays` rays, the same on every machine that computes alike and for any number of threads. A direction counts
/// for the table angle whose neighbourhood it falls into, and for every copy that the symmetry of the table makes of
/// it; the table is scaled so that its exact flux is the flux that left.
TracedLight trace(const Fixture& fixture, int logRays);

}  // namespace goniolux::traced
