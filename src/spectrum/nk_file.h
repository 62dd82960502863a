// Complex refractive indices from .nk files: three columns of text, wavelength in nm, n and k; '#' begins a comment.
#pragma once

#include <string>

#include "core/diagnostics.h"
#include "spectrum/spectral_distribution.h"

namespace goniolux::spectrum {

struct ComplexIndex {
  SpectralDistribution n, k;  ///< continued outside the table
};

/// Throws core::InputError that lists every fault with its line.
ComplexIndex readComplexIndexFile(const std::string& path, core::Diagnostics* warnings = nullptr);
/// The same from text in memory; `name` stands in the messages.
ComplexIndex readComplexIndex(const std::string& text, const std::string& name, core::Diagnostics* warnings = nullptr);

}  // namespace goniolux::spectrum
