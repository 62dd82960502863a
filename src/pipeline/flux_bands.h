// Three wavelength bands in which a lamp has the same luminous flux: for programs that calculate in three channels.
#pragma once

#include <array>

#include "spectrum/spectral_distribution.h"

namespace goniolux::pipeline {

class FluxBands {
 public:
  using Three = std::array<double, 3>;

  /// Bands of equal luminous flux of the source (its own luminous flux must be above 0), at 1 nm.
  explicit FluxBands(const spectrum::SpectralDistribution& source);

  /// Mean of a reflectance over each band, weighted by the source's luminous flux.
  [[nodiscard]] Three mean(const spectrum::SpectralDistribution& reflectance) const;
  /// Shares of a light source's luminous flux in the bands; they add up to 1.
  [[nodiscard]] Three shares(const spectrum::SpectralDistribution& source) const;

 private:
  spectrum::SpectralDistribution source_;
  std::array<double, 4> edges_{};  ///< nm
};

}  // namespace goniolux::pipeline
