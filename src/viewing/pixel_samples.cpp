#include "viewing/pixel_samples.h"

#include <algorithm>
#include <limits>
#include <span>

#include "core/statistics.h"

namespace goniolux::viewing {

PixelSamples::PixelSamples(std::size_t pixels, std::uint32_t samplesAtFirst, double confidence)
    : sums_(pixels), done_(pixels, {samplesAtFirst, samplesAtFirst}), confidence_(confidence) {}

void PixelSamples::setComplete(std::size_t count) {
  complete_ = count;
  if (count >= 2) quantile_ = core::studentQuantile(static_cast<double>(count) - 1, confidence_);
}

void PixelSamples::add(std::size_t pixel, std::size_t replicate, const solver::Response& seen, double factor) {
  for (std::size_t c = 0; c < 3; ++c) sums_[pixel][replicate][c] += static_cast<float>(factor * seen[c]);
}

std::uint64_t PixelSamples::samplesOf(std::size_t pixel) const {
  std::uint64_t sum = 0;
  for (std::size_t r = 0; r < complete_; ++r) sum += done_[pixel][halfOf(r)];
  return sum;
}

std::array<double, 3> PixelSamples::mean(std::size_t pixel) const {
  std::array<double, 3> sum{};
  for (std::size_t r = 0; r < complete_; ++r)
    for (std::size_t c = 0; c < 3; ++c) sum[c] += replicate(pixel, r, c);
  for (double& each : sum) each /= static_cast<double>(std::max<std::size_t>(1, complete_));
  return sum;
}

double PixelSamples::halfWidth(std::size_t pixel, std::size_t channel) const {
  if (complete_ < 2) return std::numeric_limits<double>::infinity();  // one replicate says nothing about its error
  std::array<double, replicates> values{};
  for (std::size_t r = 0; r < complete_; ++r) values[r] = replicate(pixel, r, channel);
  return quantile_ * core::replicateMean(std::span(values).first(complete_)).standardError;
}

double PixelSamples::halfWidthBeyond(const PixelSamples& part, std::size_t pixel) const {
  if (complete_ < 2) return std::numeric_limits<double>::infinity();
  std::array<double, replicates> values{};
  for (std::size_t r = 0; r < complete_; ++r) values[r] = replicate(pixel, r, 1) - part.replicate(pixel, r, 1);
  return quantile_ * core::replicateMean(std::span(values).first(complete_)).standardError;
}

// x = X / S, S = X + Y + Z: to first order dx = (dX - x dS) / S, so that what X, Y and Z err together cancels.
std::pair<double, double> PixelSamples::chromaticityHalfWidths(std::size_t pixel) const {
  if (complete_ < 2) return {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  const auto [meanX, meanY, meanZ] = mean(pixel);
  const double S = meanX + meanY + meanZ;
  if (!(S > 0)) return {0, 0};
  const double x = meanX / S, y = meanY / S;
  std::array<double, replicates> dx{}, dy{};
  for (std::size_t r = 0; r < complete_; ++r) {
    const double X = replicate(pixel, r, 0), Y = replicate(pixel, r, 1), sum = X + Y + replicate(pixel, r, 2);
    dx[r] = (X - x * sum) / S;
    dy[r] = (Y - y * sum) / S;
  }
  return {quantile_ * core::replicateMean(std::span(dx).first(complete_)).standardError,
          quantile_ * core::replicateMean(std::span(dy).first(complete_)).standardError};
}

PixelSamples::Half PixelSamples::half(std::size_t pixel, std::size_t half) const {
  std::array<double, perHalf> values{};
  for (std::size_t r = 0; r < perHalf; ++r) values[r] = replicate(pixel, half * perHalf + r, 1);
  const core::ReplicateMean mean = core::replicateMean(values);
  return {mean.mean, quantile_ * quantile_ * mean.standardError * mean.standardError / halves};
}

}  // namespace goniolux::viewing
