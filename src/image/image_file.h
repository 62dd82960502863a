// Image files of any kind that carry luminance: recognised by their first bytes.
#pragma once

#include <string>
#include <string_view>

#include "image/xyz_image.h"

namespace goniolux::image {

/// OpenEXR (X, Y, Z or R, G, B) and Radiance pictures (XYZE or RGBE). Throws core::InputError: what the file is not, or
/// where it is damaged; what to do.
XyzImage readImage(const std::string& path);
XyzImage decodeImage(std::string_view bytes, const std::string& path);

}  // namespace goniolux::image
