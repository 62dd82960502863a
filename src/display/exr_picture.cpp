#include "display/inverse.h"
#include "display/picture_file.h"
#include "image/exr.h"

namespace goniolux::display {

void writeExrPicture(const std::string& path, const CodeImage& image, const Device& device) {
  image::RgbSpace space;
  if (device.kind == Device::Kind::monitor) space = {device.red, device.green, device.blue, device.white};
  // White includes flare: then (1, 1, 1) is the largest value.
  image::writeRgbExr(path, lightOf(image, device), space, device.white_cd_m2 + device.flare_cd_m2);
}

}  // namespace goniolux::display
