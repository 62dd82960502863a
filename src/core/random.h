// Random numbers for sampling: Owen-scrambled Sobol points as a pure function of (key, sample, dimension), so that no
// number depends on threads or on the order of work. Each key is an independent randomisation: replicates with
// different keys are independent, and within one key the first 2^m samples are well distributed in every group of four
// dimensions.
//
// Method: B. Burley, "Practical Hash-based Owen Scrambling", JCGT 9(4), 2020; direction numbers: S. Joe and F. Kuo,
// 2008.
#pragma once

#include <cstdint>
#include <string>

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

/// The key of what a name stands for, in a run with this seed.
std::uint64_t keyOf(std::uint64_t seed, const std::string& name);

/// The numbers of one sample of one key; each call uses up dimensions.
class Sampler {
 public:
  Sampler(std::uint64_t key, std::uint32_t sample) : key_(key), sample_(sample) {}

  /// Next dimension, in [0, 1).
  double next() {
    if (used_ == 4) nextGroup();
    return value(used_++);
  }
  /// Next two dimensions, from the same group of four (never split over two groups).
  Vec2 next2() {
    if (used_ > 2) nextGroup();
    const Vec2 u(value(used_), value(used_ + 1));
    used_ += 2;
    return u;
  }

 private:
  void nextGroup();
  /// Dimension d of the present group; calculated when asked for: most samples use two of the four.
  [[nodiscard]] double value(unsigned d) const;

  std::uint64_t key_, seed_ = 0;
  std::uint32_t sample_, index_ = 0, group_ = 0;
  unsigned used_ = 4;
};

}  // namespace goniolux::core
