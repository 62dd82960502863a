#include "spectrum/reference_illuminant.h"

#include <utility>
#include <vector>

#include "spectrum/colorimetry.h"

namespace goniolux::spectrum {

SpectralDistribution atWavelengthsOf(const SpectralDistribution& source, const SpectralDistribution& reference) {
  if (summationStep(source) == 0) return reference;
  std::vector<SpectralDistribution::Sample> samples;
  for (const auto& [wavelength, power] : source.samples())
    samples.push_back({wavelength, reference.continuum(wavelength)});
  return SpectralDistribution::sampled(std::move(samples), SpectralDistribution::Outside::zero);
}

}  // namespace goniolux::spectrum
