// What lamps are compared with in the test colour methods of CIE 13.3 and TM-30.
#pragma once

#include "spectrum/spectral_distribution.h"

namespace goniolux::spectrum {

/// A reference's continuum at the wavelengths of a source that colorimetry sums (summationStep()), so that both share
/// the errors of summation; unchanged for other sources.
SpectralDistribution atWavelengthsOf(const SpectralDistribution& source, const SpectralDistribution& reference);

}  // namespace goniolux::spectrum
