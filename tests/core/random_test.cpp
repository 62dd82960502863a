#include "core/random.h"

#include <gtest/gtest.h>

#include <vector>

namespace goniolux::core {
namespace {

// A (0,m,2)-net in base 2: the first 2^m points of a key put one point into each elementary interval of area 2^-m.
TEST(Sampler, FirstTwoDimensionsFormANetInBaseTwo) {
  for (std::uint64_t key : {1ull, 77ull, 123456789ull}) {
    constexpr int m = 6;
    for (int split = 0; split <= m; ++split) {
      std::vector<int> count(1u << m, 0);
      for (std::uint32_t i = 0; i < (1u << m); ++i) {
        Sampler sampler(key, i);
        const Vec2 u = sampler.next2();
        const auto a = static_cast<unsigned>(u.x * (1 << split)), b = static_cast<unsigned>(u.y * (1 << (m - split)));
        ++count[(a << (m - split)) + b];
      }
      for (int c : count) ASSERT_EQ(c, 1) << "key " << key << " split " << split;
    }
  }
}

TEST(Sampler, IsAFunctionOfKeySampleAndDimensionOnly) {
  Sampler a(5, 3), b(5, 3);
  for (int i = 0; i < 20; ++i) EXPECT_EQ(a.next(), b.next());
}

// Keys are independent: the correlation of 4096 pairs has standard deviation 1/64; 5 sigma.
TEST(Sampler, DifferentKeysAreUncorrelated) {
  double sum = 0;
  for (std::uint64_t key = 0; key < 4096; ++key) {
    Sampler a(combine(1, key), 0), b(combine(2, key), 0);
    sum += (a.next() - 0.5) * (b.next() - 0.5) * 12;
  }
  EXPECT_LT(std::abs(sum / 4096), 5.0 / 64);
}

// Integral of x^2 y^2 z^2 w^2 = 1/81 with 1024 points: scrambled nets reach far below the 1/sqrt(n) of random points
// (0.035/32 = 1e-3).
TEST(Sampler, IntegratesSmoothFunctionsBetterThanRandomPoints) {
  double worst = 0;
  for (std::uint64_t key = 0; key < 20; ++key) {
    double sum = 0;
    for (std::uint32_t i = 0; i < 1024; ++i) {
      Sampler s(mix(key), i);
      double f = 1;
      for (int d = 0; d < 4; ++d) {
        const double u = s.next();
        f *= u * u;
      }
      sum += f;
    }
    worst = std::max(worst, std::abs(sum / 1024 - 1.0 / 81));
  }
  EXPECT_LT(worst, 3e-4);
}

}  // namespace
}  // namespace goniolux::core
