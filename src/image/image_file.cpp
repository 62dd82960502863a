#include "image/image_file.h"

#include "core/diagnostics.h"
#include "core/document.h"
#include "image/exr.h"
#include "image/hdr.h"

namespace goniolux::image {

XyzImage decodeImage(std::string_view bytes, const std::string& path) {
  if (bytes.starts_with("#?")) return decodeHdr(bytes, path);
  if (bytes.starts_with("\x76\x2f\x31\x01")) return decodeExr(bytes, path);
  throw core::InputError({path, 0, 0}, "not-an-image",
                         "this is neither an OpenEXR image nor a Radiance picture (.hdr); give an image that 'goniolux "
                         "render' wrote");
}

XyzImage readImage(const std::string& path) {
  return decodeImage(core::readFile(path), path);
}

}  // namespace goniolux::image
