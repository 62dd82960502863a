// From calibrated X, Y, Z to a device's code values, and an account of what the device cannot show. Needs no files.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "display/adaptation.h"
#include "display/code_image.h"
#include "display/device.h"
#include "display/gamut.h"
#include "display/mapping.h"
#include "image/xyz_image.h"

namespace goniolux::display {

struct DisplaySettings {
  MappingChoice mapping = mappingNamed("linear");
  /// White of the scene, to which the eye is adapted there; it becomes the device's. Nothing: colours as they are.
  std::optional<spectrum::Chromaticity> adoptedWhite;
  Adaptation adaptation = Adaptation::cat16;
  GamutMapping gamut = GamutMapping::clip;
  int bits = 8;  ///< 8, 10 or 16
};

/// What a pixel suffered; a pixel may have several.
enum Shortfall : std::uint8_t {
  outOfGamut = 1,  ///< too pure a colour: a primary would be negative by more than half a code value
  tooBright = 2,   ///< a primary would exceed white by more than half a code value
  tooDark = 4,     ///< darker than the device's black and flare
  invalid = 8,     ///< not a number, or infinite; shown black
};

struct DisplayedImage {
  CodeImage codes;
  std::vector<std::uint8_t> shortfalls;                                 ///< of every pixel, a sum of Shortfall
  std::size_t outOfGamut = 0, tooBright = 0, tooDark = 0, invalid = 0;  ///< pixels
  /// CIEDE2000 between the colour intended (after luminance mapping and adaptation) and the one that the device gives
  /// for the code values, relative to the device's white; over at most half a million pixels in equal steps.
  double deltaMean = 0, deltaP95 = 0, deltaMax = 0;
  std::size_t deltaPixels = 0;
  LuminanceStatistics statistics;
  std::string method;      ///< what the luminance mapping did
  double white_cd_m2 = 0;  ///< luminance of the scene that is shown as white; 0 where no single one is
};

/// Luminance mapping, chromatic adaptation, device model, gamut mapping, rounding to the nearest code, in this order.
/// Runs on all threads; the same bytes for any number of them. core::InputError when the mapping cannot be used with
/// this device.
DisplayedImage displayImage(const image::XyzImage& image, const Device& device, const DisplaySettings& settings);

/// The account as a picture: grey where all is shown; magenta: out of gamut, yellow: too bright, cyan: too dark, red:
/// both of the first, white: no number. 8 bit sRGB.
CodeImage shortfallMap(const DisplayedImage& displayed);

}  // namespace goniolux::display
