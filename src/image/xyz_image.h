// XyzImage: the intensity function at the image plane, as CIE 1931 X, Y, Z per pixel; Y is luminance in cd/m2.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace goniolux::image {

struct XyzImage {
  int width = 0, height = 0;
  std::vector<float> x, y, z;                     ///< row by row from the top, width * height each
  std::vector<float> halfWidth;                   ///< statistical half-width of Y, cd/m2; empty or width * height
  std::map<std::string, std::string> attributes;  ///< how it was made: seed, project hash, settings …
};

/// Attribute that names the white to which an observer in the scene is adapted, "x y" (CIE 1931): the light of all
/// sources together. `display` turns it into the device's white.
inline constexpr const char* adoptedWhiteAttribute = "adoptedWhite";

/// OpenEXR with 32-bit float channels X, Y, Z (and "Y.halfWidth" where known), lossless compression, and the attributes
/// beside the calibration ("photometricUnits": "cd/m2", "observer", "spectralRange_nm"). Throws core::RunError when it
/// cannot be written.
void writeExr(const std::string& path, const XyzImage& image);
/// Reads what writeExr wrote, or any EXR with channels X, Y, Z. Throws core::InputError (what is missing or damaged;
/// what to do).
XyzImage readExr(const std::string& path);

}  // namespace goniolux::image
