// Writers of photometric files. Candelas are written with all their digits: what is read back is the same, to the last
// bit in LM-63 and TM-33; in EULUMDAT, whose values are cd per 1000 lm of lamp flux, to the last bit wherever a number
// exists that gives it when multiplied, else one unit in the last place (2e-16).
#pragma once

#include <string>

#include "photometry/photometric_file.h"

namespace goniolux::photometry {

/// LM-63-2019, multiplier and ballast factor 1; photometry types A, B and C.
std::string writeLm63(const PhotometricFile& file, core::Diagnostics& warnings);
/// EULUMDAT; photometry type C only. An opening or a seam that it cannot state gives a warning.
std::string writeEulumdat(const PhotometricFile& file, core::Diagnostics& warnings);
/// TM-33-18 with the spectrum, if there is one.
std::string writeTm33(const PhotometricFile& file, core::Diagnostics& warnings);

/// The format that the file name's ending asks for (.ies, .ldt, .xml, .tm33); InputError for any other.
std::string writePhotometry(const PhotometricFile& file, const std::string& fileName, core::Diagnostics& warnings);

}  // namespace goniolux::photometry
