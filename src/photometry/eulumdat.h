// EULUMDAT: the European luminaire file (.ldt), one item per line; intensities in cd per 1000 lm of the lamp set's
// flux. Source: A. W. Stockmar, "EULUMDAT/2", and the usage of real files. Lenient like the LM-63 reader.
#pragma once

#include <string>
#include <string_view>

#include "photometry/photometric_file.h"

namespace goniolux::photometry {

/// True when lines 2 to 7 are numbers as EULUMDAT has them.
bool looksLikeEulumdat(std::string_view bytes);

/// Reads a whole file. Symmetry codes 0 to 4 become horizontal ranges; code 3 (planes C270 through C0 to C90) is stored
/// mirrored about the C90-C270 plane, as C90 to C270, which is the same distribution.
PhotometricFile readEulumdat(std::string_view bytes, const std::string& fileName);

}  // namespace goniolux::photometry
