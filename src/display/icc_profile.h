// ICC profile of a device, so that picture files say what their code values mean.
#pragma once

#include <string>

#include "display/device.h"

namespace goniolux::display {

/// An ICC matrix/curve display profile (made with Little CMS; perceptual white D50 by Bradford adaptation, as ICC.1
/// asks). Its bytes depend on the device alone: no date, no identifier.
std::string iccProfile(const Device& device);

}  // namespace goniolux::display
