// Colorimetry: tristimulus values, chromaticity, correlated colour temperature; the CIE 1931 observer where no other is
// named.
#pragma once

#include "spectrum/spectral_distribution.h"

namespace goniolux::spectrum {

struct Observer;
enum class AlphaOpic;

/// Tristimulus values; the scale (Y = 1, 100 or cd/m2) is the caller's.
struct Xyz {
  double X = 0, Y = 0, Z = 0;
};
/// CIE 1931 x, y.
struct Chromaticity {
  double x = 0, y = 0;
};
/// CIE 1976 u', v'.
struct UvPrime {
  double u = 0, v = 0;
};

/// How CIE 015 forms tristimulus values of a table: one in equal steps of at most 5 nm is summed at its own
/// wavelengths, which is how the published chromaticities of the illuminants come about. The step in nm, or 0 for any
/// other distribution: that is joined by straight lines and integrated exactly, as light transport does. For the CIE
/// lamp tables the two differ by up to 0.0003 in x, y.
double summationStep(const SpectralDistribution& source);

/// Tristimulus values of a source: sum or integral over 360-830 nm of power times colour-matching function, as
/// summationStep says. Lines add to either.
Xyz tristimulus(const SpectralDistribution& source);
Xyz tristimulus(const SpectralDistribution& source, const Observer& observer);
/// Tristimulus values of a reflectance (or transmittance) under a source, by the same rule; Y = 1 for the perfect
/// diffuser.
Xyz tristimulus(const SpectralDistribution& reflectance, const SpectralDistribution& source);
Xyz tristimulus(const SpectralDistribution& reflectance, const SpectralDistribution& source, const Observer& observer);

/// alpha-opic daylight (D65) efficacy ratio: alpha-opic efficacy of luminous radiation over D65's; the alpha-opic
/// equivalent daylight illuminance is illuminance times this — CIE S 026:2018. Integrated exactly (the standard's
/// toolbox works at 1 nm). The source must have luminous power.
double alphaOpicDer(const SpectralDistribution& source, AlphaOpic response);
double melanopicDer(const SpectralDistribution& source);

/// S/P ratio: scotopic over photopic luminous flux, integrated exactly. The source must have luminous power.
double scotopicPhotopicRatio(const SpectralDistribution& source);

/// (0, 0) for black.
Chromaticity chromaticity(const Xyz& colour);
/// (0, 0) for black.
UvPrime uvPrime(const Xyz& colour);

/// The Planckian radiator nearest in CIE 1960 (u, v): its temperature (c2 = 1.438776877e-2 m K) and the distance to it,
/// positive on the green side (CIE 015; Ohno, Leukos 10(1), 2014). Searched from 500 K to 10^6 K, to the digits of a
/// double: no table error.
struct ColourTemperature {
  double kelvin = 0, duv = 0;
};
ColourTemperature colourTemperature(const Xyz& colour);

}  // namespace goniolux::spectrum
