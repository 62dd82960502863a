#include "core/random.h"

#include <array>
#include <bit>

namespace goniolux::core {
namespace {

constexpr std::uint32_t reverseBits(std::uint32_t x) {
  x = (x << 16) | (x >> 16);
  x = ((x & 0x00ff00ffu) << 8) | ((x & 0xff00ff00u) >> 8);
  x = ((x & 0x0f0f0f0fu) << 4) | ((x & 0xf0f0f0f0u) >> 4);
  x = ((x & 0x33333333u) << 2) | ((x & 0xccccccccu) >> 2);
  return ((x & 0x55555555u) << 1) | ((x & 0xaaaaaaaau) >> 1);
}

// A permutation in which each bit depends on lower bits only: Owen scrambling of the reversed word ([burley20],
// improved constants by N. Vegdahl, 2021).
constexpr std::uint32_t laineKarras(std::uint32_t x, std::uint32_t seed) {
  x ^= x * 0x3d20adeau;
  x += seed;
  x *= (seed >> 16) | 1u;
  x ^= x * 0x05526c56u;
  x ^= x * 0x53a22864u;
  return x;
}

constexpr std::uint32_t owenScramble(std::uint32_t x, std::uint32_t seed) {
  return reverseBits(laineKarras(reverseBits(x), seed));
}

// Generator matrices of the first four Sobol dimensions ([joe-kuo08], new-joe-kuo-6: s, a, m = (1,0,1), (2,1,1 3),
// (3,1,1 3 1)).
struct SobolMatrices {
  std::array<std::array<std::uint32_t, 32>, 4> column{};
  constexpr SobolMatrices() {
    for (unsigned i = 0; i < 32; ++i) column[0][i] = 1u << (31 - i);
    fill(1, 1, 0, {1, 0, 0});
    fill(2, 2, 1, {1, 3, 0});
    fill(3, 3, 1, {1, 3, 1});
  }
  constexpr void fill(unsigned d, unsigned s, unsigned a, std::array<std::uint32_t, 3> m) {
    for (unsigned i = 0; i < 32; ++i) {
      if (i < s) {
        column[d][i] = m[i] << (31 - i);
        continue;
      }
      column[d][i] = column[d][i - s] ^ (column[d][i - s] >> s);
      for (unsigned k = 1; k < s; ++k)
        if ((a >> (s - 1 - k)) & 1u) column[d][i] ^= column[d][i - k];
    }
  }
};
constexpr SobolMatrices sobol;

/// The same matrices for a byte of the index at a time, of the dimensions that have no shorter way.
struct SobolBytes {
  std::array<std::array<std::array<std::uint32_t, 256>, 4>, 2> of{};  // [dimension - 2][byte][its value]
  constexpr SobolBytes() {
    for (unsigned d = 0; d < 2; ++d)
      for (unsigned byte = 0; byte < 4; ++byte)
        for (unsigned value = 1; value < 256; ++value) {
          const auto lowest = static_cast<unsigned>(std::countr_zero(value));
          of[d][byte][value] = of[d][byte][value & (value - 1)] ^ sobol.column[d + 2][8 * byte + lowest];
        }
  }
};
constexpr SobolBytes sobolBytes;

}  // namespace

void Sampler::nextGroup() {
  seed_ = combine(key_, group_++);
  index_ = owenScramble(sample_, static_cast<std::uint32_t>(seed_));
  used_ = 0;
}

double Sampler::value(unsigned d) const {
  const auto scramble = static_cast<std::uint32_t>(mix(seed_ + d + 1) >> 32);
  std::uint32_t reversed;  // of the Sobol point's digits
  if (d == 0) {
    reversed = index_;  // the first matrix is the identity
  } else if (d == 1) {
    // The second is Pascal's triangle modulo 2, which factors into shifts.
    reversed = index_;
    reversed ^= (reversed & 0xaaaaaaaau) >> 1;
    reversed ^= (reversed & 0xccccccccu) >> 2;
    reversed ^= (reversed & 0xf0f0f0f0u) >> 4;
    reversed ^= (reversed & 0xff00ff00u) >> 8;
    reversed ^= (reversed & 0xffff0000u) >> 16;
  } else {
    const auto& bytes = sobolBytes.of[d - 2];
    reversed = reverseBits(bytes[0][index_ & 255] ^ bytes[1][(index_ >> 8) & 255] ^ bytes[2][(index_ >> 16) & 255] ^
                           bytes[3][index_ >> 24]);
  }
  return reverseBits(laineKarras(reversed, scramble)) * 0x1p-32;
}

std::uint64_t keyOf(std::uint64_t seed, const std::string& name) {
  std::uint64_t key = mix(seed);
  for (const char c : name) key = combine(key, static_cast<unsigned char>(c));
  return key;
}

}  // namespace goniolux::core
