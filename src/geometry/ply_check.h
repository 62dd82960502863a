// What a PLY file must hold before the importer may see it.
#pragma once

#include <cstdint>
#include <string>

namespace goniolux::geometry {

/// The importer (assimp 5.2) reads on for ever in a header that it does not understand or that does not end, and for
/// minutes where thousands of millions of elements are promised (all found by fuzzing): the header is read here first.
/// Throws std::invalid_argument with path, line and what is wrong with it.
void checkPlyHeader(const std::string& path, std::uintmax_t bytes);

}  // namespace goniolux::geometry
