// Spectrum files: two columns of text (.spd, .csv, meters' exports) or IES TM-27 (.spdx), read, checked and turned into
// a SpectralDistribution. Wavelengths in nm.
//
// Two columns: wavelength and value, separated by comma, semicolon, tabs or blanks; a decimal comma where the separator
// is a semicolon or a tab; "380nm" counts as 380; '#' begins a comment; lines above the first data line that do not
// begin with a number are a head (column names, a meter's notes) and are passed over. Any 8-bit encoding.
#pragma once

#include <string>

#include "core/diagnostics.h"
#include "spectrum/spectral_distribution.h"

namespace goniolux::spectrum {

/// What a file's values are to be: decides the checks, and what holds beyond the first and the last wavelength.
enum class Role {
  source,         ///< relative power, at least 0, not dark; zero outside
  reflectance,    ///< 0 to 1; continued outside
  transmittance,  ///< 0 to 1; continued outside
  coefficient,    ///< any value from 0 up (attenuation, refractive index); continued outside
};

/// Throws core::InputError that lists every fault with line and column: what is no number, wavelengths that do not
/// ascend, values out of bounds or that look like percent. Doubts (noise below zero that is cut off, holes in the
/// table, wavelengths missing at the ends of 400-700 nm) go to `warnings` where given.
SpectralDistribution readSpectrumFile(const std::string& path, Role role, core::Diagnostics* warnings = nullptr);

/// The same from text in memory; `name` stands in the messages, and its ending (.spdx) decides the format.
SpectralDistribution readSpectrum(const std::string& text, const std::string& name, Role role,
                                  core::Diagnostics* warnings = nullptr);

}  // namespace goniolux::spectrum
