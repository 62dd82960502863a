#include "display/device.h"

#include "display/adaptation.h"

namespace goniolux::display {
namespace {

core::Vec3 xyzOf(const spectrum::Chromaticity& colour) {
  return {colour.x / colour.y, 1, (1 - colour.x - colour.y) / colour.y};
}

}  // namespace

core::Mat3 xyzFromRgb(const Device& device) {
  core::Mat3 primaries(xyzOf(device.red), xyzOf(device.green), xyzOf(device.blue));
  const core::Vec3 share = glm::inverse(primaries) * xyzOf(device.white);  // of each primary in white
  for (int i = 0; i < 3; ++i) primaries[i] *= share[i];
  return primaries;
}

core::Mat3 rgbFromXyz(const Device& device, const std::optional<spectrum::Chromaticity>& adoptedWhite) {
  const core::Mat3 matrix = glm::inverse(xyzFromRgb(device));
  return adoptedWhite ? matrix * adaptation(*adoptedWhite, device.white) : matrix;
}

double darkest(const Device& device) {
  return device.white_cd_m2 > 0 ? (device.black_cd_m2 + device.flare_cd_m2) / device.white_cd_m2 : 0;
}

}  // namespace goniolux::display
