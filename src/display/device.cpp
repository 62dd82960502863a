#include "display/device.h"

#include <cmath>

namespace goniolux::display {
namespace {

using core::Mat3;
using core::Vec3;
using spectrum::Chromaticity;

Vec3 xyzOf(const Chromaticity& colour) {
  return {colour.x / colour.y, 1, (1 - colour.x - colour.y) / colour.y};
}

}  // namespace

double TransferCurve::encode(double linear) const {
  if (linear <= threshold) return threshold > 0 ? slope * linear : 0;
  return (1 + offset) * std::pow(linear, 1 / gamma) - offset;
}

double TransferCurve::decode(double code) const {
  if (code <= slope * threshold) return slope > 0 ? code / slope : 0;
  return std::pow((code + offset) / (1 + offset), gamma);
}

Mat3 xyzFromRgb(const Device& device) {
  Mat3 primaries(xyzOf(device.red), xyzOf(device.green), xyzOf(device.blue));
  const Vec3 share = glm::inverse(primaries) * xyzOf(device.white);  // of each primary in white
  for (int i = 0; i < 3; ++i) primaries[i] *= share[i];
  return primaries;
}

Mat3 rgbFromXyz(const Device& device, const std::optional<Chromaticity>& adoptedWhite) {
  const Mat3 matrix = glm::inverse(xyzFromRgb(device));
  return adoptedWhite ? matrix * adaptation(*adoptedWhite, device.white) : matrix;
}

Mat3 adaptation(const Chromaticity& from, const Chromaticity& to) {
  // The matrix M16; GLM takes columns.
  const Mat3 cones =
      glm::transpose(Mat3(0.401288, 0.650173, -0.051461, -0.250268, 1.204414, 0.045854, -0.002079, 0.048952, 0.953127));
  const Vec3 gain = (cones * xyzOf(to)) / (cones * xyzOf(from));
  return glm::inverse(cones) * Mat3({gain.x, 0, 0}, {0, gain.y, 0}, {0, 0, gain.z}) * cones;
}

}  // namespace goniolux::display
