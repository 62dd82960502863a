// Changes of a distribution that keep its candelas: planes written out all the way round, the whole turned about the
// aim, symmetry found again. Photometry type C only; degrees.
#pragma once

#include <memory>

#include "photometry/photometric_file.h"

namespace goniolux::photometry {

/// A table of planes from 0 to 360 (the last is the first again), as stated by the distribution's symmetry: each stated
/// candela stands at all its copies. Rotational distributions stay one plane.
struct PlaneTable {
  std::vector<double> planes;                 ///< ascending from 0; 360 included
  std::vector<std::vector<double>> candelas;  ///< per plane, at the distribution's vertical angles
};
PlaneTable allPlanes(const TabulatedDistribution& distribution);

/// The distribution of the smallest range of planes that gives the same values: planes that are equal up to the last
/// bit are left out where a symmetry restores them.
std::shared_ptr<const TabulatedDistribution> reduced(const PlaneTable& table, const std::vector<double>& vertical);

/// The same luminaire with its planes renamed: what was at C is at C + `degrees`. The opening goes along where the turn
/// is a multiple of 90 degrees, else it stays as stated (a warning says so).
PhotometricFile turned(const PhotometricFile& file, double degrees);

}  // namespace goniolux::photometry
