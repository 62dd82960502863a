#include "reflection/ggx.h"

#include <algorithm>

#include "core/random.h"

namespace goniolux::reflection {

using core::Vec3;

Vec3 Ggx::visibleNormal(const Vec3& out, const core::Vec2& u) const {
  // Stretched, the facets are those of a sphere; its visible half is a disc and a half-ellipse.
  const Vec3 stretched = glm::normalize(Vec3(alpha_ * out.x, alpha_ * out.y, out.z));
  const double across = stretched.x * stretched.x + stretched.y * stretched.y;
  const Vec3 x = across > 0 ? Vec3(-stretched.y, stretched.x, 0) / std::sqrt(across) : Vec3(1, 0, 0);
  const Vec3 y = glm::cross(stretched, x);
  const double r = std::sqrt(u.x), angle = 2 * core::pi * u.y;
  const double p = r * std::cos(angle), s = 0.5 * (1 + stretched.z);
  const double q = (1 - s) * std::sqrt(std::max(0.0, 1 - p * p)) + s * r * std::sin(angle);
  const Vec3 normal = x * p + y * q + stretched * std::sqrt(std::max(0.0, 1 - p * p - q * q));
  return glm::normalize(Vec3(alpha_ * normal.x, alpha_ * normal.y, std::max(1e-12, normal.z)));
}

AlbedoTable reflectionAlbedo(const Ggx& ggx) {
  return AlbedoTable([&](double cosine) {
    const double mu = std::max(cosine, 1e-5);
    const Vec3 out(std::sqrt(1 - mu * mu), 0, mu);
    constexpr std::uint32_t samples = 4096;
    double sum = 0;
    for (std::uint32_t i = 0; i < samples; ++i) {
      const Vec3 h = ggx.visibleNormal(out, core::Sampler(0xa1bed0, i).next2());
      const Vec3 in = h * (2 * glm::dot(out, h)) - out;
      // f cos / density = G2 / G1
      if (in.z > 0) sum += ggx.seenBoth(mu, in.z) / ggx.seen(mu);
    }
    return sum / samples;
  });
}

}  // namespace goniolux::reflection
