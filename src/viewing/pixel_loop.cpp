#include "viewing/pixel_loop.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <span>
#include <utility>

#include "core/parallel.h"
#include "core/random.h"
#include "core/statistics.h"

namespace goniolux::viewing {
namespace {

constexpr std::size_t replicates = 16;
constexpr double shareAsked = 0.95;
constexpr int tile = 16;
constexpr std::uint32_t missedPaths = 512;  // per replicate, each of a few branches
constexpr std::uint64_t missedKey = 0x3155ed;
constexpr std::size_t fewestReplicates = 2;  // a picture without any interval is not worth keeping

class PixelLoop {
 public:
  PixelLoop(const solver::Solver& solver, const scene::View& view, const core::Vec3& worldOrigin, std::uint64_t key,
            const PixelAccuracy& accuracy)
      : solver_(solver),
        view_(view),
        worldOrigin_(worldOrigin),
        key_(key),
        accuracy_(accuracy),
        quantile_(core::studentQuantile(replicates - 1, accuracy.confidence)),
        count_(static_cast<std::size_t>(view.width) * static_cast<std::size_t>(view.height)),
        sums_(count_),
        done_(count_, 1),
        wanted_(count_, 1) {}

  /// The first samples, one replicate of the whole picture after the other, so that an early end leaves a whole
  /// picture.
  void firstPass(const std::function<bool()>& goOn, const ImageObserver& partial, core::ProgressSink& progress) {
    for (std::size_t r = 0; r < replicates; ++r) {
      forAllPixels(progress, [&](std::size_t i, int x, int y) { sampleReplicate(i, x, y, r, 0, 1); });
      if (progress.cancelled()) return;
      complete_ = r + 1;
      progress.progress(view_.name, 0.3 * static_cast<double>(r + 1) / replicates, "first samples");
      if (partial && r + 1 < replicates) partial(result());
      if (r + 1 >= fewestReplicates && !goOn()) return;
    }
  }
  [[nodiscard]] bool firstPassIsComplete() const { return complete_ == replicates; }

  /// Takes every pixel to the samples per replicate that it should have. False when cancelled in the middle.
  bool pass(core::ProgressSink& progress) {
    forAllPixels(progress, [&](std::size_t i, int x, int y) {
      for (std::size_t r = 0; r < replicates && done_[i] < wanted_[i]; ++r)
        sampleReplicate(i, x, y, r, done_[i], wanted_[i]);
      done_[i] = wanted_[i];
    });
    return !progress.cancelled();
  }

  /// Doubles the samples of the pixels that are not known well enough; false when there are none or all are at the
  /// limit.
  bool refine() {
    const double mean = meanLuminance();
    const auto most = static_cast<std::uint32_t>(std::max(1, accuracy_.mostSamples / static_cast<int>(replicates)));
    bool more = false;
    std::vector<float> variance(count_);
    for (std::size_t i = 0; i < count_; ++i) {
      const double h = halfWidth(i);
      variance[i] = static_cast<float>(h * h);
    }
    for (int y = 0; y < view_.height; ++y)
      for (int x = 0; x < view_.width; ++x) {
        const std::size_t i = index(x, y);
        if (done_[i] >= most) continue;
        double sum = 0, pixels = 0;
        for (int v = std::max(0, y - 1); v <= std::min(view_.height - 1, y + 1); ++v)
          for (int u = std::max(0, x - 1); u <= std::min(view_.width - 1, x + 1); ++u, ++pixels)
            sum += variance[index(u, v)];
        const double allowedHere = allowed(value(i), mean);
        if (sum / pixels <= allowedHere * allowedHere / 1.2) continue;
        wanted_[i] = std::min(most, 2 * done_[i]);
        more = true;
      }
    return more;
  }

  /// How far a light solution is off, on average over the picture: paths through random pixels that go on. The bound
  /// (mean and its half-width) becomes part of every pixel's half-width, in proportion to its luminance.
  void findMissed(core::ProgressSink& progress) {
    if (solver_.isUnbiased()) return;
    std::array<double, replicates> missed{};
    core::parallelFor(replicates, 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t r = begin; r < end && !progress.cancelled(); ++r) {
        const std::uint64_t key = core::combine(core::combine(key_, missedKey), r);
        for (std::uint32_t s = 0; s < missedPaths; ++s) {
          const core::Vec2 place = core::Sampler(core::combine(key, missedKey), s).next2();
          const scene::ViewRay ray = scene::rayThrough(view_, place.x * view_.width, place.y * view_.height);
          if (!ray.inside) continue;
          missed[r] += solver_.missedLuminance(ray.origin - worldOrigin_, ray.direction, key, s) / missedPaths;
        }
      }
    });
    const core::ReplicateMean mean = core::replicateMean(missed);
    const double luminance = meanLuminance();
    if (luminance > 0) missed_ = (std::abs(mean.mean) + quantile_ * mean.standardError) / luminance;
  }

  [[nodiscard]] double shareWithin() const {
    const double mean = meanLuminance();
    std::size_t within = 0;
    for (std::size_t i = 0; i < count_; ++i) within += halfWidth(i) <= allowed(value(i), mean);
    return static_cast<double>(within) / static_cast<double>(count_);
  }

  [[nodiscard]] ImageEstimate result() const {
    ImageEstimate e;
    image::XyzImage& image = e.image;
    image.width = view_.width;
    image.height = view_.height;
    image.x.resize(count_), image.y.resize(count_), image.z.resize(count_), image.halfWidth.resize(count_);
    image.chromaticityX.resize(count_), image.chromaticityY.resize(count_);
    for (std::size_t i = 0; i < count_; ++i) {
      const Colour colour = mean(i);
      image.x[i] = colour.x;
      image.y[i] = colour.y;
      image.z[i] = colour.z;
      image.halfWidth[i] = static_cast<float>(halfWidth(i));
      const auto [hx, hy] = chromaticityHalfWidths(i);
      image.chromaticityX[i] = static_cast<float>(hx);
      image.chromaticityY[i] = static_cast<float>(hy);
      e.samples += static_cast<std::uint64_t>(done_[i]) * complete_;
    }
    e.missed = missed_;
    e.shareWithin = shareWithin();
    e.reached = e.shareWithin >= shareAsked;
    return e;
  }

 private:
  struct Colour {
    float x = 0, y = 0, z = 0;
  };

  [[nodiscard]] std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(view_.width) + static_cast<std::size_t>(x);
  }

  void forAllPixels(core::ProgressSink& progress, const std::function<void(std::size_t, int, int)>& work) {
    const int across = (view_.width + tile - 1) / tile, down = (view_.height + tile - 1) / tile;
    core::parallelFor(static_cast<std::size_t>(across * down), 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t t = begin; t < end && !progress.cancelled(); ++t) {
        const int x0 = static_cast<int>(t) % across * tile, y0 = static_cast<int>(t) / across * tile;
        for (int y = y0; y < std::min(y0 + tile, view_.height); ++y)
          for (int x = x0; x < std::min(x0 + tile, view_.width); ++x) work(index(x, y), x, y);
      }
    });
  }

  void sampleReplicate(std::size_t i, int x, int y, std::size_t r, std::uint32_t from, std::uint32_t to) {
    const std::uint64_t key = core::combine(core::combine(key_, i), r);
    for (std::uint32_t s = from; s < to; ++s) {
      const core::Vec2 place = core::Sampler(key, s).next2();
      const scene::ViewRay ray = scene::rayThrough(view_, x + place.x, y + place.y);
      if (!ray.inside) continue;
      const solver::Response seen = solver_.radiance(ray.origin - worldOrigin_, ray.direction, key, s);
      sums_[i][r].x += static_cast<float>(seen[0]);
      sums_[i][r].y += static_cast<float>(seen[1]);
      sums_[i][r].z += static_cast<float>(seen[2]);
    }
  }

  [[nodiscard]] Colour mean(std::size_t i) const {
    Colour sum;
    for (std::size_t r = 0; r < complete_; ++r) sum.x += sums_[i][r].x, sum.y += sums_[i][r].y, sum.z += sums_[i][r].z;
    const float n = static_cast<float>(std::max<std::size_t>(1, complete_)) * static_cast<float>(done_[i]);
    return {sum.x / n, sum.y / n, sum.z / n};
  }
  [[nodiscard]] double value(std::size_t i) const { return static_cast<double>(mean(i).y); }
  [[nodiscard]] double halfWidth(std::size_t i) const {
    if (complete_ < 2) return std::numeric_limits<double>::infinity();  // one replicate says nothing about its error
    std::array<double, replicates> means{};
    for (std::size_t r = 0; r < complete_; ++r) means[r] = static_cast<double>(sums_[i][r].y) / done_[i];
    return quantile() * core::replicateMean(std::span(means).first(complete_)).standardError + missed_ * value(i);
  }
  // x = X / S, S = X + Y + Z: to first order dx = (dX - x dS) / S, so that what X, Y and Z err together cancels.
  [[nodiscard]] std::pair<double, double> chromaticityHalfWidths(std::size_t i) const {
    if (complete_ < 2) return {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    const Colour colour = mean(i);
    const double S = static_cast<double>(colour.x) + static_cast<double>(colour.y) + static_cast<double>(colour.z);
    if (!(S > 0)) return {0, 0};
    const double x = static_cast<double>(colour.x) / S, y = static_cast<double>(colour.y) / S;
    std::array<double, replicates> dx{}, dy{};
    for (std::size_t r = 0; r < complete_; ++r) {
      const double X = static_cast<double>(sums_[i][r].x) / done_[i], Y = static_cast<double>(sums_[i][r].y) / done_[i];
      const double sum = X + Y + static_cast<double>(sums_[i][r].z) / done_[i];
      dx[r] = (X - x * sum) / S;
      dy[r] = (Y - y * sum) / S;
    }
    return {quantile() * core::replicateMean(std::span(dx).first(complete_)).standardError,
            quantile() * core::replicateMean(std::span(dy).first(complete_)).standardError};
  }
  [[nodiscard]] double quantile() const {
    return complete_ == replicates ? quantile_
                                   : core::studentQuantile(static_cast<double>(complete_) - 1, accuracy_.confidence);
  }
  [[nodiscard]] double meanLuminance() const {
    double sum = 0;
    for (std::size_t i = 0; i < count_; ++i) sum += value(i);
    return sum / static_cast<double>(count_);
  }
  [[nodiscard]] double allowed(double luminance, double mean) const {
    return std::max(accuracy_.relative * std::max(luminance, 0.1 * mean), accuracy_.absoluteFloor);
  }

  const solver::Solver& solver_;
  const scene::View& view_;
  core::Vec3 worldOrigin_;
  std::uint64_t key_;
  PixelAccuracy accuracy_;
  double quantile_;
  std::size_t count_;
  std::vector<std::array<Colour, replicates>> sums_;  // over the samples of each replicate
  std::vector<std::uint32_t> done_, wanted_;          // samples per replicate
  double missed_ = 0;                                 // relative
  std::size_t complete_ = 0;                          // replicates that every pixel has
};

}  // namespace

ImageEstimate renderView(const solver::Solver& solver, const scene::View& view, const core::Vec3& worldOrigin,
                         std::uint64_t key, const PixelAccuracy& accuracy, double secondsLeft,
                         core::ProgressSink& progress, const ImageObserver& partial) {
  const double start = core::wallSeconds();
  const auto elapsed = [&] { return core::wallSeconds() - start; };

  PixelLoop loop(solver, view, worldOrigin, key, accuracy);
  progress.progress(view.name, 0, "first samples");
  loop.firstPass([&] { return elapsed() < secondsLeft; }, partial, progress);
  bool more = loop.firstPassIsComplete();
  if (more) loop.findMissed(progress);
  while (more && elapsed() < secondsLeft) {
    const double share = loop.shareWithin();
    progress.progress(view.name, std::min(0.95, share),
                      fmt::format("pixels within {:g} %: {:.0f} %", 100 * accuracy.relative, 100 * share));
    if (share >= shareAsked) break;
    if (partial) partial(loop.result());
    if (!loop.refine()) break;
    more = loop.pass(progress);
  }
  ImageEstimate estimate = loop.result();
  progress.progress(view.name, 1,
                    fmt::format("pixels within {:g} %: {:.0f} %", 100 * accuracy.relative, 100 * estimate.shareWithin));
  return estimate;
}

}  // namespace goniolux::viewing
