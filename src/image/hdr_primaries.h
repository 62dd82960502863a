// What Radiance's RGB means where a picture does not say: its color.h.
#pragma once

#include "image/rgb_to_xyz.h"

namespace goniolux::image {

inline constexpr RgbSpace radiancePrimaries{{0.640, 0.330}, {0.290, 0.600}, {0.150, 0.060}, {1.0 / 3, 1.0 / 3}};
inline constexpr double radianceEfficacy_lm_W = 179;  ///< luminance of white per radiance

}  // namespace goniolux::image
