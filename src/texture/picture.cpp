#include "texture/picture.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace goniolux::texture {

std::array<double, 3> Picture::pixel(std::int64_t column, std::int64_t row) const {
  const auto within = [](std::int64_t i, std::int64_t count) { return ((i % count) + count) % count; };
  const auto index = static_cast<std::size_t>(within(row, height) * width + within(column, width));
  std::array<double, 3> rgb{};
  for (std::size_t c = 0; c < 3; ++c) rgb[c] = static_cast<double>(linear[codes[3 * index + c]]);
  return rgb;
}

std::array<double, 3> Picture::at(const core::Vec2& place) const {
  const double x = (place.x - std::floor(place.x)) * width - 0.5;
  const double y = (1 - (place.y - std::floor(place.y))) * height - 0.5;
  const double left = std::floor(x), top = std::floor(y), u = x - left, v = y - top;
  std::array<double, 3> sum{};
  for (int k = 0; k < 4; ++k) {
    const int i = k & 1, j = k >> 1;
    const std::array<double, 3> value = pixel(static_cast<std::int64_t>(left) + i, static_cast<std::int64_t>(top) + j);
    const double weight = (i ? u : 1 - u) * (j ? v : 1 - v);
    for (std::size_t c = 0; c < 3; ++c) sum[c] += weight * value[c];
  }
  return sum;
}

double luminanceOf(const std::array<double, 3>& rgb) {
  return 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2];
}

PicturePattern::PicturePattern(std::shared_ptr<const Picture> picture) : picture_(std::move(picture)) {
  for (int row = 0; row < picture_->height; ++row) {
    double sum = 0;
    for (int column = 0; column < picture_->width; ++column) sum += luminanceOf(picture_->pixel(column, row));
    mean_ += sum / picture_->width / picture_->height;
  }
}

double PicturePattern::at(const Place& place) const {
  return std::clamp(luminanceOf(picture_->at(place.flat)), 0.0, 1.0);
}

double PicturePattern::step() const {
  return 0.5 / std::max(picture_->width, picture_->height);
}

}  // namespace goniolux::texture
