// Dodging and burning: the luminance that stands for the surroundings of each pixel, over the largest neighbourhood
// that holds no strong contrast — Reinhard, Stark, Shirley and Ferwerda, Photographic tone reproduction for digital
// images, SIGGRAPH 2002, section 3.2.
#pragma once

#include <vector>

namespace goniolux::display {

struct DodgingSettings {
  double key = 0.18;        ///< a of their equation 7
  double sharpness = 8;     ///< phi: larger ones let edges count sooner
  double threshold = 0.05;  ///< epsilon of their equation 8
};

/// V_1(x, y, s_m) of their equation 9, row by row, in the unit of `luminance`: at each pixel the Gaussian mean over the
/// largest of eight scales (each 1.6 times the last) at which centre and surround still differ by less than the
/// threshold. Beyond the picture its edge goes on. Values that are not numbers or negative count as 0.
std::vector<float> localAdaptation(const std::vector<float>& luminance, int width, int height,
                                   const DodgingSettings& settings);

}  // namespace goniolux::display
