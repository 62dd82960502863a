// Device: an additive display with three primaries, a white and a transfer curve, as data (*.device.json).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/vector.h"
#include "spectrum/colorimetry.h"

namespace goniolux::display {

/// From linear light L (0..1) to code value V (0..1): V = slope L up to `threshold`, above it V = (1 + offset)
/// L^(1/gamma) - offset. A pure power has slope 0, threshold 0, offset 0.
struct TransferCurve {
  double gamma = 1, offset = 0, slope = 0, threshold = 0;
  [[nodiscard]] double encode(double linear) const;
  [[nodiscard]] double decode(double code) const;

  friend bool operator==(const TransferCurve&, const TransferCurve&) = default;
};

struct Device {
  std::string name, source;
  spectrum::Chromaticity red, green, blue, white;
  TransferCurve transfer;
};

/// The device of a preset's name ("srgb", "display-p3", …) or of a goniolux-device file of version 1. core::InputError
/// with place and reason when it is neither, or when no colours could be made with it (primaries on one line, white
/// outside their triangle).
Device readDevice(const std::string& presetOrPath);
std::vector<std::string> presetNames();

/// Tristimulus values (device white: Y = 1) of linear device values; columns are the primaries. SMPTE RP 177-1993.
core::Mat3 xyzFromRgb(const Device& device);

/// Linear device values of tristimulus values, seen under `adoptedWhite` (adapted to the device's white) or as they
/// are.
core::Mat3 rgbFromXyz(const Device& device, const std::optional<spectrum::Chromaticity>& adoptedWhite);

/// Von Kries adaptation in the sharpened cone space of CAT16 (Li et al., Color Res. Appl. 42(6), 2017), complete:
/// colours seen under white `from` become those that look alike under white `to`; `from` itself becomes `to`, luminance
/// of white is kept.
core::Mat3 adaptation(const spectrum::Chromaticity& from, const spectrum::Chromaticity& to);

}  // namespace goniolux::display
