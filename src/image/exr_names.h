// Names of channels that both the writer and the reader of OpenEXR files use.
#pragma once

namespace goniolux::image {

inline constexpr const char* halfWidthChannel = "Y.halfWidth";
inline constexpr const char* chromaticityXChannel = "chromaticity.x.halfWidth";
inline constexpr const char* chromaticityYChannel = "chromaticity.y.halfWidth";
/// After the name of a spectral channel: "S0.550,000000nm.halfWidth".
inline constexpr const char* halfWidthEnding = ".halfWidth";

}  // namespace goniolux::image
