// Geometry maths: GLM's vectors under the names used everywhere. World frame: right-handed, z up, metres.
// Double outside the hot path; float for transport.
#pragma once

#include <glm/glm.hpp>

namespace goniolux::core {

using Vec2 = glm::dvec2;
using Vec3 = glm::dvec3;
using Mat3 = glm::dmat3;
using Mat4 = glm::dmat4;
using Vec3f = glm::vec3;

inline constexpr double pi = 3.14159265358979323846;
inline constexpr double degree = pi / 180.0;

/// An orthonormal right-handed frame; columns of the local-to-world rotation.
struct Frame {
  Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  [[nodiscard]] Vec3 toWorld(const Vec3& v) const { return x * v.x + y * v.y + z * v.z; }
  [[nodiscard]] Vec3 toLocal(const Vec3& v) const { return {glm::dot(v, x), glm::dot(v, y), glm::dot(v, z)}; }
};

/// A frame whose z is the unit vector `n`; x and y are any perpendicular pair, continuous but at n.z = 0 crossing zero.
/// Duff et al., "Building an Orthonormal Basis, Revisited", JCGT 6(1), 2017.
template <typename V>
inline void perpendiculars(const V& n, V& x, V& y) {
  using T = typename V::value_type;
  const T sign = n.z < T(0) ? T(-1) : T(1);
  const T a = T(-1) / (sign + n.z);
  const T b = n.x * n.y * a;
  x = V(T(1) + sign * n.x * n.x * a, sign * b, -sign * n.x);
  y = V(b, sign + n.y * n.y * a, -n.y);
}

}  // namespace goniolux::core
