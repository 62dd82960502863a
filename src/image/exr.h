// OpenEXR files of XyzImage: channels X, Y, Z in cd/m2, half-widths, spectral channels.
#pragma once

#include <string>
#include <string_view>

#include "image/rgb_to_xyz.h"
#include "image/xyz_image.h"

namespace goniolux::image {

enum class ExrForm {
  float32,  ///< 32-bit floats, deflate
  half,     ///< 16-bit floats, deflate: half the size, 0.05 % rounding
  paper,    ///< three 16-bit channels X, Y, Z, run-length encoded: the form of Hall & Greenberg's testbed
};

/// Channels X, Y, Z, where known "Y.halfWidth", "chromaticity.x.halfWidth", "chromaticity.y.halfWidth", and spectral
/// channels as Fichet, Pacanowski and Wilkie lay them out (JCGT 10(3), 2021): "S0.550,000000nm" in W/(m2 sr nm), their
/// half-widths "S0.550,000000nm.halfWidth"; layers "direct.X", "direct.Y" … The attributes stand beside the calibration
/// ("photometricUnits": "cd/m2", "observer", "spectralRange_nm"). 16-bit values are divided by the attribute
/// whiteLuminance (a power of two) where they would not fit. Throws core::RunError when it cannot be written.
void writeExr(const std::string& path, const XyzImage& image, ExrForm form = ExrForm::float32);

/// The same light as linear R, G, B of the given primaries, for programs that know no X, Y, Z: 32-bit float, (1, 1, 1)
/// is white of `white_cd_m2`, which the header says unless it is 0 (not known). The image's attributes are kept.
void writeRgbExr(const std::string& path, const XyzImage& image, const RgbSpace& space, double white_cd_m2);

/// Reads what writeExr wrote, or any EXR with channels X, Y, Z or R, G, B of any number form; R, G, B become X, Y, Z by
/// the file's chromaticities (Rec. 709 where it has none), times its whiteLuminance. Without that, and without
/// "photometricUnits", the image's attribute "photometricUnits" says "relative". Throws core::InputError (what is
/// missing or damaged; what to do).
XyzImage readExr(const std::string& path);
/// The same from a file's bytes; `path` is for messages.
XyzImage decodeExr(std::string_view bytes, const std::string& path);

/// "S0.550,000000nm".
std::string spectralChannelName(double wavelength_nm);

}  // namespace goniolux::image
