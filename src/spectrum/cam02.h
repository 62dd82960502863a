// CIECAM02 and its uniform colour space CAM02-UCS, in the one viewing condition that TM-30 and CIE 224 prescribe.
#pragma once

#include "spectrum/colorimetry.h"

namespace goniolux::spectrum {

/// J', a', b' of CAM02-UCS — M. R. Luo, G. Cui, C. Li, Color Res. Appl. 31(4), 2006.
struct Cam02Ucs {
  double J = 0, a = 0, b = 0;
};

/// `colour` and `white` are X, Y, Z with Y = 100 for the white. Background Y_b = 20, adapting luminance 100 cd/m2,
/// average surround, adaptation complete — CIE 159:2004 with the conditions of CIE 224:2017, 5.
Cam02Ucs cam02Ucs(const Xyz& colour, const Xyz& white);

}  // namespace goniolux::spectrum
