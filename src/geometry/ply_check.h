// What a PLY file must hold before the importer may see it.
#pragma once

#include <string>

namespace goniolux::geometry {

/// The importer (assimp 5.2) reads on for ever in a header that it does not understand or that does not end, and for
/// minutes where thousands of millions of elements or corners are promised (all found by fuzzing): the header is read
/// here first, and the lists of a text file are counted. Throws std::invalid_argument with path, line and what is
/// wrong.
void checkPly(const std::string& path);

}  // namespace goniolux::geometry
