// Exposure: which luminance becomes the display's white.
#pragma once

#include <string>

#include "core/vector.h"
#include "image/xyz_image.h"

namespace goniolux::display {

struct Exposure {
  double white_cd_m2 = 0;  ///< luminance that is shown as white
  std::string method;      ///< how it was chosen, for the report
};

/// Of the pixels that have any luminance (finite and above 0); both 0 for a black image. `toRgb` takes X, Y, Z to the
/// device's linear primaries.
struct LuminanceStatistics {
  double logAverage_cd_m2 = 0;  ///< the exponential of the mean logarithm
  double bright_cd_m2 = 0;      ///< what the largest primary of 5 % of the pixels exceeds, to a 64th of a stop
  double largest_cd_m2 = 0;     ///< luminance of the brightest pixel
};
LuminanceStatistics luminanceStatistics(const image::XyzImage& image, const core::Mat3& toRgb);

/// Photographic exposure: the log-average luminance is shown as 18 % of white (Reinhard et al., SIGGRAPH 2002, key
/// 0.18). Where that would clip more than 5 % of the pixels, white is raised until it does not, by two stops at most: a
/// picture of a dark floor keeps its light desks, a picture full of luminaires does not go dark. Then moved by `stops`.
/// A black image gets 1 cd/m2.
Exposure automaticExposure(const LuminanceStatistics& statistics, double stops = 0);
/// A camera's setting: EV at ISO 100 meters an average luminance of 0.125 * 2^EV cd/m2 (reflected-light constant K
/// = 12.5, ISO 2720), which is shown as 18 % of white.
Exposure cameraExposure(double ev100);
Exposure whiteAt(double white_cd_m2);

/// "auto", "auto+1" and "auto-0.5" (stops), or a number (EV at ISO 100). core::InputError for anything else.
Exposure exposureFrom(const std::string& text, const LuminanceStatistics& statistics);

}  // namespace goniolux::display
