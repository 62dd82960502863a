// How long a large image takes: a quarter of 4000 x 3000 pixels, loosely, as test machines are busy.
// `benchmark_display` measures the whole.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "core/parallel.h"
#include "display/display_image.h"
#include "display/picture_file.h"

namespace goniolux::display {
namespace {

TEST(DisplayTime, AQuarterOfTwelveMegapixelsTakesAFewSecondsOfCpuTime) {
  image::XyzImage image;
  image.width = 2000;
  image.height = 1500;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const double noise = 1 + 0.1 * ((x * 7919 + y * 104729) % 1000 / 1000.0 - 0.5);
      image.y.push_back(static_cast<float>(noise * std::pow(10, 2 + 1.75 * std::sin(x / 150.0) * std::cos(y / 205.0))));
      image.x.push_back(image.y.back() * static_cast<float>(0.95 + 0.3 * std::sin(x / 45.0)));
      image.z.push_back(image.y.back() * static_cast<float>(0.9 + 0.6 * std::cos(y / 35.0)));
    }
  const Device device = readDevice("srgb");
  DisplaySettings settings;
  settings.mapping = mappingNamed("ward");
  settings.gamut = GamutMapping::neutral;
  const double start = core::processCpuSeconds();
  const DisplayedImage shown = displayImage(image, device, settings);
  const std::string png = encodePng(shown.codes, device);
  const double cpu = core::processCpuSeconds() - start;
  std::printf("2000 x 1500 pixels: %.2f s CPU, %.1f MB of PNG, %.1f %% out of gamut\n", cpu,
              1e-6 * static_cast<double>(png.size()),
              100 * static_cast<double>(shown.outOfGamut) / static_cast<double>(image.y.size()));
  EXPECT_LT(cpu, 10);  // 0.7 s when idle
  EXPECT_GT(shown.outOfGamut, image.y.size() / 100) << "gamut mapping had work to do";
}

}  // namespace
}  // namespace goniolux::display
