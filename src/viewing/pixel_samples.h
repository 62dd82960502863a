// PixelSamples: what the samples of a picture's pixels add up to, as 16 independent replicates of each pixel, and what
// their spread says about its error.
//
// The replicates are two halves of eight. How many samples a half gets is decided from the other half's first ones
// alone, and a pixel's value is the plain mean of its replicates: then no value decides about its own weight, and
// pictures that stop early are as right on average as those that do not. (A rule that looks at the value that it stops
// is biased: up where bright samples widen what is allowed, down where dark ones narrow the spread.)
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "solver/solver.h"

namespace goniolux::viewing {

class PixelSamples {
 public:
  static constexpr std::size_t replicates = 16, halves = 2, perHalf = replicates / halves;

  PixelSamples(std::size_t pixels, std::uint32_t samplesAtFirst, double confidence);

  [[nodiscard]] static std::size_t halfOf(std::size_t replicate) { return replicate / perHalf; }
  [[nodiscard]] std::size_t pixels() const { return sums_.size(); }

  /// X, Y, Z summed over the samples of a replicate.
  using Sum = std::array<float, 3>;
  [[nodiscard]] const Sum& sum(std::size_t pixel, std::size_t replicate) const { return sums_[pixel][replicate]; }
  void setSum(std::size_t pixel, std::size_t replicate, const Sum& sum) { sums_[pixel][replicate] = sum; }

  void add(std::size_t pixel, std::size_t replicate, const solver::Response& seen, double factor);
  /// Samples of each replicate of a half.
  [[nodiscard]] std::uint32_t samples(std::size_t pixel, std::size_t half) const { return done_[pixel][half]; }
  void setSamples(std::size_t pixel, std::size_t half, std::uint32_t count) { done_[pixel][half] = count; }
  [[nodiscard]] std::uint64_t samplesOf(std::size_t pixel) const;
  /// Replicates that every pixel has, while the first samples are taken.
  void setComplete(std::size_t count);
  [[nodiscard]] std::size_t complete() const { return complete_; }

  [[nodiscard]] std::array<double, 3> mean(std::size_t pixel) const;
  [[nodiscard]] double luminance(std::size_t pixel) const { return mean(pixel)[1]; }
  /// Statistical half-width of a channel (0 X, 1 Y, 2 Z); infinite from fewer than two replicates.
  [[nodiscard]] double halfWidth(std::size_t pixel, std::size_t channel) const;
  /// Statistical half-width of the luminance less what `part` holds of it, from the same samples.
  [[nodiscard]] double halfWidthBeyond(const PixelSamples& part, std::size_t pixel) const;
  /// Statistical half-widths of the chromaticity x, y.
  [[nodiscard]] std::pair<double, double> chromaticityHalfWidths(std::size_t pixel) const;

  /// What one half alone says: luminance, and the square of the half-width that the pixel's luminance would have if
  /// both halves were like it.
  struct Half {
    double luminance = 0, squaredHalfWidth = 0;
  };
  [[nodiscard]] Half half(std::size_t pixel, std::size_t half) const;

 private:
  [[nodiscard]] double replicate(std::size_t pixel, std::size_t r, std::size_t channel) const {
    return static_cast<double>(sums_[pixel][r][channel]) / done_[pixel][halfOf(r)];
  }

  std::vector<std::array<Sum, replicates>> sums_;
  std::vector<std::array<std::uint32_t, halves>> done_;  // samples per replicate
  double confidence_;
  double quantile_ = 0;  // Student's, for the replicates that are complete
  std::size_t complete_ = 0;
};

}  // namespace goniolux::viewing
