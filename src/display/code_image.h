// CodeImage: the code values that a device is sent.
#pragma once

#include <cstdint>
#include <vector>

namespace goniolux::display {

struct CodeImage {
  int width = 0, height = 0, bits = 8;
  std::vector<std::uint16_t> rgb;  ///< row by row from the top, 3 * width * height code values, 0 to 2^bits - 1
};

}  // namespace goniolux::display
