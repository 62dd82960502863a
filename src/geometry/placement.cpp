#include "geometry/placement.h"

#include <cassert>

namespace goniolux::geometry {

using core::Mat4;
using core::Vec3;
using Vec4 = glm::dvec4;

Mat4 placementAlong(const Vec3& base, const Vec3& axis, double radius) {
  const Vec3 unit = glm::normalize(axis);
  Vec3 x, y;
  core::perpendiculars(unit, x, y);
  Mat4 placement{1.0};
  placement[0] = Vec4(radius * x, 0);
  placement[1] = Vec4(radius * y, 0);
  placement[2] = Vec4(axis, 0);
  placement[3] = Vec4(base, 1);
  return placement;
}

QuadricPatch makeDiscPatch(const Vec3& center, const Vec3& normal, double radius, std::uint32_t part) {
  return {QuadricPatch::Kind::disc, 0, placementAlong(center, glm::normalize(normal), radius), part};
}

QuadricPatch makeSpherePatch(const Vec3& center, double radius, std::uint32_t part) {
  return {QuadricPatch::Kind::sphere, 0, placementAlong(center, Vec3(0, 0, radius), radius), part};
}

QuadricPatch makeCylinderPatch(const Vec3& base, const Vec3& top, double radius, std::uint32_t part) {
  return {QuadricPatch::Kind::cylinder, 0, placementAlong(base, top - base, radius), part};
}

QuadricPatch makeConePatch(const Vec3& base, const Vec3& top, double baseRadius, double topRadius, std::uint32_t part) {
  assert(baseRadius > 0 || topRadius > 0);
  if (baseRadius < topRadius) return makeConePatch(top, base, topRadius, baseRadius, part);
  return {QuadricPatch::Kind::cone, topRadius / baseRadius, placementAlong(base, top - base, baseRadius), part};
}

}  // namespace goniolux::geometry
