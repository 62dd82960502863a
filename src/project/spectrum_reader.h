// SPECTRUM of the project format: a number, a file, the name of an illuminant or lamp, or an object.
#pragma once

#include <optional>

#include "core/document.h"
#include "project/format.h"
#include "project/reading.h"
#include "spectrum/spectral_distribution.h"
#include "spectrum/spectrum_files.h"

namespace goniolux::project {

/// Reads and checks a spectrum for its role; `key` names it in messages and gives a plain number's limits.
std::optional<spectrum::SpectralDistribution> readSpectrum(const core::Value& value, const Key& key,
                                                           spectrum::Role role, Reading& reading);

}  // namespace goniolux::project
