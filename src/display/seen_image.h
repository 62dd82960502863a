// The image as the eye sees it: veiled by glare, less sharp and less coloured in the dark — Ward Larson, Rushmeier and
// Piatko, A visibility matching tone reproduction operator, IEEE TVCG 3(4), 1997.
#pragma once

#include <vector>

#include "image/xyz_image.h"

namespace goniolux::display {

/// The image averaged over squares of about a degree: what the fovea adapts to, one fixation each.
struct FovealImage {
  int width = 0, height = 0;
  double degreesPerPixel = 1;  ///< of this image
  std::vector<double> x, y, z;
};
FovealImage fovealImage(const image::XyzImage& image, double degreesAcross);

/// Width of the view in degrees, from the image's view attribute; 60 where it has none.
double degreesAcross(const image::XyzImage& image);

/// Veiling luminance in each foveal direction: Moon and Spencer's 0.087 sum of L cos(theta) / theta^2 over the others
/// (theta in radians, weighted by solid angle so that a uniform field veils itself by 8.7 %); added to X, Y, Z as
/// 0.913 of the pixel and the veil.
void addVeil(image::XyzImage& image, FovealImage& foveal);
/// Rods see no colour: below 5.6 cd/m2 colours fade towards the scotopic grey, below 0.0056 cd/m2 none is left.
void fadeColours(image::XyzImage& image, const FovealImage& foveal);
/// Blurs what is finer than the eye resolves at the local adaptation.
void blurToAcuity(image::XyzImage& image, const FovealImage& foveal);

}  // namespace goniolux::display
