// Closed-form ray intersection against the same equations in quadruple precision, at tangents, on surfaces and at all
// sizes.
#include "geometry/quadric_intersect.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "geometry/placement.h"
#include "geometry/round_solid.h"

namespace goniolux::geometry {
namespace {

using core::Vec3;
using Kind = QuadricPatch::Kind;
using Quad = __float128;

constexpr double infinity = std::numeric_limits<double>::infinity();

QuadricPatch canonical(Kind kind, double ratio = 0) {
  QuadricPatch patch;
  patch.kind = kind;
  patch.ratio = ratio;
  return patch;
}

const std::vector<QuadricPatch>& allKinds() {
  static const std::vector<QuadricPatch> patches{canonical(Kind::disc),      canonical(Kind::sphere),
                                                 canonical(Kind::cylinder),  canonical(Kind::cone, 0.0),
                                                 canonical(Kind::cone, 0.4), canonical(Kind::cone, 0.999)};
  return patches;
}

Quad squareRoot(Quad value) {
  if (value <= 0) return 0;
  Quad root = std::sqrt(static_cast<long double>(value));
  for (int i = 0; i < 3; ++i) root = (root + value / root) / 2;
  return root;
}

// Textbook quadratic, but with 113 bits: the reference. `margin` tells how clearly the answer is what it is: the least
// of discriminant, distance of a root's height from the ends (or of a disc's point from its rim) and t's own
// size.
struct Reference {
  int count = 0;
  Quad t[2] = {0, 0};
  double margin = infinity;
};

Reference reference(const QuadricPatch& patch, const Vec3& origin, const Vec3& direction) {
  const Quad ox = origin.x, oy = origin.y, oz = origin.z, dx = direction.x, dy = direction.y, dz = direction.z;
  Reference result;
  const auto keep = [&](Quad distance) {
    result.margin = std::min(result.margin, std::abs(static_cast<double>(distance)));
  };
  if (patch.kind == Kind::disc) {
    const Quad t = -oz / dz, x = ox + t * dx, y = oy + t * dy;
    keep(1 - (x * x + y * y));
    keep(t * glm::length(direction));
    if (t > 0 && x * x + y * y <= 1) result.t[result.count++] = t;
    return result;
  }
  const Quad s = patch.kind == Kind::cone ? Quad(patch.ratio) - 1 : Quad(0);
  Quad a = dx * dx + dy * dy, b = ox * dx + oy * dy, c = ox * ox + oy * oy;
  if (patch.kind == Kind::sphere) {
    a += dz * dz, b += oz * dz, c += oz * oz - 1;
  } else {
    a -= s * s * dz * dz, b -= (1 + s * oz) * s * dz, c -= (1 + s * oz) * (1 + s * oz);
  }
  const Quad discriminant = b * b - a * c;
  keep(discriminant / (dx * dx + dy * dy + dz * dz));
  if (discriminant < 0) return result;
  const Quad root = squareRoot(discriminant);
  Quad roots[2] = {(-b - root) / a, (-b + root) / a};
  if (roots[0] > roots[1]) std::swap(roots[0], roots[1]);
  for (const Quad t : roots) {
    const Quad z = oz + t * dz;
    if (patch.kind != Kind::sphere) {
      keep(z);
      keep(z - 1);
      if (z < 0 || z > 1) continue;
    }
    keep(t * glm::length(direction));
    if (t > 0) result.t[result.count++] = t;
  }
  return result;
}

double residual(const QuadricPatch& patch, const Vec3& origin, const Vec3& direction, double t) {
  const long double x = origin.x + static_cast<long double>(t) * direction.x;
  const long double y = origin.y + static_cast<long double>(t) * direction.y;
  const long double z = origin.z + static_cast<long double>(t) * direction.z;
  switch (patch.kind) {
    case Kind::disc:
      return static_cast<double>(std::abs(z));
    case Kind::sphere:
      return static_cast<double>(std::abs(x * x + y * y + z * z - 1));
    case Kind::cylinder:
      return static_cast<double>(std::abs(x * x + y * y - 1));
    case Kind::cone:
    case Kind::torus:    // torus_intersect_test.cpp
    case Kind::quadric:  // registry_test.cpp
      break;
  }
  const long double radius = 1 + (patch.ratio - 1.0L) * z;
  return static_cast<double>(std::abs(x * x + y * y - radius * radius));
}

class Rays {
 public:
  explicit Rays(unsigned seed) : generator_(seed) {}
  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(generator_); }
  Vec3 direction() {
    const double z = uniform(-1, 1), phi = uniform(0, 2 * core::pi), r = std::sqrt(1 - z * z);
    return {r * std::cos(phi), r * std::sin(phi), z};
  }
  Vec3 inCube(double half) { return {uniform(-half, half), uniform(-half, half), uniform(-half, half)}; }

 private:
  std::mt19937_64 generator_;
};

TEST(QuadricIntersection, AgreesWithQuadruplePrecisionOnAMillionRays) {
  Rays rays(1);
  constexpr int raysPerKind = 170'000;
  for (const QuadricPatch& patch : allKinds()) {
    int hits = 0, tooClose = 0;
    double worst = 0, worstT = 0;
    for (int i = 0; i < raysPerKind; ++i) {
      const double distance = std::pow(10.0, rays.uniform(-1, 3));
      const Vec3 origin = rays.inCube(distance);
      // Aimed near the patch from far away, anywhere from close by.
      const Vec3 target = Vec3(0, 0, 0.5) + rays.inCube(1.5);
      const Vec3 direction = (target - origin) * std::pow(10.0, rays.uniform(-3, 3));
      double t[mostCrossings];
      const int count = intersectAll(patch, origin, direction, 0, infinity, t);
      for (int k = 0; k < count; ++k) {
        worst = std::max(worst, residual(patch, origin, direction, t[k]) / std::max(1.0, glm::length(origin)));
      }
      const Reference expected = reference(patch, origin, direction);
      if (expected.margin < 1e-8) {
        ++tooClose;
        continue;
      }
      ASSERT_EQ(count, expected.count) << "kind " << int(patch.kind) << " ray " << i;
      hits += count;
      for (int k = 0; k < count; ++k) {
        const double exact = static_cast<double>(expected.t[k]);
        worstT = std::max(worstT, std::abs(t[k] - exact) * glm::length(direction) / std::max(1.0, glm::length(origin)));
      }
    }
    EXPECT_GT(hits, raysPerKind / 20);
    EXPECT_LT(tooClose, raysPerKind / 1000) << "only a few rays may be excused";
    EXPECT_LT(worst, 1e-14) << "residual of the implicit equation, kind " << int(patch.kind) << " ratio "
                            << patch.ratio;
    EXPECT_LT(worstT, 1e-11) << "kind " << int(patch.kind) << " ratio " << patch.ratio;
  }
}

TEST(QuadricIntersection, HitsFromAMillionRadiiAwayLieOnTheSurface) {
  Rays rays(2);
  for (const QuadricPatch& patch : allKinds()) {
    int hits = 0;
    for (int i = 0; i < 20'000; ++i) {
      const Vec3 origin = 1e6 * rays.direction();
      const Vec3 target = Vec3(0, 0, patch.kind == Kind::disc ? 0 : 0.3) + rays.inCube(0.3);
      double t = 0;
      if (!intersect(patch, origin, target - origin, 0, infinity, t)) continue;
      ++hits;
      // One ulp of 1e6 is 1.2e-10: the ray itself is no sharper.
      ASSERT_LT(residual(patch, origin, target - origin, t), 2e-9);
    }
    EXPECT_GT(hits, 10'000);
  }
}

TEST(QuadricIntersection, ARayFromTheSurfaceFindsTheOtherSideWithoutFindingItself) {
  Rays rays(3);
  const QuadricPatch sphere = canonical(Kind::sphere);
  for (int i = 0; i < 100'000; ++i) {
    const Vec3 origin = rays.direction();
    Vec3 inward = rays.direction();
    if (glm::dot(inward, origin) > 0) inward = -inward;
    const double chord = -2 * glm::dot(origin, inward);  // from a point of the unit sphere
    if (chord < 1e-3) continue;  // the point's own rounding, 1e-16, moves the near root by 1e-16 / chord
    double t = 0;
    ASSERT_TRUE(intersect(sphere, origin, inward, 1e-12, infinity, t));
    ASSERT_NEAR(t, chord, 4e-15 + 1e-15 / chord);
    ASSERT_FALSE(intersect(sphere, origin, -inward, 1e-9, infinity, t));
  }
}

TEST(QuadricIntersection, TangentsAreHitJustInsideAndMissedJustOutside) {
  Rays rays(4);
  for (const double distance : {0.1, 10.0, 1e4}) {
    for (int i = 0; i < 10'000; ++i) {
      const Vec3 normal = rays.direction();
      const Vec3 along = glm::normalize(glm::cross(normal, rays.direction()));
      // Coordinates carry an ulp of the distance, and the gap must stand above it.
      const double gap = 1e-13 + 8 * distance * std::numeric_limits<double>::epsilon();
      double t = 0;
      const Vec3 inside = (1 - gap) * normal - distance * along, outside = (1 + gap) * normal - distance * along;
      ASSERT_TRUE(intersect(canonical(Kind::sphere), inside, along, -infinity, infinity, t)) << distance;
      ASSERT_NEAR(t, distance, 2 * std::sqrt(2 * gap));
      ASSERT_FALSE(intersect(canonical(Kind::sphere), outside, along, -infinity, infinity, t)) << distance;
    }
  }
}

TEST(QuadricIntersection, RaysInASurfaceMissItAndRaysBesideItsAxisAreFinite) {
  double t = 0;
  EXPECT_FALSE(intersect(canonical(Kind::cylinder), {1, 0, -1}, {0, 0, 1}, 0, infinity, t));
  EXPECT_FALSE(intersect(canonical(Kind::cylinder), {0.5, 0, -1}, {0, 0, 1}, 0, infinity, t));
  EXPECT_FALSE(intersect(canonical(Kind::disc), {-5, 0, 0}, {1, 0, 0}, 0, infinity, t));
  // Along a generator of the cone x^2 + y^2 = (1 - z)^2: one root is at infinity.
  ASSERT_TRUE(intersect(canonical(Kind::cone), {0, 0, 0}, {1, 0, -1e-300}, 0, infinity, t));
  EXPECT_DOUBLE_EQ(t, 1);
  ASSERT_TRUE(intersect(canonical(Kind::cone), {0, 0, 0.5}, {1, 0, 1}, 0, infinity, t));
  EXPECT_DOUBLE_EQ(t, 0.25);
  ASSERT_TRUE(intersect(canonical(Kind::cone), {0, 0, 0.5}, {1, 0, -1}, 0, infinity, t) == false)
      << "parallel to a generator, going to the open base";
}

TEST(QuadricIntersection, TheRangeIsOpenAndTheFarSideIsFoundWhenTheNearIsCutOff) {
  const QuadricPatch sphere = canonical(Kind::sphere);
  double t = 0;
  ASSERT_TRUE(intersect(sphere, {-3, 0, 0}, {1, 0, 0}, 0, infinity, t));
  EXPECT_DOUBLE_EQ(t, 2);
  ASSERT_TRUE(intersect(sphere, {-3, 0, 0}, {1, 0, 0}, 2, infinity, t));
  EXPECT_DOUBLE_EQ(t, 4);
  EXPECT_FALSE(intersect(sphere, {-3, 0, 0}, {1, 0, 0}, 2, 4, t));
  EXPECT_FALSE(intersect(sphere, {-3, 0, 0}, {0, 0, 0}, 0, infinity, t)) << "a ray without direction";
}

TEST(QuadricIntersection, NoRayEscapesFromAClosedCylinderOrFrustum) {
  Rays rays(5);
  for (const double topRadius : {0.0, 0.3, 1.0}) {
    const Shape solid = makeRoundSolid({0, 0, 0}, {0, 0, 1}, 1, topRadius, Caps::both);
    for (int i = 0; i < 300'000; ++i) {
      const double z = rays.uniform(0.001, 0.9), r = 0.999 * (1 + (topRadius - 1) * z);
      const double phi = rays.uniform(0, 2 * core::pi), radial = r * std::sqrt(rays.uniform(0, 1));
      const Vec3 origin(radial * std::cos(phi), radial * std::sin(phi), z);
      Vec3 direction = rays.direction();
      if (i % 2 == 0) {  // exactly at a rim, where caps and side meet
        const double end = i % 4 == 0 ? 0.0 : 1.0, rim = end == 0 ? 1.0 : topRadius;
        const double at = rays.uniform(0, 2 * core::pi);
        direction = Vec3(rim * std::cos(at), rim * std::sin(at), end) - origin;
      }
      bool hit = false;
      for (const QuadricPatch& patch : solid.patches) {
        const core::Mat4 inverse = glm::inverse(patch.placement);
        double t = 0;
        hit = hit || intersect(patch, Vec3(inverse * glm::dvec4(origin, 1)), Vec3(inverse * glm::dvec4(direction, 0)),
                               0, infinity, t);
      }
      ASSERT_TRUE(hit) << "top radius " << topRadius << " ray " << i;
    }
  }
}

TEST(QuadricIntersection, SizesFromAMillimetreToAHundredKilometresGiveTheSameRelativeAccuracy) {
  Rays rays(6);
  for (const double size : {1e-3, 1.0, 1e5}) {
    const Vec3 base = size * Vec3(0.3, -0.2, 0.1), top = size * Vec3(1.1, 0.4, 0.9);
    const QuadricPatch patch = makeCylinderPatch(base, top, 0.05 * size, 0);
    const core::Mat4 inverse = glm::inverse(patch.placement);
    const Vec3 axis = glm::normalize(top - base);
    int hits = 0;
    for (int i = 0; i < 50'000; ++i) {
      const Vec3 origin = size * rays.inCube(3);
      const Vec3 target = base + rays.uniform(0, 1) * (top - base) + 0.04 * size * rays.direction();
      const Vec3 direction = target - origin;
      double t = 0;
      if (!intersect(patch, Vec3(inverse * glm::dvec4(origin, 1)), Vec3(inverse * glm::dvec4(direction, 0)), 0,
                     infinity, t)) {
        continue;
      }
      ++hits;
      const Vec3 p = origin + t * direction - base;
      ASSERT_NEAR(glm::length(p - glm::dot(p, axis) * axis) / (0.05 * size), 1, 1e-12);
    }
    EXPECT_GT(hits, 40'000);
  }
}

TEST(QuadricNormal, IsTheGradientOfTheImplicitSurface) {
  Rays rays(7);
  for (const QuadricPatch& patch : allKinds()) {
    for (int i = 0; i < 1000; ++i) {
      const double z = rays.uniform(0.01, 0.99), phi = rays.uniform(0, 2 * core::pi);
      Vec3 point = rays.direction();
      if (patch.kind == Kind::disc) point = {0.5 * std::cos(phi), 0.5 * std::sin(phi), 0};
      if (patch.kind == Kind::cylinder || patch.kind == Kind::cone) {
        const double r = patch.kind == Kind::cone ? 1 + (patch.ratio - 1) * z : 1;
        point = {r * std::cos(phi), r * std::sin(phi), z};
      }
      const Vec3 normal = glm::normalize(canonicalNormal(patch, point));
      // The implicit function rises along the normal and is flat across it.
      const Vec3 tangent = glm::normalize(glm::cross(normal, rays.direction()));
      const double h = 1e-5;
      const auto value = [&](const Vec3& p) {
        if (patch.kind == Kind::disc) return p.z;
        if (patch.kind == Kind::sphere) return glm::dot(p, p) - 1;
        const double r = patch.kind == Kind::cone ? 1 + (patch.ratio - 1) * p.z : 1;
        return p.x * p.x + p.y * p.y - r * r;
      };
      ASSERT_GT(value(point + h * normal), 0);
      ASSERT_LT(value(point - h * normal), 0);
      ASSERT_NEAR((value(point + h * tangent) - value(point - h * tangent)) / (2 * h), 0, 1e-8);
    }
  }
  EXPECT_GT(glm::length(canonicalNormal(canonical(Kind::cone), {0, 0, 1})), 0) << "apex";
}

TEST(QuadricBounds, HoldTheSurfaceTightlyUnderRotationAndScaling) {
  Rays rays(8);
  core::Mat4 transform{1.0};
  transform[0] = {0.8, 0.6, 0, 0};
  transform[1] = {-1.2, 1.6, 0.3, 0};
  transform[2] = {0.2, -0.1, 1.5, 0};
  transform[3] = {10, -20, 30, 1};
  for (const QuadricPatch& patch : allKinds()) {
    const Bounds bounds = boundsOf(patch, transform);
    Bounds sampled;
    for (int i = 0; i < 200'000; ++i) {
      const double z = i % 2 ? rays.uniform(0, 1) : double(i / 2 % 2), phi = rays.uniform(0, 2 * core::pi);
      Vec3 point = rays.direction();
      if (patch.kind != Kind::sphere) {
        const double r = patch.kind == Kind::cone ? 1 + (patch.ratio - 1) * z : 1;
        point = {r * std::cos(phi), r * std::sin(phi), patch.kind == Kind::disc ? 0 : z};
      }
      sampled.add(Vec3(transform * glm::dvec4(point, 1)));
    }
    EXPECT_TRUE(bounds.contains(sampled.min, 1e-12) && bounds.contains(sampled.max, 1e-12));
    EXPECT_LT(glm::length(bounds.min - sampled.min) + glm::length(bounds.max - sampled.max), 0.02) << int(patch.kind);
  }
}

}  // namespace
}  // namespace goniolux::geometry
