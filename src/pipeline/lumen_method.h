// The lumen method: how many luminaires a rectangular room needs for a mean illuminance, and how they stand.
//
// Direct flux by the inverse-square law from each luminaire, interreflection between ceiling, walls and the floor
// cavity as three diffuse surfaces. A start for a layout, not a result: `goniolux illuminate` calculates the room.
#pragma once

#include "photometry/intensity_distribution.h"

namespace goniolux::pipeline {

struct RoomForLayout {
  double length = 0, width = 0, height = 0;        ///< m; length along x
  double ceiling = 0.7, walls = 0.5, floor = 0.2;  ///< reflectances
  double workPlane = 0.8;                          ///< m above the floor
  double mounting = 0;                             ///< m above the floor, of the luminaires' centres
  double maintenance = 0.8;
  double flux_lm = 0;  ///< of one luminaire
};

struct Layout {
  int along = 1, across = 1;      ///< luminaires along length and width; half a step from the walls
  double utilisation = 0;         ///< flux that reaches the work plane over flux of the luminaires
  double meanIlluminance_lx = 0;  ///< maintained
  double roomIndex = 0;           ///< L W / (h (L + W)), h from work plane to luminaires
  double spacingToHeight = 0;     ///< the larger step over h
};

/// What `along` x `across` luminaires with the given distribution (aim down, c0 along the length) give.
Layout lumenMethod(const RoomForLayout& room, const photometry::IntensityDistribution& distribution, int along,
                   int across);

/// The fewest luminaires that reach `target_lx`, in rows whose steps differ by less than 1.6 times where possible, and
/// stand no farther apart than 1.5 times their height above the work plane. At most 10 000 luminaires.
Layout layoutFor(const RoomForLayout& room, const photometry::IntensityDistribution& distribution, double target_lx);

/// Form factor between two equal, opposite rectangles a x b at the distance c. — Howell, A Catalog of Radiation Heat
/// Transfer Configuration Factors, C-11
double oppositeRectangles(double a, double b, double c);

}  // namespace goniolux::pipeline
