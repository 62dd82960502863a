// Pixel filters: places are distributed as the weights that the filter states.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/random.h"
#include "viewing/pixel_filter.h"

namespace goniolux::viewing {
namespace {

TEST(PixelFilter, TheStandardIsThePixelsOwnSquare) {
  EXPECT_EQ(pixelFilters().front().name, "box");
  const FilterPlaces box(pixelFilters().front());
  EXPECT_FALSE(box.hasLobes());
  EXPECT_EQ(box.positive({0.25, 1}), core::Vec2(-0.25, 0.5));
}

// Moments of the places, signed and weighted, are those of the profile's product, by quadrature: E[1] = 1, E[x] = 0,
// E[x^2] and E[cos(2 pi x / 1.7) cos(2 pi y / 1.3)]. 2^16 scrambled Sobol points; the tolerance is some ten times what
// they leave.
TEST(PixelFilter, EveryOnesPlacesHaveItsMoments) {
  for (const PixelFilter& filter : pixelFilters()) {
    double sum = 0, second = 0, cosineX = 0, cosineY = 0;
    for (int i = 0; i < 20000; ++i) {
      const double x = filter.radius * (2 * (i + 0.5) / 20000 - 1), w = filter.profile(x);
      sum += w, second += w * x * x;
      cosineX += w * std::cos(2 * core::pi * x / 1.7);
      cosineY += w * std::cos(2 * core::pi * x / 1.3);
    }
    const FilterPlaces places(filter);
    constexpr std::uint32_t samples = 1 << 16;
    double mean = 0, square = 0, cosine = 0;
    for (std::uint32_t s = 0; s < samples; ++s) {
      const core::Vec2 u = core::Sampler(7, s).next2();
      const auto add = [&](core::Vec2 p, double weight) {
        ASSERT_LE(std::max(std::abs(p.x), std::abs(p.y)), filter.radius * (1 + 1e-12));
        mean += weight * p.x / samples;
        square += weight * p.x * p.x / samples;
        cosine += weight * std::cos(2 * core::pi * p.x / 1.7) * std::cos(2 * core::pi * p.y / 1.3) / samples;
      };
      add(places.positive(u), places.gain());
      if (places.hasLobes()) add(places.negative(u), 1 - places.gain());
    }
    EXPECT_NEAR(mean, 0, 1e-3) << filter.name;
    EXPECT_NEAR(square, second / sum, 2e-3) << filter.name;
    EXPECT_NEAR(cosine, cosineX * cosineY / (sum * sum), 2e-3) << filter.name;
  }
}

// Negative lobes: Mitchell's with B = C = 1/3; the others have none.
TEST(PixelFilter, OnlyMitchellHasLobes) {
  for (const PixelFilter& filter : pixelFilters())
    EXPECT_EQ(FilterPlaces(filter).hasLobes(), filter.name == "mitchell") << filter.name;
  EXPECT_EQ(findPixelFilter("lanczos"), nullptr);
}

}  // namespace
}  // namespace goniolux::viewing
