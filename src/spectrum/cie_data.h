// CIE data: observers and illuminants by name. Tables stand in data/cie/*.csv beside the program, each with its source
// in the head.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "spectrum/spectral_distribution.h"

namespace goniolux::spectrum {

/// Maximum luminous efficacy Km of radiation for photopic vision at 555.016 nm in air, lm/W (CIE 018:2019).
inline constexpr double maximumLuminousEfficacy = 683.002;

/// CIE 1931 2-degree colour-matching functions, 360-830 nm at 1 nm (CIE 018:2019); ybar is V(lambda).
struct Observer {
  SpectralDistribution xbar, ybar, zbar;
};
const Observer& cie1931();

/// CIE 1964 10-degree colour-matching functions, 360-830 nm at 1 nm (CIE 015:2018).
const Observer& cie1964();

/// Action spectra of CIE S 026:2018, 380-780 nm, and the efficacy of each for D65, mW/lm.
enum class AlphaOpic { sCone, mCone, lCone, rhodopic, melanopic };
const SpectralDistribution& alphaOpicAction(AlphaOpic response);
double alphaOpicEfficacyOfD65(AlphaOpic response);
inline const SpectralDistribution& melanopicAction() {
  return alphaOpicAction(AlphaOpic::melanopic);
}

/// Spectral luminous efficiency for scotopic vision V'(lambda), 380-780 nm; its maximum luminous efficacy is in lm/W
/// (CIE 018:2019).
const SpectralDistribution& scotopicEfficiency();
inline constexpr double maximumScotopicEfficacy = 1700.05;

/// Radiance factors of test colour samples 1 to 14, in order — CIE 13.3-1995.
const std::vector<SpectralDistribution>& testColours();
/// Radiance factors of the 99 colour evaluation samples — CIE 224:2017, ANSI/IES TM-30-20.
const std::vector<SpectralDistribution>& colourEvaluationSamples();

/// Built-in illuminants and lamps: "CIE A", "CIE D50", "CIE D65", "CIE E", "CIE FL1".."CIE FL12", "CIE LED-B1", "CIE
/// HP1" … Relative spectral power. nullopt for an unknown name; illuminantNames() lists all.
std::optional<SpectralDistribution> illuminant(const std::string& name);
std::vector<std::string> illuminantNames();
/// CIE daylight of a correlated colour temperature of 4000 to 25000 K (asserted), relative, 360-830 nm — CIE 015:2018.
SpectralDistribution daylight(double kelvin);
/// Planck's radiator at a temperature in kelvin, relative, 360-830 nm at 1 nm.
SpectralDistribution blackbody(double kelvin);

}  // namespace goniolux::spectrum
