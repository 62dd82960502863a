// Mixing images by superposition: light adds up, so an image is the sum of those of its luminaire groups.
#pragma once

#include <optional>
#include <string>
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
/// Layers that all have are mixed like the image.
XyzImage mixed(const std::vector<MixPart>& parts);

/// A layer of an image as an image of its own, or nothing where it has none of this name. Its half-widths are those of
/// luminance.
std::optional<XyzImage> layerOf(const XyzImage& image, const std::string& name);

}  // namespace goniolux::image
