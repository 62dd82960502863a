// Device: what turns code values into light, as data: a monitor, a film recorder with its film and projector
// (*.device.json), or any RGB device with an ICC profile.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/vector.h"
#include "display/transfer_curve.h"
#include "spectrum/colorimetry.h"

namespace goniolux::display {

struct Film;  // display/film.h

struct Device {
  enum class Kind { monitor, film, icc };
  Kind kind = Kind::monitor;
  std::string name, source;
  spectrum::Chromaticity red, green, blue;  ///< of film: the composite primaries, see film.h
  spectrum::Chromaticity white;             ///< of an ICC profile: D50, the white of the connection space
  std::array<TransferCurve, 3> transfer;    ///< red, green, blue; monitors only
  double white_cd_m2 = 0;                   ///< largest luminance, without flare; 0: not known
  double black_cd_m2 = 0;                   ///< luminance of code 0, in the colour of white; part of white_cd_m2
  double flare_cd_m2 = 0;                   ///< reflected room light, on top of everything, in the colour of white
  std::shared_ptr<const Film> film;         ///< Kind::film
  std::string profile;                      ///< Kind::icc: the profile's bytes
};

/// The device of a preset's name ("srgb", "display-p3", …), of a goniolux-device file of version 1, or of an ICC
/// profile. core::InputError with place and reason when it is none, or when no colours could be made with it (primaries
/// on one line, white outside their triangle).
Device readDevice(const std::string& presetOrPath);
std::vector<std::string> presetNames();

/// Tristimulus values (device white: Y = 1) of linear device values; columns are the primaries. SMPTE RP 177-1993.
core::Mat3 xyzFromRgb(const Device& device);

/// Linear device values of tristimulus values, seen under `adoptedWhite` (adapted to the device's white by CAT16) or as
/// they are.
core::Mat3 rgbFromXyz(const Device& device, const std::optional<spectrum::Chromaticity>& adoptedWhite);

/// Black and flare as a fraction of the device's white; 0 where its white is not known.
double darkest(const Device& device);

}  // namespace goniolux::display
