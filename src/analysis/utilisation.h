// Utilisation factors of a luminaire: what part of the lamps' flux arrives on the work plane of an empty room with
// evenly spread luminaires. Room: the cavity between the plane of the luminaires and the work plane; diffuse ceiling
// (or effective ceiling cavity), walls, and floor (effective floor cavity), each with one reflectance and uniform
// exitance.
#pragma once

#include <array>
#include <vector>

#include "photometry/intensity_distribution.h"

namespace goniolux::analysis {

struct CavityReflectances {
  double ceiling = 0, walls = 0, floor = 0;
};

/// The cavity's proportions: length and width over its height.
struct Cavity {
  double length = 1, width = 1;  ///< in heights
  /// Room index k = L W / (h (L + W)); room cavity ratio = 5 / k.
  [[nodiscard]] double roomIndex() const { return length * width / (length + width); }
  static Cavity square(double roomIndex) { return {2 * roomIndex, 2 * roomIndex}; }
};

/// Form factor from floor to ceiling, exact (parallel equal rectangles; Howell's catalogue C-11).
double floorToCeiling(const Cavity& cavity);

/// The part of the downward flux that falls on the work plane itself: a ray (C, gamma) of luminaires spread evenly over
/// the whole ceiling plane meets it with the chance max(0, 1 - |tan(gamma) cos C| / L) max(0, 1 - |tan(gamma) sin C| /
/// W). C0 lies along the length.
double directRatio(const photometry::IntensityDistribution& distribution, const Cavity& cavity);

/// The IES zonal multipliers, exp(-A RCR^B) for nine zones of 10 degrees, over the zonal lumens (IES Lighting Handbook,
/// zonal-cavity method: constants by Levin): an engineering approximation of the direct ratio.
double zonalDirectRatio(const std::array<double, 18>& zonalLumens, double roomCavityRatio);

/// Flux incident on ceiling, walls and floor in units of the flux that first arrives there (three-surface exchange).
struct CavityFlux {
  double ceiling = 0, walls = 0, floor = 0;
};
CavityFlux exchange(const CavityFlux& first, double formFactor, double wallArea,
                    const CavityReflectances& reflectances);

/// Flux on the work plane over `lampFlux`.
double utilisationFactor(double upwardFlux, double downwardFlux, double lampFlux, double directRatio,
                         const Cavity& cavity, const CavityReflectances& reflectances);

/// A table: a row per room, a column per set of reflectances.
struct UtilisationTable {
  std::vector<double> rooms;  ///< room index or room cavity ratio
  std::vector<CavityReflectances> reflectances;
  std::vector<std::vector<double>> factors;  ///< [room][reflectances]
};

/// Room index 0.6 to 5 (the indices of CIE 40 and EN 13032-2), square rooms, direct ratio by integration.
UtilisationTable roomIndexTable(const photometry::TabulatedDistribution& distribution, double lampFlux);
/// Coefficients of utilisation for room cavity ratio 0 to 10 (IES zonal-cavity method), effective floor cavity 20 %.
UtilisationTable zonalCavityTable(const photometry::TabulatedDistribution& distribution, double lampFlux);

/// The largest spacing over mounting height at which the illuminance stays even, by the two tests of the IES: midway
/// between two luminaires it equals that under one (along C0-C180 and along C90-C270), and amid four, of which each
/// then gives a quarter (along the diagonal). Direct light only, point sources. 0 where a luminaire gives no light
/// straight down.
struct SpacingCriterion {
  double c0 = 0, c90 = 0, diagonal = 0;
};
SpacingCriterion spacingCriterion(const photometry::IntensityDistribution& distribution);

}  // namespace goniolux::analysis
