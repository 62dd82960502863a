#include "display/mapping.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/parallel.h"

namespace goniolux::display {
namespace {

// Encodes by table: entry i is the code value of linear light (i / size)^2, so that the dark end, where curves are
// steep, has its share of entries; between entries the curve is as good as straight (error below 0.02 of a 16-bit code
// from the darkest codes on).
class Encoder {
 public:
  Encoder(const TransferCurve& curve, int bits) : largest_(static_cast<float>((1 << bits) - 1)) {
    for (int i = 0; i <= size; ++i) {
      const double root = static_cast<double>(i) / size;
      table_.push_back(static_cast<float>(curve.encode(root * root)) * largest_);
    }
    table_.push_back(table_.back());
  }
  [[nodiscard]] std::uint16_t operator()(float linear) const {
    const float at = std::sqrt(std::clamp(linear, 0.0F, 1.0F)) * static_cast<float>(size);
    const auto index = static_cast<std::size_t>(at);
    const float code = table_[index] + (at - static_cast<float>(index)) * (table_[index + 1] - table_[index]);
    return static_cast<std::uint16_t>(std::lround(code));
  }

 private:
  static constexpr int size = 1 << 15;
  float largest_;
  std::vector<float> table_;
};

}  // namespace

CodeImage mapToDevice(const image::XyzImage& image, const Device& device, const MappingSettings& settings) {
  assert(settings.white_cd_m2 > 0 && (settings.bits == 8 || settings.bits == 16));
  const glm::mat3 toRgb(rgbFromXyz(device, settings.adoptedWhite) / settings.white_cd_m2);
  const Encoder encode(device.transfer, settings.bits);
  const double halfCode = 0.5 / ((1 << settings.bits) - 1);
  const auto darkest = static_cast<float>(-device.transfer.decode(halfCode));
  const auto brightest = static_cast<float>(device.transfer.decode(1 + halfCode));

  constexpr float rounding =
      2e-6F;  // what single precision leaves of a primary that should be 0, relative to the largest

  CodeImage result;
  result.width = image.width;
  result.height = image.height;
  result.bits = settings.bits;
  result.rgb.resize(3 * image.y.size());
  // Counts are kept per piece and added in order: no thread waits for another.
  constexpr std::size_t pieceSize = 65536;
  struct Count {
    std::size_t outOfGamut = 0, clipped = 0, invalid = 0;
  };
  std::vector<Count> counts((image.y.size() + pieceSize - 1) / pieceSize);
  core::parallelFor(counts.size(), 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t piece = first; piece < last; ++piece) {
      Count count;
      const std::size_t end = std::min(image.y.size(), (piece + 1) * pieceSize);
      for (std::size_t i = piece * pieceSize; i < end; ++i) {
        glm::vec3 rgb = toRgb * glm::vec3(image.x[i], image.y[i], image.z[i]);
        if (!std::isfinite(rgb.x) || !std::isfinite(rgb.y) || !std::isfinite(rgb.z)) {
          ++count.invalid;
          rgb = {};
        }
        const float lowest = std::min({rgb.x, rgb.y, rgb.z}), highest = std::max({rgb.x, rgb.y, rgb.z});
        count.outOfGamut += lowest < darkest - rounding * highest;
        count.clipped += highest > brightest;
        for (int c = 0; c < 3; ++c) result.rgb[3 * i + static_cast<std::size_t>(c)] = encode(rgb[c]);
      }
      counts[piece] = count;
    }
  });
  for (const Count& count : counts) {
    result.outOfGamut += count.outOfGamut;
    result.clipped += count.clipped;
    result.invalid += count.invalid;
  }
  return result;
}

}  // namespace goniolux::display
