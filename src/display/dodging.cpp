#include "display/dodging.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "core/parallel.h"

namespace goniolux::display {
namespace {

constexpr int scales = 8;
constexpr double ratio = 1.6;                  // of one scale to the next, and of surround to centre
constexpr double alpha = 0.35355339059327373;  // 1 / (2 sqrt 2): the centre of scale s has variance (alpha s)^2 / 2
constexpr std::size_t rowsAtOnce = 8;

using Plane = std::vector<float>;

// Their equation 5: exp(-(x^2 + y^2) / (alpha s)^2), to three standard deviations.
std::vector<float> kernel(double s) {
  const double width = alpha * s;
  const int reach = std::max(1, static_cast<int>(std::ceil(3 * width / std::sqrt(2.0))));
  std::vector<double> weights;
  double sum = 0;
  for (int x = -reach; x <= reach; ++x) sum += weights.emplace_back(std::exp(-(x * x) / (width * width)));
  std::vector<float> result;
  for (const double weight : weights) result.push_back(static_cast<float>(weight / sum));
  return result;
}

void forRows(int height, const auto& work) {
  core::parallelFor(static_cast<std::size_t>(height), rowsAtOnce, [&](std::size_t begin, std::size_t end) {
    for (std::size_t y = begin; y < end; ++y) work(static_cast<int>(y));
  });
}

// Separable; rows first. Each tap is a whole row, so that the compiler makes vector code.
void blur(const Plane& from, Plane& to, Plane& between, int width, int height, double s) {
  const std::vector<float> weights = kernel(s);
  const int reach = static_cast<int>(weights.size() / 2);
  const auto columns = static_cast<std::size_t>(width);
  forRows(height, [&](int y) {
    const float* row = from.data() + static_cast<std::size_t>(y) * columns;
    Plane wide(columns + 2 * static_cast<std::size_t>(reach));
    for (std::size_t x = 0; x < wide.size(); ++x) wide[x] = row[std::clamp(static_cast<int>(x) - reach, 0, width - 1)];
    float* out = between.data() + static_cast<std::size_t>(y) * columns;
    std::fill_n(out, columns, 0.0F);
    for (std::size_t k = 0; k < weights.size(); ++k)
      for (std::size_t x = 0; x < columns; ++x) out[x] += weights[k] * wide[x + k];
  });
  forRows(height, [&](int y) {
    float* out = to.data() + static_cast<std::size_t>(y) * columns;
    std::fill_n(out, columns, 0.0F);
    for (int k = -reach; k <= reach; ++k) {
      const float weight = weights[static_cast<std::size_t>(k + reach)];
      const float* row = between.data() + static_cast<std::size_t>(std::clamp(y + k, 0, height - 1)) * columns;
      for (std::size_t x = 0; x < columns; ++x) out[x] += weight * row[x];
    }
  });
}

}  // namespace

std::vector<float> localAdaptation(const std::vector<float>& luminance, int width, int height,
                                   const DodgingSettings& settings) {
  Plane input = luminance;
  for (float& value : input)
    if (!(value > 0) || !std::isfinite(value)) value = 0;
  Plane centre(input.size()), surround(input.size()), between(input.size());
  std::vector<char> settled(input.size(), 0);  // an edge came into the neighbourhood: the last scale stays
  double s = 1;
  blur(input, centre, between, width, height, s);
  Plane result = centre;  // the smallest neighbourhood, where even that is cut by an edge
  const auto columns = static_cast<std::size_t>(width);
  for (int i = 0; i < scales; ++i, s *= ratio) {
    blur(input, surround, between, width, height, ratio * s);
    const auto bend = static_cast<float>(std::exp2(settings.sharpness) * settings.key / (s * s));
    const auto threshold = static_cast<float>(settings.threshold);
    forRows(height, [&](int y) {
      const std::size_t begin = static_cast<std::size_t>(y) * columns;
      for (std::size_t p = begin; p < begin + columns; ++p) {
        if (settled[p] != 0) continue;
        // Equation 7.
        if (std::abs((centre[p] - surround[p]) / (bend + centre[p])) < threshold)
          result[p] = centre[p];
        else
          settled[p] = 1;
      }
    });
    std::swap(centre, surround);
  }
  return result;
}

}  // namespace goniolux::display
