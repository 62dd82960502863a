// Exposure: which luminance becomes the display's white.
#pragma once

#include <string>

#include "image/xyz_image.h"

namespace goniolux::display {

struct Exposure {
  double white_cd_m2 = 0;  ///< luminance that is shown as white
  std::string method;      ///< how it was chosen, for the report
};

/// Log-average luminance of the pixels that have any: the exponential of the mean logarithm, cd/m2; 0 for a black
/// image.
double logAverageLuminance(const image::XyzImage& image);

/// Photographic exposure: the log-average luminance, moved by `stops`, is shown as 18 % of white (Reinhard et al.,
/// SIGGRAPH 2002, key 0.18). A black image gets 1 cd/m2.
Exposure automaticExposure(const image::XyzImage& image, double stops = 0);
/// A camera's setting: EV at ISO 100 meters an average luminance of 0.125 * 2^EV cd/m2 (reflected-light constant K
/// = 12.5, ISO 2720), which is shown as 18 % of white.
Exposure cameraExposure(double ev100);
Exposure whiteAt(double white_cd_m2);

/// "auto", "auto+1" and "auto-0.5" (stops), or a number (EV at ISO 100). core::InputError for anything else.
Exposure exposureFrom(const std::string& text, const image::XyzImage& image);

}  // namespace goniolux::display
