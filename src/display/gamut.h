// Gamut mapping: what stands for colours that a device cannot show.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/vector.h"
#include "display/device_model.h"

namespace goniolux::display {

enum class GamutMapping {
  clip,      ///< each primary to the nearest end of its range
  neutral,   ///< towards the grey of the same luminance, just until it fits: dominant wavelength and luminance stay
  compress,  ///< the same, but beginning at four fifths of the way to the boundary, so that no two colours become one
};

/// "clip", "neutral", "compress"; core::InputError with the names for anything else.
GamutMapping gamutMappingNamed(const std::string& name);
std::vector<std::string> gamutMappingNames();

/// Moves device values of a linear device into 0..1. `luminance`: Y of each primary, sum 1.
glm::vec3 intoGamut(const glm::vec3& value, const glm::vec3& luminance, GamutMapping mapping);

/// For devices that are not linear: `light` holds the colours wanted, `values` their device values, some outside 0..1
/// or NaN; `white`: light of the device's white. `neutral` and `compress` search the way to grey; `clip` clips, and
/// searches where there are no values to clip.
void searchIntoGamut(const DeviceModel& model, std::span<const glm::vec3> light, std::span<glm::vec3> values,
                     const glm::vec3& white, double darkest, GamutMapping mapping);

}  // namespace goniolux::display
