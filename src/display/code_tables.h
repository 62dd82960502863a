// CodeTables: device values to code values and back, fast.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/vector.h"
#include "display/device_model.h"

namespace goniolux::display {

/// Encodes by table: entry i is the code value of the device value (i / size)^4, so that the dark end, where curves are
/// steep, has its share of entries; between entries the curve is as good as straight.
class CodeTables {
 public:
  CodeTables(const Device& device, int bits) : largest_(static_cast<float>((1 << bits) - 1)) {
    const auto model = makeModel(device);
    straight_ = !model->isLinear();
    const double half = 0.5 / static_cast<double>(largest_);
    double low = 1e30, high = 1e30;
    for (int c = 0; c < 3; ++c) {
      low = std::min(low, model->decode(c, half));
      high = std::min(high, straight_ ? 1 + half : 2 - model->decode(c, model->encode(c, 1) - half));
      const auto channel = static_cast<std::size_t>(c);
      for (int code = 0; code <= static_cast<int>(largest_); ++code)
        decoded_[channel].push_back(static_cast<float>(model->decode(c, code / static_cast<double>(largest_))));
      if (straight_) continue;
      for (int i = 0; i <= size; ++i) {
        const double root = static_cast<double>(i) / size;
        encoded_[channel].push_back(static_cast<float>(model->encode(c, root * root * root * root)) * largest_);
      }
      encoded_[channel].push_back(encoded_[channel].back());
    }
    darkest = static_cast<float>(-low);
    brightest = static_cast<float>(high);
  }

  [[nodiscard]] std::uint16_t encode(int channel, float value) const {
    const float inside = std::clamp(value, 0.0F, 1.0F);
    if (straight_) return static_cast<std::uint16_t>(inside * largest_ + 0.5F);
    const float at = std::sqrt(std::sqrt(inside)) * static_cast<float>(size);
    const auto i = static_cast<std::size_t>(at);
    const std::vector<float>& table = encoded_[static_cast<std::size_t>(channel)];
    return static_cast<std::uint16_t>(table[i] + (at - static_cast<float>(i)) * (table[i + 1] - table[i]) + 0.5F);
  }
  /// Device values of three code values.
  [[nodiscard]] glm::vec3 decoded(const std::uint16_t* codes) const {
    return {decoded_[0][codes[0]], decoded_[1][codes[1]], decoded_[2][codes[2]]};
  }

  /// Device values below and above which a pixel is off by more than half a code value.
  float darkest = 0, brightest = 1;

 private:
  static constexpr int size = 1 << 15;
  float largest_;
  bool straight_ = false;  // device values are code values
  std::array<std::vector<float>, 3> encoded_, decoded_;
};

}  // namespace goniolux::display
