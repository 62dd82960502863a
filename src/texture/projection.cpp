#include "texture/projection.h"

#include <cmath>

namespace goniolux::texture {

using core::Vec2;
using core::Vec3;

namespace {

// A wall at 45 degrees takes one of its two axes, whatever the rounding of its normal.
constexpr double preference = 1e-6;

Vec2 alongFacingAxis(const Vec3& p, const Vec3& normal) {
  const Vec3 n = glm::abs(normal);
  if (n.z + 2 * preference >= n.x && n.z + 2 * preference >= n.y) return {p.x, p.y};
  if (n.x + preference >= n.y) return {p.y, p.z};
  return {p.x, p.z};
}

}  // namespace

Place Projection::at(const SurfacePlace& place) const {
  const bool isBox = mapping == Mapping::box;
  const Vec2 plain = isBox ? alongFacingAxis(place.position, place.normal) : place.coordinates;
  const double c = std::cos(turn), s = std::sin(turn);
  Place result;
  result.flat = Vec2(c * plain.x + s * plain.y, c * plain.y - s * plain.x) / size - shift;
  result.solid = isBox ? place.position / Vec3(size, size.x) - Vec3(shift, 0) : Vec3(result.flat, 0);
  return result;
}

}  // namespace goniolux::texture
