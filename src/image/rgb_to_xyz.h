// Images of three primaries: to X, Y, Z and back, by their chromaticities (SMPTE RP 177-1993).
#pragma once

#include "core/vector.h"
#include "image/xyz_image.h"
#include "spectrum/colorimetry.h"

namespace goniolux::image {

/// Chromaticities of primaries and white; Rec. 709 (ITU-R BT.709, white D65) unless said otherwise.
struct RgbSpace {
  spectrum::Chromaticity red{0.64, 0.33}, green{0.30, 0.60}, blue{0.15, 0.06}, white{0.3127, 0.3290};
};

/// Columns: X, Y, Z of the primaries; white has Y = 1. core::InputError when no colours can be mixed from them.
core::Mat3 xyzFromRgb(const RgbSpace& space);

/// Turns planes that hold R, G, B into X, Y, Z; (1, 1, 1) becomes white of `white_cd_m2`.
void toXyz(XyzImage& image, const RgbSpace& space, double white_cd_m2);

}  // namespace goniolux::image
