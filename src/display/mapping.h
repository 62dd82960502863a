// Mapping: from calibrated X, Y, Z to a device's code values, and an account of what the device cannot show.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "display/device.h"
#include "image/xyz_image.h"

namespace goniolux::display {

struct CodeImage {
  int width = 0, height = 0, bits = 8;
  std::vector<std::uint16_t> rgb;  ///< row by row from the top, 3 * width * height code values, 0 to 2^bits - 1
  // Pixels that the device cannot show; each value is moved to the nearest end of 0..1. A pixel may count in both.
  std::size_t outOfGamut = 0;  ///< a primary would be negative by more than half a code value: the colour is too pure
  std::size_t clipped = 0;     ///< a primary would exceed white by more than half a code value: too bright
  std::size_t invalid = 0;     ///< not a number, or infinite; shown black
};

struct MappingSettings {
  double white_cd_m2 = 100;  ///< luminance shown as white, > 0
  std::optional<spectrum::Chromaticity>
      adoptedWhite;  ///< adapt from this white to the device's; nothing: no adaptation
  int bits = 8;      ///< 8 or 16
};

/// Linear luminance scaling, matrix, clipping to the gamut per primary, transfer curve, rounding to the nearest code.
/// Runs on all threads.
CodeImage mapToDevice(const image::XyzImage& image, const Device& device, const MappingSettings& settings);

}  // namespace goniolux::display
