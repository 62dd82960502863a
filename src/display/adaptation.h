// Chromatic adaptation: which colour under one white looks like a colour under another.
#pragma once

#include <string>
#include <vector>

#include "core/vector.h"
#include "spectrum/colorimetry.h"

namespace goniolux::display {

/// Cone spaces in which whites are scaled: CAT16 (Li et al., Color Res. Appl. 42(6), 2017), CAT02 (CIE 159:2004), the
/// linear Bradford transform (ICC.1).
enum class Adaptation { cat16, cat02, bradford };

/// "cat16", "cat02", "bradford"; core::InputError with the names for anything else.
Adaptation adaptationNamed(const std::string& name);
std::vector<std::string> adaptationNames();

/// Von Kries adaptation, complete: colours seen under white `from` become those that look alike under white `to`;
/// `from` itself becomes `to`, luminance of white is kept.
core::Mat3 adaptation(const spectrum::Chromaticity& from, const spectrum::Chromaticity& to,
                      Adaptation space = Adaptation::cat16);

}  // namespace goniolux::display
