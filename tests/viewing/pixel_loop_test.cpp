// The pixel loop's decisions, on pictures whose every pixel is known: no bias from stopping, edges divided, limits
// kept.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <functional>

#include "core/progress.h"
#include "core/random.h"
#include "core/statistics.h"
#include "viewing/pixel_loop.h"

namespace goniolux::viewing {
namespace {

using core::Vec3;

/// A solver that sees what a function says, at image coordinates of the view below, with a random number.
class Painted final : public solver::Solver {
 public:
  using Paint = std::function<double(double x, double y, double random)>;
  explicit Painted(Paint paint) : paint_(std::move(paint)) {}
  [[nodiscard]] std::unique_ptr<solver::ReceiverPlan> plan(const solver::Receiver&, std::uint64_t) const override {
    return std::make_unique<solver::ReceiverPlan>();
  }
  [[nodiscard]] solver::Response illuminance(const solver::Receiver&, const solver::ReceiverPlan&, std::uint64_t,
                                             std::uint32_t) const override {
    return {};
  }
  [[nodiscard]] solver::Response radiance(const Vec3& origin, const Vec3&, std::uint64_t key,
                                          std::uint32_t sample) const override {
    const double value = paint_(origin.x, -origin.y, core::Sampler(core::combine(key, 0xc01), sample).next());
    return {value, value, value, value};
  }

 private:
  Paint paint_;
};

/// One metre a pixel; the eye's x and -y are the image's, from its middle.
scene::View flatView(int width, int height) {
  scene::View view;
  view.name = "painted";
  view.eye = {0, 0, 10};
  view.target = {0, 0, 0};
  view.up = {0, 1, 0};
  view.projection = scene::View::Projection::orthographic;
  view.span = height;
  view.width = width;
  view.height = height;
  return view;
}

ImageEstimate seen(const Painted& solver, const scene::View& view, const PixelAccuracy& accuracy,
                   std::uint64_t key = 5) {
  core::SilentProgress silent;
  return renderView(solver, view, Vec3(0), key, accuracy, 1e9, silent);
}

double meanOf(const std::vector<float>& values) {
  double sum = 0;
  for (const float value : values) sum += static_cast<double>(value);
  return sum / static_cast<double>(values.size());
}

// One sample in twenty is 61 times the others: mean 100, standard deviation 327.
constexpr double rare = 0.05, bright = 1525, dark = 25, sigma = 327;
double skewed(double random) {
  return random < rare ? bright : dark;
}

// What the pixel loop must not do: stop a pixel by its own value and spread. With these figures its picture is off by
// tens of times what chance allows, so that the test below could find it.
double meanOfTheNaiveRule(int pixels, double relative) {
  double sum = 0;
  for (int i = 0; i < pixels; ++i) {
    std::array<double, 16> values{};
    double mean = 0;
    for (int n = 1; n <= 16; n *= 2) {
      for (std::size_t r = 0; r < values.size(); ++r) {
        values[r] = 0;
        for (int s = 0; s < n; ++s)
          values[r] += skewed(core::Sampler(core::combine(core::combine(5, static_cast<std::uint64_t>(i)), r),
                                            static_cast<std::uint32_t>(s))
                                  .next()) /
                       n;
      }
      const core::ReplicateMean known = core::replicateMean(values);
      mean = known.mean;
      if (2.13 * known.standardError <= relative * std::max(mean, 10.0)) break;
    }
    sum += mean / pixels;
  }
  return sum;
}

TEST(PixelLoop, CoarsePicturesAreRightOnAverage) {
  const scene::View view = flatView(96, 96);
  const Painted solver([](double, double, double random) { return skewed(random); });
  const double fewestSamples = 16, pixels = 96 * 96;
  const double standardError = sigma / std::sqrt(fewestSamples * pixels);
  for (const double relative : {0.2, 0.5, 1.0}) {
    PixelAccuracy accuracy;
    accuracy.relative = relative;
    const ImageEstimate e = seen(solver, view, accuracy);
    const double mean = meanOf(e.image.y), naive = meanOfTheNaiveRule(96 * 96, relative);
    std::printf(
        "asked %3.0f %%: mean %.2f, exactly 100 (chance allows %.2f); by a rule that looks at its own value %.2f\n",
        100 * relative, mean, 4 * standardError, naive);
    EXPECT_NEAR(mean, 100, 4 * standardError) << relative;  // by chance in one of 16 000
  }
  EXPECT_GT(std::abs(meanOfTheNaiveRule(96 * 96, 0.5) - 100), 10 * standardError) << "the negative control";
}

// Where noise differs from pixel to pixel and so samples do, pixel intervals still hold: 95 % asked, of 9216.
TEST(PixelLoop, IntervalsHoldWherePixelsStopAtDifferentTimes) {
  const scene::View view = flatView(96, 96);
  const auto noise = [](double x) { return 0.1 + 0.015 * (x + 48); };
  const Painted solver([&](double x, double, double random) { return 100 * (1 + noise(x) * (2 * random - 1)); });
  PixelAccuracy accuracy;
  accuracy.relative = 0.08;
  const ImageEstimate e = seen(solver, view, accuracy);
  int inside = 0;
  for (std::size_t i = 0; i < e.image.y.size(); ++i) inside += std::abs(e.image.y[i] - 100) <= e.image.halfWidth[i];
  const double share = inside / 9216.0, samples = static_cast<double>(e.samples) / 9216;
  std::printf("coverage %.2f %% of 95 %% asked, %.0f samples a pixel\n", 100 * share, samples);
  EXPECT_GT(share, 0.94);  // four standard deviations: 0.9 %
  EXPECT_TRUE(e.reached);
  EXPECT_GT(samples, 20);
  EXPECT_LT(samples, 200);
}

// Light that is reflected or let through by chance, as glass does: all pixels are alike, and the accuracy is reached
// for as many samples as it takes.
TEST(PixelLoop, AccuracyIsReachedWhereAllPixelsAreAlike) {
  const Painted solver([](double, double, double random) { return random < 0.94 ? 100 : 0; });
  const scene::View view = flatView(32, 32);
  for (const int most : {32, 1024}) {
    PixelAccuracy accuracy;
    accuracy.mostSamples = most;
    const ImageEstimate e = seen(solver, view, accuracy);
    EXPECT_EQ(e.reached, most == 1024) << most << " samples, " << e.shareWithin;
    EXPECT_LE(e.samples, 1024U * static_cast<unsigned>(most));
    EXPECT_NEAR(meanOf(e.image.y), 94, 4 * 23.7 / std::sqrt(32 * 1024));
  }
  PixelAccuracy accuracy;
  accuracy.fewestSamples = 100;  // rounded up to seven a replicate
  EXPECT_GE(seen(solver, view, accuracy).samples, 1024U * 112U);
}

// The edge of a luminaire of 10 000 cd/m2 before 100, aslant and without noise: the share of each pixel that it covers
// is known. Less than 5 % of the pixels have an edge, so that the accuracy asked for is reached without them.
TEST(PixelLoop, EdgesOfLuminairesAreDividedByContrast) {
  const auto covered = [](double x, double y) { return y < 0.31 * x + 3.2; };
  const Painted solver([&](double x, double y, double) { return covered(x, y) ? 10000 : 100; });
  const scene::View view = flatView(64, 64);
  double errors[2]{}, samples[2]{};
  for (const bool divided : {false, true}) {
    PixelAccuracy accuracy;
    accuracy.contrast = divided ? 0.02 : 1;
    const ImageEstimate e = seen(solver, view, accuracy);
    double squares = 0;
    int edges = 0;
    for (int y = 0; y < 64; ++y)
      for (int x = 0; x < 64; ++x) {
        double share = 0;
        for (int v = 0; v < 64; ++v)
          for (int u = 0; u < 64; ++u)
            share += covered(x - 32 + (u + 0.5) / 64, y - 32 + (v + 0.5) / 64) ? 1.0 / 4096 : 0;
        const double found = (static_cast<double>(e.image.y[static_cast<std::size_t>(64 * y + x)]) - 100) / 9900;
        if (share == 0 || share == 1) {
          EXPECT_NEAR(found, share, 0.005);  // the edge may cut off less than its corner
          continue;
        }
        squares += (found - share) * (found - share);
        ++edges;
      }
    errors[divided] = std::sqrt(squares / edges);
    samples[divided] = static_cast<double>(e.samples) / 4096;
  }
  std::printf(
      "share of an edge's pixels covered: error %.3f rms with %.0f samples a pixel, %.4f with %.0f by contrast\n",
      errors[0], samples[0], errors[1], samples[1]);
  EXPECT_EQ(samples[0], 16);
  EXPECT_LT(samples[1], 40);
  EXPECT_LT(errors[1], 0.02);
  EXPECT_GT(errors[0], 2 * errors[1]);
}

// Whatever the filter, an even picture is even, and a ramp is the ramp: all are symmetric with integral 1.
TEST(PixelLoop, EveryFilterKeepsEvenPicturesAndRamps) {
  const scene::View view = flatView(16, 16);
  for (const PixelFilter& filter : pixelFilters()) {
    PixelAccuracy accuracy;
    accuracy.filter = &filter;
    accuracy.fewestSamples = 1024;
    const ImageEstimate even = seen(Painted([](double, double, double) { return 50; }), view, accuracy);
    for (const float y : even.image.y) ASSERT_NEAR(y, 50, 1e-3) << filter.name;
    const ImageEstimate ramp = seen(Painted([](double x, double, double) { return 50 + x; }), view, accuracy);
    for (int x = 0; x < 16; ++x) {
      const auto i = static_cast<std::size_t>(16 * 7 + x);
      ASSERT_NEAR(ramp.image.y[i], 50 + x - 8 + 0.5, std::max(2 * ramp.image.halfWidth[i], 1e-3F)) << filter.name;
    }
  }
}

// Mitchell's filter rings: beside a bright edge the picture goes below what is there. It is told, not clamped.
TEST(PixelLoop, RingingIsNotHidden) {
  PixelAccuracy accuracy;
  accuracy.filter = findPixelFilter("mitchell");
  accuracy.fewestSamples = 1024;
  const ImageEstimate e =
      seen(Painted([](double x, double, double) { return x < 0 ? 1000 : 1; }), flatView(16, 16), accuracy);
  EXPECT_LT(e.image.y[16 * 8 + 9], 0);
}

}  // namespace
}  // namespace goniolux::viewing
