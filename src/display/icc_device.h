// Any RGB device with an ICC profile, through Little CMS.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "display/device_model.h"

namespace goniolux::display {

/// Whether these bytes are an ICC profile (ICC.1: 'acsp' at byte 36).
bool isIccProfile(std::string_view bytes);

/// The profile as a device: RGB only; the luminance tag gives white_cd_m2. core::InputError names `path`.
Device iccDevice(std::string bytes, const std::string& path);

/// Relative colorimetric: light is seen under D50, the white of the profile connection space. What a profile of tables
/// cannot show becomes NaN (its answer, turned back, is another colour).
std::unique_ptr<DeviceModel> makeIccModel(const Device& device);

}  // namespace goniolux::display
