// How far two images of the same size are apart, in luminance and in colour.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "image/xyz_image.h"
#include "spectrum/colorimetry.h"

namespace goniolux::image {

struct Comparison {
  std::size_t pixels = 0;                            ///< that are numbers in both
  double meanLuminance = 0;                          ///< of the first image, cd/m2
  double luminanceRmse = 0;                          ///< cd/m2
  double luminanceBias = 0;                          ///< mean of second - first, cd/m2
  double largestDifference = 0;                      ///< of luminance, cd/m2, without sign
  double deltaMean = 0, deltaP95 = 0, deltaMax = 0;  ///< CIEDE2000
  std::optional<double> within;  ///< share of pixels whose luminances differ by no more than both half-widths together
                                 ///< (in squares); nothing unless both images have half-widths
  std::vector<float> delta;      ///< CIEDE2000 of every pixel; NaN where one is no number
};

/// `white`: tristimulus values, cd/m2, that CIELAB takes as the white of both images. Sizes must be equal.
Comparison compare(const XyzImage& first, const XyzImage& second, const spectrum::Xyz& white);

/// second - first, pixel by pixel: X, Y, Z.
XyzImage difference(const XyzImage& first, const XyzImage& second);

}  // namespace goniolux::image
