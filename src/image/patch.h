// A patch of an image, measured as an imaging luminance meter would: mean luminance, chromaticity, colour temperature.
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "core/vector.h"
#include "image/xyz_image.h"

namespace goniolux::image {

/// A value and its half-width; NaN where the image carries none.
struct Measured {
  double value = 0, halfWidth = 0;
};

struct PatchReading {
  std::size_t pixels = 0;                     ///< that were averaged
  std::size_t invalid = 0;                    ///< not numbers, left out
  Measured luminance;                         ///< cd/m2
  Measured x, y;                              ///< CIE 1931 chromaticity of the mean; (0, 0) for black
  std::optional<Measured> colourTemperature;  ///< K; nothing where it has no meaning (|Duv| above 0.05, CIE 015)
  double duv = 0;
  double least = 0, most = 0;                       ///< luminance of the darkest and the brightest pixel, cd/m2
  std::vector<std::pair<double, double>> spectrum;  ///< nm, W/(m2 sr nm), where the image stores it
};

/// The pixels whose centres lie within `radius` of the centre of pixel (column, row), counted from 0 at the top left;
/// radius 0: that pixel alone. It must lie inside the image.
///
/// Half-width of the mean luminance: the statistical parts of the pixels are independent and add in squares, the
/// systematic part (systematicAttribute) is common; in an image that does not part them all of it is taken as common.
/// The half-widths of x and y are statistical: errors of X, Y and Z go together, so that a chromaticity is known far
/// better than its tristimulus values apart. That of the colour temperature is the largest change within them.
PatchReading readPatch(const XyzImage& image, int column, int row, double radius);

/// The pixels whose centres lie inside a polygon; its corners in pixels from the upper left corner of the image, x to
/// the right, y down, so that the centre of pixel (column, row) is (column + 0.5, row + 0.5). Of edges that cross, what
/// an odd number of them encloses counts. Nothing (0 pixels) where it holds no centre.
PatchReading readPolygon(const XyzImage& image, const std::vector<core::Vec2>& corners);

}  // namespace goniolux::image
