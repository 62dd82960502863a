// The rules by which readers warn, and which of them are departures from a format: read with an assumption in lenient
// mode, refused in strict mode. What is legal but doubtful (two fluxes that part, an ambiguous pole) is a warning in
// both modes.
#pragma once

#include <string_view>
#include <vector>

#include "core/diagnostics.h"

namespace goniolux::photometry {

/// Names of the warnings that a strict reader turns into errors.
const std::vector<std::string_view>& departureRules();

/// Throws an InputError that lists every departure among `warnings`; does nothing when there is none.
void refuseDepartures(const core::Diagnostics& warnings);

}  // namespace goniolux::photometry
