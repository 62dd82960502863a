// The way back: from code values to the light that the device gives for them, to check a calibration.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/vector.h"
#include "display/code_image.h"
#include "display/device.h"
#include "image/xyz_image.h"

namespace goniolux::display {

/// X, Y, Z of every pixel: cd/m2 with a device whose luminance is known (black and flare included), else relative to
/// its white. The attributes say which, and the device's white as adopted white.
image::XyzImage lightOf(const CodeImage& codes, const Device& device);

/// A patch of a calibration: code values and, where it was measured, X, Y, Z in cd/m2.
struct Patch {
  std::array<double, 3> codes{};
  std::optional<core::Vec3> measured;
  core::Vec3 predicted{0};      ///< by the device's model
  std::optional<double> delta;  ///< CIEDE2000 between the two, relative to the device's white
};

/// Lines of "R G B" or "R G B X Y Z", parted by blanks, commas or semicolons; '#' begins a comment. core::InputError
/// with line and column for what is no number or no code of so many bits.
std::vector<Patch> readPatches(const std::string& text, const std::string& path, int bits);
/// Fills in predictions and differences.
void predict(std::vector<Patch>& patches, const Device& device, int bits);

}  // namespace goniolux::display
