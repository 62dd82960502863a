// Colour fidelity and gamut of ANSI/IES TM-30-20 (the fidelity index is also that of CIE 224:2017).
#pragma once

#include <array>

#include "spectrum/spectral_distribution.h"

namespace goniolux::spectrum {

struct ColourFidelity {
  double rf = 0, rg = 0;
  std::array<double, 99> ofSample{};     ///< R_f,CES of each colour evaluation sample
  std::array<double, 16> chromaShift{};  ///< R_cs,h of each hue bin, from red anticlockwise: relative change of chroma
  std::array<double, 16> hueAngle{};     ///< degrees: where each bin's reference samples lie on average
};

/// Test colour method with 99 samples in CAM02-UCS, CIE 1964 observer; reference is Planck's radiator up to a
/// correlated colour temperature of 4000 K, CIE daylight from 5000 K on (to 25000 K, then daylight of 25000 K), a
/// mixture between. Tristimulus values by tristimulus() of colorimetry.h. The source must have luminous power.
ColourFidelity colourFidelity(const SpectralDistribution& source);

}  // namespace goniolux::spectrum
