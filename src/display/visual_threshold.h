// What the eye can just tell apart, and how sharply it sees, by the luminance that it is adapted to.
#pragma once

#include <cmath>

namespace goniolux::display {

/// Smallest luminance difference that can be seen, cd/m2, rods and cones together — Ferwerda et al., SIGGRAPH 1996, as
/// joined by Ward Larson, Rushmeier and Piatko, IEEE TVCG 3(4), 1997, table 1.
inline double justNoticeable(double adaptation_cd_m2) {
  const double a = std::log10(adaptation_cd_m2);
  double result = 0;
  if (a < -3.94)
    result = -2.86;
  else if (a < -1.44)
    result = std::pow(0.405 * a + 1.6, 2.18) - 2.86;
  else if (a < -0.0184)
    result = a - 0.395;
  else if (a < 1.9)
    result = std::pow(0.249 * a + 0.65, 2.7) - 0.72;
  else
    result = a - 1.255;
  return std::pow(10.0, result);
}

/// Highest spatial frequency that is resolved, cycles per degree — the same, equation 13, after Shlaer (1937).
inline double acuity(double adaptation_cd_m2) {
  return 17.25 * std::atan(1.4 * std::log10(adaptation_cd_m2) + 0.35) + 25.72;
}

}  // namespace goniolux::display
