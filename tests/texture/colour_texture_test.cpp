// Pictures in colour as spectral reflectances: the colour is met, light is not made, and how far measured finishes of
// the same colour are from it under other lamps.
#include "texture/colour_texture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "core/random.h"
#include "spectrum/cie_data.h"
#include "spectrum/colorimetry.h"
#include "spectrum/colour_difference.h"
#include "spectrum/spectrum_files.h"

namespace goniolux::texture {
namespace {

using spectrum::SpectralDistribution;
using spectrum::Xyz;

// IEC 61966-2-1.
std::array<double, 3> linearSrgb(const Xyz& c) {
  return {3.2404542 * c.X - 1.5371385 * c.Y - 0.4985314 * c.Z, -0.9692660 * c.X + 1.8760108 * c.Y + 0.0415560 * c.Z,
          0.0556434 * c.X - 0.2040259 * c.Y + 1.0572252 * c.Z};
}

TEST(ColourTexture, HasThePicturesColourUnderDaylightAndReflectsNoMoreThanAllLight) {
  const SpectralDistribution d65 = *spectrum::illuminant("CIE D65");
  double worst = 0;
  for (std::uint32_t i = 0; i < 2000; ++i) {
    core::Sampler random(9, i);
    const core::Vec2 u = random.next2();
    std::array<double, 3> rgb{u.x, u.y, random.next()};
    if (i < 8)
      for (std::size_t c = 0; c < 3; ++c) rgb[c] = i >> c & 1;  // the corners of sRGB
    const SpectralDistribution reflectance = mixedReflectance(rgb);
    ASSERT_GE(reflectance.range().first, 0);
    ASSERT_LE(reflectance.range().second, 1 + 1e-12);
    const std::array<double, 3> back = linearSrgb(spectrum::tristimulus(reflectance, d65));
    for (std::size_t c = 0; c < 3; ++c) worst = std::max(worst, std::abs(back[c] - rgb[c]));
  }
  std::printf("largest error of linear sRGB under D65: %.2g\n", worst);
  EXPECT_LT(worst, 2e-3) << "rounding of the published matrices and of the tables' white";
}

TEST(ColourTexture, OfMeasuredFinishesIsWithinTheStatedDifferenceUnderOtherLamps) {
  const SpectralDistribution d65 = *spectrum::illuminant("CIE D65");
  struct Lamp {
    const char* name;
    double mean, worst;  // stated in docs/methods/textures.md
  };
  for (const Lamp& lamp : {Lamp{"CIE A", 1, 3}, Lamp{"CIE FL11", 1.1, 3.6}, Lamp{"CIE D50", 0.35, 1.1}}) {
    const SpectralDistribution light = *spectrum::illuminant(lamp.name);
    double sum = 0, worst = 0, luminous = 0;
    int count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(std::string(GONIOLUX_SOURCE_DIR) + "/materials")) {
      if (entry.path().extension() != ".spd") continue;
      core::Diagnostics ignored;
      const SpectralDistribution measured =
          spectrum::readSpectrumFile(entry.path().string(), spectrum::Role::reflectance, &ignored);
      const std::array<double, 3> rgb = linearSrgb(spectrum::tristimulus(measured, d65));
      if (*std::min_element(rgb.begin(), rgb.end()) < 0 || *std::max_element(rgb.begin(), rgb.end()) > 1) continue;
      const Xyz is = spectrum::tristimulus(measured, light), made = spectrum::tristimulus(mixedReflectance(rgb), light);
      const Xyz white = spectrum::tristimulus(SpectralDistribution::flat(1), light);
      const double difference = spectrum::deltaE2000(spectrum::lab(is, white), spectrum::lab(made, white));
      sum += difference;
      worst = std::max(worst, difference);
      luminous = std::max(luminous, std::abs(made.Y - is.Y));
      ++count;
    }
    std::printf("%s: %d finishes, mean %.2f and largest %.2f CIEDE2000, luminous reflectance within %.4f\n", lamp.name,
                count, sum / count, worst, luminous);
    EXPECT_GT(count, 40);
    EXPECT_LT(sum / count, lamp.mean);
    EXPECT_LT(worst, lamp.worst);
  }
}

TEST(ColourTexture, MixturesOfAPictureAreMadeOfItsOwnComponents) {
  auto picture = std::make_shared<Picture>();
  picture->width = 16, picture->height = 8;
  for (std::uint32_t i = 0; i < 16 * 8; ++i) {
    core::Sampler random(3, i);
    const core::Vec2 u = random.next2();
    for (const double c : {u.x, 0.5 * u.y, 0.2}) picture->codes.push_back(static_cast<std::uint16_t>(255 * c));
  }
  for (int code = 0; code < 256; ++code) picture->linear.push_back(static_cast<float>(code) / 255);
  const ColourTexture texture({.mapping = Projection::Mapping::uv}, picture, 0.9);
  EXPECT_EQ(texture.shareCutOff(), 0);
  double whole = 0;
  for (const double share : texture.meanShares()) whole += share;
  EXPECT_NEAR(whole, 1, 1e-9);
  for (std::uint32_t i = 0; i < 1000; ++i) {
    core::Sampler random(4, i);
    const core::Vec2 uv = random.next2();
    const Mixture mixture = texture.at({{}, {0, 0, 1}, uv});
    const std::array<double, 3> rgb = picture->at(uv);
    for (const double nm : {450.0, 550.0, 650.0}) {
      double sum = 0;
      for (std::uint32_t k = 0; k < mixture.count; ++k) {
        ASSERT_LT(mixture.component[k], texture.reflectances().size());
        sum += static_cast<double>(mixture.share[k]) * texture.reflectances()[mixture.component[k]].continuum(nm);
      }
      EXPECT_NEAR(sum, mixedReflectance({0.9 * rgb[0], 0.9 * rgb[1], 0.9 * rgb[2]}).continuum(nm), 1e-5);
    }
  }
}

}  // namespace
}  // namespace goniolux::texture
