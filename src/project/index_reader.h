// Refractive indices: a number, a spectrum, or a dispersion formula: {"cauchy": [A, B, C]}, {"sellmeier": {"b", "c"}}.
#pragma once

#include <optional>

#include "core/document.h"
#include "project/format.h"
#include "project/reading.h"
#include "spectrum/spectral_distribution.h"

namespace goniolux::project {

/// The index over 360-830 nm; formulas are tabulated at 5 nm.
std::optional<spectrum::SpectralDistribution> readRefractiveIndex(const core::Value& value, const Key& key,
                                                                  Reading& reading);

}  // namespace goniolux::project
