// The torus by its equation in extended precision, one million lines: random, grazing and far away.
#include "geometry/torus_intersect.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace goniolux::geometry {
namespace {

using core::Vec3;

constexpr double infinity = std::numeric_limits<double>::infinity();

// Signed distance from the surface.
long double distanceAt(double tube, const Vec3& o, const Vec3& d, long double t) {
  const long double x = o.x + t * d.x, y = o.y + t * d.y, z = o.z + t * d.z;
  const long double across = std::sqrt(x * x + y * y) - 1;
  return std::sqrt(across * across + z * z) - tube;
}

class Lines {
 public:
  explicit Lines(unsigned seed) : generator_(seed) {}
  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(generator_); }
  Vec3 direction() {
    const double z = uniform(-1, 1), phi = uniform(0, 2 * core::pi), r = std::sqrt(1 - z * z);
    return {r * std::cos(phi), r * std::sin(phi), z};
  }
  /// A point of the surface and its normal.
  Vec3 onTorus(double tube, Vec3& normal) {
    const double phi = uniform(0, 2 * core::pi), theta = uniform(0, 2 * core::pi);
    normal = {std::cos(theta) * std::cos(phi), std::cos(theta) * std::sin(phi), std::sin(theta)};
    return Vec3(std::cos(phi), std::sin(phi), 0) + tube * normal;
  }

 private:
  std::mt19937_64 generator_;
};

TEST(Torus, AMillionLinesMeetItWhereItsEquationHoldsInExtendedPrecision) {
  Lines lines(1);
  for (const double tube : {0.001, 0.1, 0.5, 0.999}) {
    long double worst = 0;
    int hits = 0;
    for (int i = 0; i < 250'000; ++i) {
      Vec3 normal;
      const Vec3 target = lines.onTorus(tube, normal) + 0.3 * tube * lines.direction();
      const double away = std::pow(10.0, lines.uniform(-1, 3));
      const Vec3 o = target + away * lines.direction();
      const Vec3 d = (target - o) * lines.uniform(0.01, 10);
      double t[4];
      const int count = intersectTorus(tube, o, d, -infinity, infinity, t);
      ASSERT_EQ(count % 2, 0) << "a line goes in as often as it comes out";
      ASSERT_TRUE(std::is_sorted(t, t + count));
      hits += count;
      for (int k = 0; k < count; ++k)
        worst = std::max(worst, std::abs(distanceAt(tube, o, d, t[k])) / std::max(1.0, glm::length(o)));
    }
    EXPECT_GT(hits, 250'000) << tube;
    EXPECT_LT(static_cast<double>(worst), 1e-15) << tube;
  }
}

TEST(Torus, CrossingsAreAllThatAFineScanFinds) {
  Lines lines(2);
  int four = 0;
  for (int i = 0; i < 3000; ++i) {
    const double tube = lines.uniform(0.05, 0.95);
    Vec3 normal;
    const Vec3 target = lines.onTorus(tube, normal);
    const Vec3 d = lines.direction(), o = target - 3.0 * d;
    int changes = 0;
    long double closest = 1, before = distanceAt(tube, o, d, 0);
    for (int k = 1; k <= 6000; ++k) {
      const long double now = distanceAt(tube, o, d, k * 1e-3L);
      changes += (before < 0) != (now < 0);
      closest = std::min(closest, before < now ? now - before : before - now);
      before = now;
    }
    double t[4];
    const int count = intersectTorus(tube, o, d, 0, 6, t);
    // Two crossings may lie between two points of the scan, never the other way round.
    ASSERT_GE(count, changes);
    if (count > changes) {
      double gap = infinity;
      for (int k = 0; k + 1 < count; ++k) gap = std::min(gap, t[k + 1] - t[k]);
      ASSERT_LT(gap, 1e-3);
    }
    four += count == 4;
  }
  EXPECT_GT(four, 300);
}

TEST(Torus, TangentsAreHitJustInsideAndMissedJustOutside) {
  Lines lines(3);
  for (int i = 0; i < 20'000; ++i) {
    const double tube = lines.uniform(0.05, 0.9);
    Vec3 normal;
    const Vec3 touch = lines.onTorus(tube, normal);
    if (std::hypot(touch.x, touch.y) < 1 + 0.1 * tube) continue;  // where it is convex, a tangent plane touches once
    const Vec3 along = glm::normalize(glm::cross(normal, lines.direction()));
    const double gap = 1e-13, away = lines.uniform(0, 2);
    double t[4];
    ASSERT_GE(intersectTorus(tube, touch - gap * normal - away * along, along, away - 1e-3, away + 1e-3, t), 1);
    ASSERT_EQ(intersectTorus(tube, touch + gap * normal - away * along, along, away - 1e-3, away + 1e-3, t), 0);
  }
}

TEST(Torus, NoRayFromInsideTheTubeStaysInside) {
  Lines lines(4);
  for (int i = 0; i < 300'000; ++i) {
    const double tube = lines.uniform(0.01, 0.99);
    Vec3 normal;
    const Vec3 surface = lines.onTorus(tube, normal);
    const Vec3 o = surface - normal * tube * lines.uniform(0.001, 1);
    double t[4];
    ASSERT_EQ(intersectTorus(tube, o, lines.direction(), 0, infinity, t) % 2, 1);
  }
}

}  // namespace
}  // namespace goniolux::geometry
