// The entries of the pattern registry, one function per pattern's file, and what they share.
#pragma once

#include <string>

#include "texture/pattern.h"

namespace goniolux::texture {

PatternType checkerPattern();
PatternType stripesPattern();
PatternType tilesPattern();
PatternType noisePattern();

/// A plain number with a default.
core::Parameter number(const char* key, const char* title, double minimum, double maximum, const char* defaultText,
                       const char* help);
/// Its value, or the default.
double valueOf(const core::Arguments& arguments, const core::Parameter& parameter);
/// The part of x behind its whole number, 0 <= r < 1.
double fractionOf(double x);

}  // namespace goniolux::texture
