// A TIFF file in memory, as libtiff wants it: it goes back to fill in directories.
#pragma once

#include <tiffio.h>

#include <memory>
#include <string>

namespace goniolux::display {

struct TiffMemory {
  std::string bytes;
  std::size_t position = 0;
};

struct CloseTiff {
  void operator()(TIFF* tiff) const { TIFFClose(tiff); }
};

/// `mode`: "r" or "w"; null when libtiff refuses the bytes. `memory` must outlive the file. The library prints nothing.
std::unique_ptr<TIFF, CloseTiff> openTiff(TiffMemory& memory, const char* mode);

}  // namespace goniolux::display
