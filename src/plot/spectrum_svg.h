// SpectrumPlot: the relative power of a lamp against wavelength, with the colours of the spectrum under the curve and
// V(lambda) and the melanopic action spectrum for comparison, as an SVG picture. No helper program is needed for it.
#pragma once

#include <string>
#include <vector>

#include "spectrum/spectral_distribution.h"

namespace goniolux::plot {

struct SpectrumPlot {
  std::string title;
  spectrum::SpectralDistribution source;  ///< relative; drawn from 360 to 830 nm with its highest value as 1
  std::vector<std::string> facts;         ///< short statements beside the title
};

/// A whole SVG document. Lines of the source are drawn as needles; the strongest has the height of the continuum's top,
/// or of the picture where there is no continuum.
std::string spectrumSvg(const SpectrumPlot& plot);

}  // namespace goniolux::plot
