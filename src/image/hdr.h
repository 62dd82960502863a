// Radiance pictures (.hdr, .pic): one exponent for three mantissas of 8 bits. Two kinds: XYZE holds X, Y, Z in cd/m2;
// RGBE holds radiance in W/(m2 sr) in three primaries, of which 179 lm/W make luminance — Ward, "Real Pixels", Graphics
// Gems II, 1991; the format's own description in Radiance's filefmts.
#pragma once

#include <string>
#include <string_view>

#include "image/xyz_image.h"

namespace goniolux::image {

enum class HdrForm { xyze, rgbe };

/// The file's bytes: new run-length form, rows from the top; attributes as comments, the view (viewAttribute) as
/// VIEW=. RGBE: Radiance's primaries, white of equal energy; colours outside them are cut off (negative values cannot
/// be written). Precision: one part in 256 of the pixel's largest value.
std::string encodeHdr(const XyzImage& image, HdrForm form);
/// Reads both kinds, run-length encoded in the old or the new way, or flat; EXPOSURE, COLORCORR and PRIMARIES are
/// undone. core::InputError for damaged files, naming `path`.
XyzImage decodeHdr(std::string_view bytes, const std::string& path);

}  // namespace goniolux::image
