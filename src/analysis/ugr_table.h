// The UGR table of a luminaire (tabular method of CIE 117 and CIE 190): nineteen rooms in units of H, the height of the
// luminaires above the eye, five sets of reflectances, viewed across and along C90.
//
// Luminaires stand on a square grid of 0.25 H over the whole room. The observer looks horizontally from the middle of a
// wall, X is the room's extent across the view, Y along it. Background: the mean indirect illuminance of the walls over
// pi, by the three-surface exchange of the cavity between luminaires and eye. Position index: Guth's formula;
// luminaires beyond its table (H/R above 1.9, T/R above 3) do not count, as in CIE 190. UGR does not depend on H.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "analysis/utilisation.h"
#include "photometry/intensity_distribution.h"

namespace goniolux::analysis {

/// A luminaire as a glare source; the projected area of its opening by a box about it (length along C0, width along
/// C90).
struct GlareSource {
  const photometry::IntensityDistribution* distribution = nullptr;
  core::Vec3 extent{0};  ///< m: along C0, C90 and the aim
  bool round = false;    ///< elliptical instead of rectangular
  [[nodiscard]] double projectedArea(const core::Vec3& local) const;
};

/// Sum of L^2 omega / p^2 over luminaires that look straight down on a rectangular grid. The observer's eye is the
/// origin, the line of sight +y, up +z; `c0` is the direction of the C0 plane in the plane of x and y.
struct GlareGrid {
  int across = 0, along = 0;
  double firstAcross = 0, firstAlong = 0, step = 0, height = 0;  ///< m, of the first luminaire; across = x
  core::Vec3 c0{1, 0, 0};
};
double glareSum(const GlareSource& source, const GlareGrid& grid, bool fieldLimits);

/// UGR = 8 log10(0.25 / Lb * sum).
double ugr(double glareSum, double backgroundLuminance);

struct UgrTable {
  static constexpr std::array<std::array<int, 2>, 19> rooms{{{2, 2},
                                                             {2, 3},
                                                             {2, 4},
                                                             {2, 6},
                                                             {2, 8},
                                                             {2, 12},
                                                             {4, 2},
                                                             {4, 3},
                                                             {4, 4},
                                                             {4, 6},
                                                             {4, 8},
                                                             {4, 12},
                                                             {8, 4},
                                                             {8, 6},
                                                             {8, 8},
                                                             {8, 12},
                                                             {12, 4},
                                                             {12, 6},
                                                             {12, 8}}};
  static constexpr std::array<CavityReflectances, 5> reflectances{
      {{.7, .5, .2}, {.7, .3, .2}, {.5, .5, .2}, {.5, .3, .2}, {.3, .3, .2}}};
  /// [room][reflectances]
  std::array<std::array<double, 5>, 19> crosswise{}, endwise{};
};

/// Nothing where the opening has no area or the luminaire gives no light. Crosswise: the line of sight lies in the
/// plane C0-C180 (at right angles to lamps that lie along C90); endwise: in C90-C270.
std::optional<UgrTable> ugrTable(const GlareSource& source);

}  // namespace goniolux::analysis
