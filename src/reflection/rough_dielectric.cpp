// Ground glass, frosted acrylic, satin-etched panes of solid bodies: GGX facets that reflect and refract.
//
// Single scattering by Walter et al. (EGSR 2007). The light of multiple scattering comes back in a lobe on each side,
// f = n_out^2 K with K = d m(out) m(in) on one side and c m(out) m(in) through, m = 1 - E the light that single
// scattering loses. With M = pi (1 - mean E) on each side the conditions
//   d_a n_a^2 M_a + c n_b^2 M_b = 1,   d_b n_b^2 M_b + c n_a^2 M_a = 1
// give back exactly what was lost, and K is symmetric: reciprocal. c is 0.9 of the largest that keeps both d positive.
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/random.h"
#include "reflection/directions.h"
#include "reflection/fresnel.h"
#include "reflection/ggx.h"
#include "reflection/rough_dielectric.h"

namespace goniolux::reflection {
namespace {

using core::Vec3;

constexpr double throughShare = 0.9;

// Light scattered once, reflected or refracted, by facets between media of this relative index.
AlbedoTable scatteredOnce(const Ggx& ggx, double index) {
  return AlbedoTable([&](double cosine) {
    const double mu = std::max(cosine, 1e-4);
    const Vec3 out(std::sqrt(1 - mu * mu), 0, mu);
    constexpr std::uint32_t samples = 4096;
    double sum = 0;
    for (std::uint32_t i = 0; i < samples; ++i) {
      const Vec3 h = ggx.visibleNormal(out, core::Sampler(0xd1e1, i).next2());
      const double facing = std::clamp(glm::dot(out, h), 0.0, 1.0);
      const double reflected = dielectricReflectance(facing, index).mean();
      const Vec3 mirrored = h * (2 * facing) - out;
      if (mirrored.z > 0) sum += reflected * ggx.seenBoth(mu, mirrored.z) / ggx.seen(mu);
      const Vec3 refracted = (h * facing - out) / index - h * refractedCosine(facing, index);
      if (reflected < 1 && refracted.z < 0) sum += (1 - reflected) * ggx.seen(-refracted.z);
    }
    return sum / samples;
  });
}

class RoughDielectric final : public Bsdf {
 public:
  RoughDielectric(Medium medium, double alpha)
      : Bsdf({.glossy = true, .transmits = true}),
        medium_(std::move(medium)),
        ggx_(alpha),
        intoDenser_(scatteredOnce(ggx_, std::max(index(), 1 / index()))),
        intoThinner_(scatteredOnce(ggx_, std::min(index(), 1 / index()))) {}

  void evaluate(const Vec3& out, const Vec3& in, const Interface& at, float* values) const override {
    std::fill_n(values, nodes(), 0.0f);
    if (out.z <= 0 || in.z == 0) return;
    for (std::size_t k = 0; k < nodes(); ++k) {
      const bool same = k > 0 && at.here(k) == at.here(k - 1) && at.beyond(k) == at.beyond(k - 1);
      values[k] = same ? values[k - 1] : static_cast<float>(value(out, in, at.here(k), at.beyond(k)));
    }
  }

  [[nodiscard]] double density(const Vec3& out, const Vec3& in, const Interface& at) const override {
    if (out.z <= 0 || in.z == 0) return 0;
    const double here = at.here(at.hero), beyond = at.beyond(at.hero);
    const Sides sides = sidesOf(here, beyond);
    const double once = onceShare(sides, out.z), cosine = std::abs(in.z) / core::pi;
    const bool reflects = in.z > 0;
    const double again = (1 - once) * (reflects ? sides.reflectedShare : 1 - sides.reflectedShare) * cosine;
    const Facet facet = facetBetween(out, in, here, beyond);
    if (!facet.valid) return again;
    const double visible = ggx_.visibleDensity(out, facet.normal);
    const double chosen =
        reflects ? facet.reflectance / (4 * facet.outCosine)
                 : (1 - facet.reflectance) * beyond * beyond * facet.inCosine / (facet.denominator * facet.denominator);
    return again + once * visible * chosen;
  }

  bool sample(const Vec3& out, const core::Vec2& given, const Interface& at, BsdfSample& chosen,
              float* weight) const override {
    if (out.z <= 0) return false;
    const double here = at.here(at.hero), beyond = at.beyond(at.hero), relative = beyond / here;
    const Sides sides = sidesOf(here, beyond);
    core::Vec2 u = given;
    // The last bits of a number are independent of its first ones: a third number for the choice at the facet.
    const double third = u.x * 65536 - std::floor(u.x * 65536);
    if (split(onceShare(sides, out.z), u)) {
      const Vec3 h = ggx_.visibleNormal(out, u);
      const double facing = std::clamp(glm::dot(out, h), 0.0, 1.0);
      if (third < dielectricReflectance(facing, relative).mean()) {
        chosen.direction = h * (2 * facing) - out;
        if (chosen.direction.z <= 0) return false;
      } else {
        const double refracted = refractedCosine(facing, relative);
        chosen.direction = glm::normalize((h * facing - out) / relative - h * refracted);
        if (chosen.direction.z >= 0) return false;
      }
    } else {
      const bool reflects = split(sides.reflectedShare, u);
      chosen.direction = cosineDirection(u);
      if (!reflects) chosen.direction.z = -chosen.direction.z;
    }
    if (chosen.direction.z < 0) chosen.scale = 1 / (relative * relative);
    chosen.density = density(out, chosen.direction, at);
    if (!(chosen.density > 0)) return false;
    evaluate(out, chosen.direction, at, weight);
    const auto factor = static_cast<float>(std::abs(chosen.direction.z) / chosen.density);
    for (std::size_t k = 0; k < nodes(); ++k) weight[k] *= factor;
    return true;
  }

  [[nodiscard]] const Medium* medium() const override { return &medium_; }
  [[nodiscard]] double largestReflectance() const override { return 1; }

 protected:
  [[nodiscard]] std::size_t nodes() const override { return medium_.index.size(); }

 private:
  // The lobes of multiple scattering between two media, viewer in the first.
  struct Sides {
    const AlbedoTable *here, *beyond;
    double back, through;   // d and c
    double reflectedShare;  // of the light that single scattering loses
  };
  struct Facet {
    bool valid = false;
    Vec3 normal{0, 0, 1};
    double outCosine = 0, inCosine = 0;  // absolute
    double reflectance = 1, denominator = 1;
  };

  [[nodiscard]] double index() const { return static_cast<double>(medium_.index[medium_.index.size() / 2]); }

  [[nodiscard]] Sides sidesOf(double here, double beyond) const {
    Sides s{};
    s.here = beyond >= here ? &intoDenser_ : &intoThinner_;
    s.beyond = beyond >= here ? &intoThinner_ : &intoDenser_;
    const double a = here * here * core::pi * std::max(1e-9, 1 - s.here->mean()),
                 b = beyond * beyond * core::pi * std::max(1e-9, 1 - s.beyond->mean());
    s.through = throughShare * std::min(1 / a, 1 / b);
    s.reflectedShare = 1 - s.through * b;
    s.back = s.reflectedShare / a;
    return s;
  }
  [[nodiscard]] static double onceShare(const Sides& sides, double cosine) {
    return std::clamp(sides.here->value(cosine), 0.05, 1.0);
  }

  [[nodiscard]] static Facet facetBetween(const Vec3& out, const Vec3& in, double here, double beyond) {
    Facet f;
    Vec3 h = in.z > 0 ? out + in : -(out * here + in * beyond);
    const double length = glm::length(h);
    if (!(length > 1e-12)) return f;
    h /= length;
    if (h.z < 0) h = -h;
    const double o = glm::dot(out, h), i = glm::dot(in, h);
    if (o <= 0 || (in.z > 0 ? i <= 0 : i >= 0)) return f;
    f.normal = h;
    f.outCosine = o;
    f.inCosine = std::abs(i);
    f.reflectance = dielectricReflectance(std::min(o, 1.0), beyond / here).mean();
    f.denominator = beyond * i + here * o;
    f.valid = in.z > 0 || (f.reflectance < 1 && std::abs(f.denominator) > 1e-12);
    return f;
  }

  [[nodiscard]] double value(const Vec3& out, const Vec3& in, double here, double beyond) const {
    const Sides sides = sidesOf(here, beyond);
    const double lost = 1 - sides.here->value(out.z);
    double f = in.z > 0 ? sides.back * lost * (1 - sides.here->value(in.z))
                        : sides.through * lost * (1 - sides.beyond->value(-in.z));
    f *= here * here;
    const Facet facet = facetBetween(out, in, here, beyond);
    if (!facet.valid) return f;
    const double d = ggx_.normals(facet.normal.z), across = std::max(1e-30, out.z * std::abs(in.z));
    if (in.z > 0) return f + facet.reflectance * d * ggx_.seenBoth(out.z, in.z) / (4 * across);
    return f + facet.outCosine * facet.inCosine / across * here * here * (1 - facet.reflectance) * ggx_.seen(out.z) *
                   ggx_.seen(-in.z) * d / (facet.denominator * facet.denominator);
  }

  Medium medium_;
  Ggx ggx_;
  AlbedoTable intoDenser_, intoThinner_;
};

}  // namespace

std::unique_ptr<Bsdf> makeRoughDielectric(Medium medium, double alpha) {
  return std::make_unique<RoughDielectric>(std::move(medium), alpha);
}

}  // namespace goniolux::reflection
