#include "texture/texture.h"

#include <algorithm>

namespace goniolux::texture {

Mixture PatternTexture::mix(const Place& place) const {
  const double value = std::clamp(pattern_->at(place), 0.0, 1.0);
  Mixture mixture;
  if (value < 1) mixture.add(0, 1 - value);
  if (value > 0) mixture.add(1, value);
  return mixture;
}

}  // namespace goniolux::texture
