// XyzImage: the intensity function at the image plane, as CIE 1931 X, Y, Z per pixel; Y is luminance in cd/m2.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace goniolux::image {

/// Spectral radiance of every pixel at one wavelength, W/(m2 sr nm).
struct SpectralChannel {
  double wavelength_nm = 0;
  std::vector<float> values;
  std::vector<float> halfWidth;  ///< statistical; empty where it is not known
};

/// A part of the light of every pixel: X, Y, Z as those of the image. The layers of an image add up to it.
struct Layer {
  std::string name;
  std::vector<float> x, y, z;
  std::vector<float> halfWidth;  ///< statistical, of Y; empty where it is not known
};
/// What luminaires and luminous surfaces send to the eye by themselves (also in mirrors and through glass) or by one
/// reflection from a matt or glossy surface; and what has been reflected by more.
inline constexpr const char* directLayer = "direct";
inline constexpr const char* indirectLayer = "indirect";

struct XyzImage {
  int width = 0, height = 0;
  std::vector<float> x, y, z;             ///< row by row from the top, width * height each
  std::vector<float> halfWidth;           ///< half-width of Y, cd/m2; empty or width * height
  std::vector<float> chromaticityX;       ///< statistical half-width of the chromaticity x; empty or width * height
  std::vector<float> chromaticityY;       ///< the same of the chromaticity y
  std::vector<SpectralChannel> spectrum;  ///< by ascending wavelength; empty unless asked for
  std::vector<Layer> layers;              ///< empty unless asked for
  std::map<std::string, std::string> attributes;  ///< how it was made: seed, project hash, settings …
};

/// Attribute that names the white to which an observer in the scene is adapted, "x y" (CIE 1931): the light of all
/// sources together. `display` turns it into the device's white.
inline constexpr const char* adoptedWhiteAttribute = "adoptedWhite";
/// Attribute: the part of Y's half-width that is systematic, as a fraction of Y; the rest is statistical and
/// independent from pixel to pixel.
inline constexpr const char* systematicAttribute = "systematicHalfWidth";
/// Attribute: confidence of the half-widths, "0.95".
inline constexpr const char* confidenceAttribute = "confidence";
/// Attribute: the view in Radiance's words ("-vta -vp …"), for programs that evaluate glare.
inline constexpr const char* viewAttribute = "radianceView";
/// Attribute: the same for every projection, also those that Radiance does not have (scene/view_text.h).
inline constexpr const char* viewGeometryAttribute = "viewGeometry";
/// Attribute of images from elsewhere whose unit the file does not state: "relative".
inline constexpr const char* unitsAttribute = "photometricUnits";

}  // namespace goniolux::image
