// CandelaTable: the table of a file between reading and use: what every reader has to refuse or to warn of, whatever
// its format.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/diagnostics.h"
#include "photometry/intensity_distribution.h"

namespace goniolux::photometry {

struct CandelaTable {
  PhotometryType type = PhotometryType::c;
  std::vector<double> horizontal, vertical;  ///< degrees
  std::vector<double> candelas;              ///< as stored in the file: candelas[h * vertical.size() + v]
  double factor = 1;                         ///< makes candelas of them: multiplier, ballast factor, lamp flux / 1000
  core::SourcePosition horizontalAt, verticalAt, candelasAt;  ///< where each list begins
};

/// Refuses (InputError) a list of angles that is not strictly ascending or leaves [lowest, highest].
void checkAngles(const std::vector<double>& angles, const std::string& what, double lowest, double highest,
                 const core::SourcePosition& at);

/// Checks the whole table, warns of what looks wrong, and makes the distribution of it.
std::shared_ptr<const TabulatedDistribution> makeDistribution(CandelaTable table, core::Diagnostics& warnings);

/// "rotational", "quadrant", "C0-C180", "C90-C270", "none", "lateral".
std::string symmetryName(HorizontalSymmetry symmetry);

}  // namespace goniolux::photometry
