// CIELAB and the CIEDE2000 colour difference.
#pragma once

#include "spectrum/colorimetry.h"

namespace goniolux::spectrum {

/// CIE 1976 L*, a*, b*.
struct Lab {
  double L = 0, a = 0, b = 0;
};

/// CIELAB relative to the white's tristimulus values (same scale) — ISO/CIE 11664-4.
Lab lab(const Xyz& colour, const Xyz& white);

/// CIEDE2000 with k_L = k_C = k_H = 1 — ISO/CIE 11664-6; Sharma, Wu, Dalal, Color Res. Appl. 30(1), 2005.
double deltaE2000(const Lab& first, const Lab& second);

}  // namespace goniolux::spectrum
