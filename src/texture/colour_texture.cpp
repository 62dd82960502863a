#include "texture/colour_texture.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "spectrum/smooth_reflectance.h"

namespace goniolux::texture {

using spectrum::SpectralDistribution;

namespace {

// Finer where colours are dark: steps of equal lightness, roughly.
constexpr std::array<double, 5> levels{0, 0.0625, 0.25, 0.5625, 1};
constexpr std::size_t side = levels.size(), nodes = side * side * side;
constexpr std::uint32_t unused = 0xffffffffu;

struct Share {
  std::size_t node = 0;
  double weight = 0;
};
struct Shares {
  std::array<Share, 8> all;
  std::size_t count = 0;
  [[nodiscard]] const Share* begin() const { return all.data(); }
  [[nodiscard]] const Share* end() const { return all.data() + count; }
};

// The corners of the lattice cell about a colour and their trilinear weights; those of weight 0 are left out.
Shares sharesOf(const std::array<double, 3>& linear) {
  std::array<std::size_t, 3> low{};
  std::array<double, 3> t{};
  for (std::size_t c = 0; c < 3; ++c) {
    const double x = std::clamp(linear[c], 0.0, 1.0);
    while (low[c] + 2 < side && levels[low[c] + 1] <= x) ++low[c];
    t[c] = (x - levels[low[c]]) / (levels[low[c] + 1] - levels[low[c]]);
  }
  Shares shares;
  for (std::size_t k = 0; k < 8; ++k) {
    double weight = 1;
    std::size_t node = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const bool up = (k >> c & 1) != 0;
      weight *= up ? t[c] : 1 - t[c];
      node = node * side + low[c] + (up ? 1 : 0);
    }
    if (weight > 0) shares.all[shares.count++] = {node, weight};
  }
  return shares;
}

double encoded(double linear) {  // IEC 61966-2-1
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

SpectralDistribution reflectanceOf(std::size_t node) {
  std::array<double, 3> rgb{};
  for (std::size_t c = 3; c-- > 0; node /= side) rgb[c] = encoded(levels[node % side]);
  auto reflectance = spectrum::reflectanceFromSrgb(rgb);
  assert(reflectance);  // every colour of sRGB is that of a reflectance: tests/texture tries all nodes
  return *reflectance;
}

}  // namespace

ColourTexture::ColourTexture(const Projection& projection, std::shared_ptr<const Picture> picture, double scale)
    : Texture(projection), picture_(std::move(picture)), scale_(scale), componentOfNode_(nodes, unused) {
  std::vector<double> sums(nodes, 0.0);
  std::array<double, 3> low{1, 1, 1}, high{0, 0, 0};
  const double pixels = static_cast<double>(picture_->width) * picture_->height;
  for (int row = 0; row < picture_->height; ++row)
    for (int column = 0; column < picture_->width; ++column) {
      std::array<double, 3> rgb = picture_->pixel(column, row);
      bool cut = false;
      for (std::size_t c = 0; c < 3; ++c) {
        cut = cut || scale_ * rgb[c] > 1 + 1e-9;
        rgb[c] = std::min(1.0, scale_ * rgb[c]);
        low[c] = std::min(low[c], rgb[c]);
        high[c] = std::max(high[c], rgb[c]);
      }
      cutOff_ += cut ? 1 / pixels : 0;
      for (const Share& share : sharesOf(rgb)) sums[share.node] += share.weight / pixels;
    }
  // Colours between two pixels may lie in a cell that no pixel touches: the nodes of every cell between the extremes.
  for (std::size_t node = 0; node < nodes; ++node) {
    bool within = true;
    std::size_t rest = node;
    for (std::size_t c = 3; c-- > 0; rest /= side) {
      const std::size_t i = rest % side;
      within = within && (i + 1 >= side || levels[i + 1] > low[c]) && (i == 0 || levels[i - 1] < high[c]);
    }
    if (!within && sums[node] <= 0) continue;
    componentOfNode_[node] = static_cast<std::uint32_t>(reflectances_.size());
    reflectances_.push_back(reflectanceOf(node));
    meanShares_.push_back(sums[node]);
  }
}

Mixture ColourTexture::mixtureOf(const std::array<double, 3>& linear) const {
  Mixture mixture;
  for (const Share& share : sharesOf({scale_ * linear[0], scale_ * linear[1], scale_ * linear[2]}))
    mixture.add(componentOfNode_[share.node], share.weight);
  return mixture;
}

SpectralDistribution mixedReflectance(const std::array<double, 3>& linear) {
  std::vector<SpectralDistribution::Sample> samples;
  for (int nm = 360; nm <= 830; nm += 10) samples.push_back({static_cast<double>(nm), 0});
  for (const Share& share : sharesOf(linear)) {
    const SpectralDistribution part = reflectanceOf(share.node);
    for (auto& sample : samples) sample.value += share.weight * part.continuum(sample.wavelength);
  }
  return SpectralDistribution::sampled(std::move(samples), SpectralDistribution::Outside::hold);
}

}  // namespace goniolux::texture
