// The white that the eye of an observer in the scene is adapted to, as images state it.
#pragma once

#include <optional>
#include <string_view>

#include "image/xyz_image.h"
#include "spectrum/colorimetry.h"

namespace goniolux::display {

/// CIE D65: the white that is assumed where an image names none.
inline constexpr spectrum::Chromaticity daylight{0.3127, 0.3290};

/// "x y" or "x,y"; nothing when it is no chromaticity of a light.
std::optional<spectrum::Chromaticity> chromaticityFrom(std::string_view text);

/// What the image's attribute says; nothing when it has none.
std::optional<spectrum::Chromaticity> adoptedWhiteOf(const image::XyzImage& image);

}  // namespace goniolux::display
