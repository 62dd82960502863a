#include "image/rgb_to_xyz.h"

#include <cmath>

#include "core/diagnostics.h"

namespace goniolux::image {
namespace {

using core::Mat3;
using core::Vec3;

Vec3 xyzOf(const spectrum::Chromaticity& colour) {
  return {colour.x, colour.y, 1 - colour.x - colour.y};
}

}  // namespace

Mat3 xyzFromRgb(const RgbSpace& space) {
  Mat3 primaries(xyzOf(space.red), xyzOf(space.green), xyzOf(space.blue));
  const double determinant = glm::determinant(primaries);
  if (!(std::abs(determinant) > 1e-6) || !(std::abs(space.white.y) > 1e-6)) {
    throw core::InputError({}, "primaries",
                           "the image's primaries lie on one line, or its white has no luminance: no colours can be "
                           "mixed from them");
  }
  const Vec3 share = glm::inverse(primaries) * (xyzOf(space.white) / space.white.y);  // of each primary in white
  for (int i = 0; i < 3; ++i) primaries[i] *= share[i];
  return primaries;
}

void toXyz(XyzImage& image, const RgbSpace& space, double white_cd_m2) {
  const glm::mat3 matrix(xyzFromRgb(space) * white_cd_m2);
  for (std::size_t i = 0; i < image.y.size(); ++i) {
    const glm::vec3 xyz = matrix * glm::vec3(image.x[i], image.y[i], image.z[i]);
    image.x[i] = xyz.x;
    image.y[i] = xyz.y;
    image.z[i] = xyz.z;
  }
}

}  // namespace goniolux::image
