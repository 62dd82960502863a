// Picture: an image file's values as light, for textures. Decoded elsewhere (display/picture_file.h).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "texture/pattern.h"

namespace goniolux::texture {

/// sRGB code values, row by row from the top; `linear[code]` is the linear value 0..1 (IEC 61966-2-1).
struct Picture {
  int width = 0, height = 0;
  std::vector<std::uint16_t> codes;  ///< 3 * width * height
  std::vector<float> linear;

  /// Linear R, G, B of a pixel; columns and rows go round.
  [[nodiscard]] std::array<double, 3> pixel(std::int64_t column, std::int64_t row) const;
  /// Between the four nearest pixels' centres; `place` in repeats, v = 0 at the lower edge.
  [[nodiscard]] std::array<double, 3> at(const core::Vec2& place) const;
};

/// Relative luminance of linear sRGB (IEC 61966-2-1), 0..1.
double luminanceOf(const std::array<double, 3>& rgb);

/// The luminance of a picture as a pattern: white is 1.
class PicturePattern final : public Pattern {
 public:
  explicit PicturePattern(std::shared_ptr<const Picture> picture);
  [[nodiscard]] double at(const Place& place) const override;
  [[nodiscard]] double mean() const override { return mean_; }
  [[nodiscard]] double step() const override;

 private:
  std::shared_ptr<const Picture> picture_;
  double mean_ = 0;
};

}  // namespace goniolux::texture
