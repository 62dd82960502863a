// Glare from an image: luminous sources found in a picture of the field of view, UGR and DGP of them.
//
// UGR (CIE 117) is for electric light indoors. DGP is Wienold and Christoffersen's daylight glare probability (Energy
// and Buildings 38(7), 2006), fitted to observers in daylit offices, for vertical illuminances from some hundred lx:
// for electric light it is no more than a number for comparison. Both count what the image sees: of less than a
// hemisphere, the illuminance is that part's.
#pragma once

#include <vector>

#include "core/vector.h"
#include "image/xyz_image.h"
#include "scene/view.h"

namespace goniolux::analysis {

struct ImageSource {
  double luminance_cd_m2 = 0;  ///< mean over its solid angle
  double solidAngle_sr = 0;
  core::Vec3 direction{0};  ///< to its luminance-weighted middle, unit
  double positionIndex = 1;
  int column = 0, row = 0;  ///< of that middle
  std::size_t pixels = 0;
};

struct ImageGlare {
  std::vector<ImageSource> sources;  ///< by falling L^2 omega / P^2
  double threshold_cd_m2 = 0;
  double verticalIlluminance_lx = 0;  ///< at the eye, on the plane across the line of sight
  double background_cd_m2 = 0;        ///< (illuminance - that of the sources) / pi
  double solidAngle_sr = 0;           ///< that the image sees
  double ugr = 0, dgp = 0;            ///< ugr: 0 without sources
};

/// Pixels brighter than the threshold that touch each other (also by a corner) are one source. The view is the image's
/// (perspective or fisheye; asserted).
ImageGlare glareOf(const image::XyzImage& image, const scene::View& view, double threshold_cd_m2);

/// Solid angle of a pixel, sr; 0 outside a fisheye's circle.
double solidAngleOf(const scene::View& view, int column, int row);

/// Guth's index above the line of sight, Iwata and Tokura's below it (1 + 0.8 R/D up to R/D = 0.6, 1 + 1.2 R/D beyond).
double positionIndexAround(const core::Vec3& forward, const core::Vec3& up, const core::Vec3& toSource);

}  // namespace goniolux::analysis
