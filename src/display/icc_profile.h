// ICC profile of a device, so that picture files say what their code values mean.
#pragma once

#include <string>

#include "display/device.h"

namespace goniolux::display {

/// An ICC matrix/curve display profile (made with Little CMS; perceptual white D50 by Bradford adaptation, as ICC.1
/// asks; black and flare are left to the viewer). Its bytes depend on the device alone: no date, no identifier. A
/// device made of a profile gives that one; film, whose codes are densities, none ("").
std::string iccProfile(const Device& device);

}  // namespace goniolux::display
