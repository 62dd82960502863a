// Mixing images by superposition: light adds up, so an image is the sum of those of its luminaire groups.
#pragma once

#include <vector>

#include "image/xyz_image.h"

namespace goniolux::image {

/// Attribute: X, Y, Z flux of all sources that made the image, "X Y Z" with Y in lumens; what an adopted white is made
/// of.
inline constexpr const char* sourceFluxAttribute = "sourceFlux";

struct MixPart {
  const XyzImage* image = nullptr;
  double level = 1;
};

/// Sum of level times image; all of one size (asserted), at least one. Statistical half-widths are independent and add
/// in squares, systematic ones add up; those of chromaticity follow from both. Spectral channels that all have are
/// added. Attributes: those that all images share, and a new adopted white where all name their source flux.
XyzImage mixed(const std::vector<MixPart>& parts);

}  // namespace goniolux::image
