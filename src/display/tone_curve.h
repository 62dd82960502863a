// ToneCurve: the luminance that a device shows for a luminance of the scene, as a table over its logarithm.
#pragma once

#include <cmath>
#include <functional>
#include <vector>

namespace goniolux::display {

class ToneCurve {
 public:
  /// `shown`: displayed luminance, 1 = the device's white, for a luminance in cd/m2. Called 64 times a stop.
  explicit ToneCurve(const std::function<double(double)>& shown) {
    factors_.reserve(size + 1);
    for (int i = 0; i <= size; ++i) {
      const double luminance = std::exp2(static_cast<double>(i) / perStop - range);
      factors_.push_back(static_cast<float>(shown(luminance) / luminance));
    }
  }

  /// What X, Y, Z of a pixel of this luminance are multiplied by; that of the ends beyond them.
  [[nodiscard]] float factor(float luminance) const {
    if (!(luminance > lowest)) return factors_.front();
    const float at = std::min((std::log2(luminance) + range) * perStop, static_cast<float>(size) - 0.5F);
    const auto i = static_cast<std::size_t>(at);
    return factors_[i] + (at - static_cast<float>(i)) * (factors_[i + 1] - factors_[i]);
  }

 private:
  static constexpr int perStop = 64, range = 32, size = 2 * range * perStop;
  static constexpr float lowest = 2.4e-10F;  // 2^-32
  std::vector<float> factors_;
};

}  // namespace goniolux::display
