#include "image/comparison.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "core/parallel.h"
#include "spectrum/colour_difference.h"

namespace goniolux::image {
namespace {

spectrum::Xyz pixel(const XyzImage& image, std::size_t i) {
  return {static_cast<double>(image.x[i]), static_cast<double>(image.y[i]), static_cast<double>(image.z[i])};
}

bool isNumber(const XyzImage& image, std::size_t i) {
  return std::isfinite(image.x[i] + image.y[i] + image.z[i]);
}

}  // namespace

Comparison compare(const XyzImage& first, const XyzImage& second, const spectrum::Xyz& white) {
  assert(first.width == second.width && first.height == second.height);
  Comparison result;
  const std::size_t count = first.y.size();
  result.delta.assign(count, std::numeric_limits<float>::quiet_NaN());
  core::parallelFor(count, 1 << 14, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      if (isNumber(first, i) && isNumber(second, i))
        result.delta[i] = static_cast<float>(
            spectrum::deltaE2000(spectrum::lab(pixel(first, i), white), spectrum::lab(pixel(second, i), white)));
  });
  const bool hasHalfWidths = !first.halfWidth.empty() && !second.halfWidth.empty();
  std::vector<float> sorted;
  sorted.reserve(count);
  double squares = 0, sum = 0, luminance = 0, deltas = 0;
  std::size_t within = 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (std::isnan(result.delta[i])) continue;
    const double d = static_cast<double>(second.y[i]) - static_cast<double>(first.y[i]);
    squares += d * d;
    sum += d;
    luminance += static_cast<double>(first.y[i]);
    deltas += static_cast<double>(result.delta[i]);
    result.largestDifference = std::max(result.largestDifference, std::abs(d));
    if (hasHalfWidths)
      within +=
          std::abs(d) <= std::hypot(static_cast<double>(first.halfWidth[i]), static_cast<double>(second.halfWidth[i]));
    sorted.push_back(result.delta[i]);
  }
  result.pixels = sorted.size();
  if (sorted.empty()) return result;
  const auto n = static_cast<double>(sorted.size());
  result.meanLuminance = luminance / n;
  result.luminanceRmse = std::sqrt(squares / n);
  result.luminanceBias = sum / n;
  result.deltaMean = deltas / n;
  const auto p95 = static_cast<std::size_t>(std::ceil(0.95 * n)) - 1;
  std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(p95), sorted.end());
  result.deltaP95 = static_cast<double>(sorted[p95]);
  result.deltaMax = static_cast<double>(*std::max_element(sorted.begin(), sorted.end()));
  if (hasHalfWidths) result.within = static_cast<double>(within) / n;
  return result;
}

XyzImage difference(const XyzImage& first, const XyzImage& second) {
  assert(first.width == second.width && first.height == second.height);
  XyzImage result;
  result.width = first.width;
  result.height = first.height;
  const auto minus = [](const std::vector<float>& a, const std::vector<float>& b) {
    std::vector<float> d(a.size());
    for (std::size_t i = 0; i < a.size(); ++i) d[i] = a[i] - b[i];
    return d;
  };
  result.x = minus(second.x, first.x);
  result.y = minus(second.y, first.y);
  result.z = minus(second.z, first.z);
  return result;
}

}  // namespace goniolux::image
