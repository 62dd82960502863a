// Random numbers for sampling: Owen-scrambled Sobol points as a pure function of (key, sample, dimension), so that no
// number depends on threads or on the order of work. Each key is an independent randomisation: replicates with
// different keys are independent, and within one key the first 2^m samples are well distributed in every group of four
// dimensions.
//
// Method: B. Burley, "Practical Hash-based Owen Scrambling", JCGT 9(4), 2020; direction numbers: S. Joe and F. Kuo,
// 2008.
#pragma once

#include <array>
#include <cstdint>

#include "core/vector.h"

namespace goniolux::core {

/// Mixes words into a well distributed 64-bit hash (splitmix64 finaliser, S. Vigna).
constexpr std::uint64_t mix(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15ull;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
  return x ^ (x >> 31);
}
constexpr std::uint64_t combine(std::uint64_t key, std::uint64_t word) {
  return mix(key ^ mix(word));
}

/// The numbers of one sample of one key; each call uses up dimensions.
class Sampler {
 public:
  Sampler(std::uint64_t key, std::uint32_t sample) : key_(key), sample_(sample) {}

  /// Next dimension, in [0, 1).
  double next() {
    if (used_ == 4) refill();
    return values_[used_++];
  }
  /// Next two dimensions, from the same group of four (never split over two groups).
  Vec2 next2() {
    if (used_ > 2) refill();
    const Vec2 u(values_[used_], values_[used_ + 1]);
    used_ += 2;
    return u;
  }

 private:
  void refill();

  std::uint64_t key_;
  std::uint32_t sample_, group_ = 0;
  unsigned used_ = 4;
  std::array<double, 4> values_{};
};

}  // namespace goniolux::core
