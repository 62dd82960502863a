// The rows of a PNG picture as its compressed stream (PNG 10: zlib, RFC 1950), made on all threads: libpng compresses
// on one, which takes longer than all else that a large picture needs.
#pragma once

#include <string>

#include "display/code_image.h"

namespace goniolux::display {

/// Rows of 8 or 16 bits, R, G, B, filtered by "sub"; the bytes that IDAT chunks hold. Bands of rows are compressed
/// apart and joined, so that the bytes do not depend on the number of threads.
std::string compressedRows(const CodeImage& image);

}  // namespace goniolux::display
