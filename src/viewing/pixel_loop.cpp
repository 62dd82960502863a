#include "viewing/pixel_loop.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include "core/parallel.h"
#include "core/random.h"
#include "core/statistics.h"
#include "core/work_items.h"
#include "viewing/pixel_samples.h"

namespace goniolux::viewing {
namespace {

constexpr std::size_t replicates = PixelSamples::replicates;
constexpr double shareAsked = 0.95;
constexpr double shareOfFirst = 0.3, mostForeseen = 0.95;  // of the progress that is told
constexpr int tile = 16;
constexpr std::uint32_t missedPaths = 512;  // per replicate, each of a few branches
constexpr std::uint64_t missedKey = 0x3155ed;
constexpr std::size_t fewestReplicates = 2;  // a picture without any interval is not worth keeping
// The first samples foretell how many a pixel needs as if errors fell with their root; scrambled points do better where
// the picture is smooth. So only a part is taken at first, and more for all until enough pixels are within.
constexpr double firstShare = 0.03, shareStep = 1.5, mostShare = 64;
// A contrast stands out that is this many times the typical one about it, in squares. Of eight replicates' spread that
// happens by chance to one pixel in 5000 (chi square with 7 degrees of freedom).
constexpr double standsOut = 4;
constexpr int surroundings = 2;  // pixels to each side

std::uint32_t perReplicate(int samples) {
  return static_cast<std::uint32_t>(
      std::max(1, (samples + static_cast<int>(replicates) - 1) / static_cast<int>(replicates)));
}

class PixelLoop {
 public:
  PixelLoop(const solver::Solver& solver, const scene::View& view, const core::Vec3& worldOrigin, std::uint64_t key,
            const PixelAccuracy& accuracy, core::Keeping keeping)
      : solver_(solver),
        view_(view),
        worldOrigin_(worldOrigin),
        key_(key),
        accuracy_(accuracy),
        keeping_(std::move(keeping)),
        filter_(accuracy.filter != nullptr ? *accuracy.filter : pixelFilters().front()),
        fewest_(perReplicate(accuracy.fewestSamples)),
        most_(std::max(fewest_,
                       static_cast<std::uint32_t>(std::max(1, accuracy.mostSamples / static_cast<int>(replicates))))),
        count_(static_cast<std::size_t>(view.width) * static_cast<std::size_t>(view.height)),
        seen_(count_, fewest_, accuracy.confidence),
        direct_(accuracy.parts ? count_ : 0, fewest_, accuracy.confidence),
        wanted_(count_, {fewest_, fewest_}) {}

  /// The first samples, one replicate of the whole picture after the other, so that an early end leaves a whole
  /// picture.
  void firstPass(const std::function<bool()>& goOn, const ImageObserver& partial, core::ProgressSink& progress) {
    for (std::size_t r = 0; r < replicates; ++r) {
      core::WorkItems items;
      items.work = [&](std::size_t t) {
        forPixelsOf(t, [&](std::size_t i, int x, int y) { sampleReplicate(i, x, y, r, 0, fewest_); });
      };
      items.pack = [&](std::size_t t, std::string& bytes) {
        forPixelsOf(t, [&](std::size_t i, int, int) { putReplicate(i, r, bytes); });
      };
      items.unpack = [&](std::size_t t, std::string_view bytes) {
        bool fits = true;
        forPixelsOf(t, [&](std::size_t i, int, int) { fits = fits && takeReplicate(i, r, bytes); });
        return fits;
      };
      items.told = [&](double share) { tell(progress, shareOfFirst * (static_cast<double>(r) + share) / replicates); };
      if (!forAllTiles(items, fmt::format("replicate {}", r), progress)) return;
      seen_.setComplete(r + 1);
      direct_.setComplete(r + 1);
      tell(progress, shareOfFirst * static_cast<double>(r + 1) / replicates);
      if (partial && r + 1 < replicates) partial(result());
      if (r + 1 >= fewestReplicates && !goOn()) return;
    }
  }
  /// What is told with the progress from now on.
  void tellReached(core::ProgressSink& progress, std::string reached) {
    reached_ = std::move(reached);
    tell(progress, told_);
  }
  [[nodiscard]] bool firstPassIsComplete() const { return seen_.complete() == replicates; }

  /// Takes every pixel to the samples per replicate that it should have. False when cancelled in the middle.
  bool pass(core::ProgressSink& progress) {
    ++passes_;
    double planned = 0, taken = 0;
    for (std::size_t i = 0; i < count_; ++i)
      for (std::size_t half = 0; half < PixelSamples::halves; ++half) {
        planned += wanted_[i][half];
        taken += seen_.samples(i, half);
      }
    core::WorkItems items;
    items.work = [&](std::size_t t) {
      forPixelsOf(t, [&](std::size_t i, int x, int y) {
        for (std::size_t r = 0; r < replicates; ++r) {
          const std::size_t half = PixelSamples::halfOf(r);
          sampleReplicate(i, x, y, r, seen_.samples(i, half), wanted_[i][half]);
        }
        for (std::size_t half = 0; half < PixelSamples::halves; ++half) setSamples(i, half, wanted_[i][half]);
      });
    };
    // Of every pixel: its samples, and the replicates of those halves that this pass added to.
    items.pack = [&](std::size_t t, std::string& bytes) {
      forPixelsOf(t, [&](std::size_t i, int, int) {
        for (std::size_t half = 0; half < PixelSamples::halves; ++half) {
          core::put(bytes, wanted_[i][half]);
          const bool isNew = before_[i][half] != wanted_[i][half];
          core::put(bytes, static_cast<std::uint8_t>(isNew));
          for (std::size_t r = 0; isNew && r < PixelSamples::perHalf; ++r)
            putReplicate(i, half * PixelSamples::perHalf + r, bytes);
        }
      });
    };
    items.unpack = [&](std::size_t t, std::string_view bytes) { return takeTile(t, bytes); };
    items.told = [&](double share) {
      const double done = (taken + share * (planned - taken)) / planned;
      tell(progress, shareOfFirst + (mostForeseen - shareOfFirst) * done);
    };
    if (keeping_.log != nullptr) before_ = samplesNow();
    return forAllTiles(items, fmt::format("pass {}", passes_), progress);
  }

  /// How many times the first samples each half of each pixel needs, from the first samples of the other half and of
  /// the pixels about it. Nothing that is sampled later has a say: where more samples find more spread, that would
  /// let a value decide about its own weight by way of its neighbours.
  void foretell() {
    std::vector<std::array<PixelSamples::Half, 2>> known(count_);
    std::vector<float> spread(count_);  // of both halves
    for (std::size_t i = 0; i < count_; ++i) {
      known[i] = {seen_.half(i, 0), seen_.half(i, 1)};
      spread[i] = static_cast<float>(0.5 * (known[i][0].squaredHalfWidth + known[i][1].squaredHalfWidth));
    }
    const double mean = meanLuminance();
    needs_.resize(count_);
    for (int y = 0; y < view_.height; ++y)
      for (int x = 0; x < view_.width; ++x)
        for (std::size_t half = 0; half < PixelSamples::halves; ++half)
          needs_[index(x, y)][half] = needOf(x, y, known[index(x, y)][1 - half], spread, mean);
  }

  /// Gives pixels the samples that they need, a pass doubling them at most: `share` of what accuracy was foretold to
  /// need, and all that contrast does. False when that is done.
  bool refine(double share) {
    bool more = false;
    const std::uint32_t most = std::min(most_, 2 * passed_);
    for (std::size_t i = 0; i < count_; ++i)
      for (std::size_t half = 0; half < PixelSamples::halves; ++half) {
        const Need& need = needs_[i][half];
        const double times = std::max(share * static_cast<double>(need.accuracy), static_cast<double>(need.contrast));
        // Powers of two of the first samples: such sets of points are the most even ones.
        std::uint32_t wanted = fewest_;
        while (wanted < most && wanted < times * fewest_) wanted *= 2;
        wanted_[i][half] = std::max(seen_.samples(i, half), std::min(wanted, most));
        more = more || wanted_[i][half] > seen_.samples(i, half);
      }
    if (more) passed_ = most;
    return more;
  }

  /// How far a light solution is off, on average over the picture: paths through random pixels that go on. The bound
  /// (mean and its half-width) becomes part of every pixel's half-width, in proportion to its luminance.
  void findMissed(core::ProgressSink& progress) {
    if (solver_.isUnbiased()) return;
    std::array<double, replicates> missed{};
    core::WorkItems items;
    items.count = replicates;
    items.work = [&](std::size_t r) {
      const std::uint64_t key = core::combine(core::combine(key_, missedKey), r);
      for (std::uint32_t s = 0; s < missedPaths; ++s) {
        const core::Vec2 place = core::Sampler(core::combine(key, missedKey), s).next2();
        const scene::ViewRay ray = scene::rayThrough(view_, place.x * view_.width, place.y * view_.height);
        if (!ray.inside) continue;
        missed[r] += solver_.missedLuminance(ray.origin - worldOrigin_, ray.direction, key, s) / missedPaths;
      }
    };
    items.pack = [&](std::size_t r, std::string& bytes) { core::put(bytes, missed[r]); };
    items.unpack = [&](std::size_t r, std::string_view bytes) { return core::take(bytes, missed[r]); };
    if (!core::doItems(items, keeping_.part("missed"), progress).complete) return;
    const core::ReplicateMean mean = core::replicateMean(missed);
    const double luminance = meanLuminance();
    const double quantile = core::studentQuantile(replicates - 1, accuracy_.confidence);
    if (luminance > 0) missed_ = (std::abs(mean.mean) + quantile * mean.standardError) / luminance;
  }

  [[nodiscard]] double shareWithin() const {
    const double mean = meanLuminance();
    std::size_t within = 0;
    for (std::size_t i = 0; i < count_; ++i) within += halfWidth(i) <= allowed(seen_.luminance(i), mean);
    return static_cast<double>(within) / static_cast<double>(count_);
  }

  [[nodiscard]] ImageEstimate result() const {
    ImageEstimate e;
    image::XyzImage& image = e.image;
    image.width = view_.width;
    image.height = view_.height;
    image.x.resize(count_), image.y.resize(count_), image.z.resize(count_), image.halfWidth.resize(count_);
    image.chromaticityX.resize(count_), image.chromaticityY.resize(count_);
    e.halfWidthX.resize(count_), e.halfWidthZ.resize(count_);
    for (std::size_t i = 0; i < count_; ++i) {
      const auto [x, y, z] = seen_.mean(i);
      image.x[i] = static_cast<float>(x);
      image.y[i] = static_cast<float>(y);
      image.z[i] = static_cast<float>(z);
      image.halfWidth[i] = static_cast<float>(halfWidth(i));
      e.halfWidthX[i] = static_cast<float>(seen_.halfWidth(i, 0));
      e.halfWidthZ[i] = static_cast<float>(seen_.halfWidth(i, 2));
      const auto [hx, hy] = seen_.chromaticityHalfWidths(i);
      image.chromaticityX[i] = static_cast<float>(hx);
      image.chromaticityY[i] = static_cast<float>(hy);
      e.samples += seen_.samplesOf(i);
    }
    if (accuracy_.parts) addParts(image);
    e.missed = missed_;
    e.shareWithin = shareWithin();
    e.reached = e.shareWithin >= shareAsked;
    return e;
  }

 private:
  [[nodiscard]] std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(view_.width) + static_cast<std::size_t>(x);
  }
  /// Calls `use` for the pixels up to `reach` to each side of a pixel, without it.
  template <class Use>
  void aroundOf(int x, int y, int reach, const Use& use) const {
    for (int v = std::max(0, y - reach); v <= std::min(view_.height - 1, y + reach); ++v)
      for (int u = std::max(0, x - reach); u <= std::min(view_.width - 1, x + reach); ++u)
        if (u != x || v != y) use(index(u, v));
  }

  [[nodiscard]] int tilesAcross() const { return (view_.width + tile - 1) / tile; }
  [[nodiscard]] int tilesDown() const { return (view_.height + tile - 1) / tile; }
  template <class Work>
  void forPixelsOf(std::size_t t, const Work& work) const {
    const int x0 = static_cast<int>(t) % tilesAcross() * tile, y0 = static_cast<int>(t) / tilesAcross() * tile;
    for (int y = y0; y < std::min(y0 + tile, view_.height); ++y)
      for (int x = x0; x < std::min(x0 + tile, view_.width); ++x) work(index(x, y), x, y);
  }
  bool forAllTiles(core::WorkItems& items, const std::string& part, const core::ProgressSink& progress) {
    items.count = static_cast<std::size_t>(tilesAcross() * tilesDown());
    return core::doItems(items, keeping_.part(part), progress).complete;
  }

  void tell(core::ProgressSink& progress, double share) {
    told_ = std::max(told_, share);  // a pass may ask for a further one
    progress.progress(view_.name, told_, reached_);
  }
  void putReplicate(std::size_t i, std::size_t r, std::string& bytes) const {
    core::put(bytes, seen_.sum(i, r));
    if (accuracy_.parts) core::put(bytes, direct_.sum(i, r));
  }
  bool takeReplicate(std::size_t i, std::size_t r, std::string_view& bytes) {
    PixelSamples::Sum seen{}, direct{};
    if (!core::take(bytes, seen) || (accuracy_.parts && !core::take(bytes, direct))) return false;
    seen_.setSum(i, r, seen);
    if (accuracy_.parts) direct_.setSum(i, r, direct);
    return true;
  }
  /// A tile as a pass left it; false, and nothing is changed, when that pass wanted other samples.
  bool takeTile(std::size_t t, std::string_view bytes) {
    const auto read = [&](std::string_view rest, bool set) {
      bool fits = true;
      forPixelsOf(t, [&](std::size_t i, int, int) {
        for (std::size_t half = 0; fits && half < PixelSamples::halves; ++half) {
          std::uint32_t samples = 0;
          std::uint8_t isNew = 0;
          fits = core::take(rest, samples) && core::take(rest, isNew) && samples == wanted_[i][half] &&
                 (isNew != 0) == (before_[i][half] != samples);
          for (std::size_t r = 0; fits && isNew != 0 && r < PixelSamples::perHalf; ++r) {
            if (set)
              fits = takeReplicate(i, half * PixelSamples::perHalf + r, rest);
            else
              rest.remove_prefix(std::min(rest.size(), sizeof(PixelSamples::Sum) * (accuracy_.parts ? 2 : 1)));
          }
          if (fits && set) setSamples(i, half, samples);
        }
      });
      return fits && rest.empty();
    };
    return read(bytes, false) && read(bytes, true);
  }
  void setSamples(std::size_t i, std::size_t half, std::uint32_t samples) {
    seen_.setSamples(i, half, samples);
    if (accuracy_.parts) direct_.setSamples(i, half, samples);
  }
  [[nodiscard]] std::vector<std::array<std::uint32_t, 2>> samplesNow() const {
    std::vector<std::array<std::uint32_t, 2>> now(count_);
    for (std::size_t i = 0; i < count_; ++i) now[i] = {seen_.samples(i, 0), seen_.samples(i, 1)};
    return now;
  }

  void sampleReplicate(std::size_t i, int x, int y, std::size_t r, std::uint32_t from, std::uint32_t to) {
    const std::uint64_t key = core::combine(core::combine(key_, i), r);
    for (std::uint32_t s = from; s < to; ++s) {
      const core::Vec2 u = core::Sampler(key, s).next2();
      look(i, r, core::Vec2(x + 0.5, y + 0.5) + filter_.positive(u), key, s, filter_.gain());
      // The same random numbers: where both see the same, their noise is the same too and cancels.
      if (filter_.hasLobes())
        look(i, r, core::Vec2(x + 0.5, y + 0.5) + filter_.negative(u), key, s, 1 - filter_.gain());
    }
  }
  void look(std::size_t i, std::size_t r, core::Vec2 place, std::uint64_t key, std::uint32_t sample, double factor) {
    const scene::ViewRay ray = scene::rayThrough(view_, place.x, place.y);
    if (!ray.inside) return;
    if (!accuracy_.parts) {
      seen_.add(i, r, solver_.radiance(ray.origin - worldOrigin_, ray.direction, key, sample), factor);
      return;
    }
    const solver::PartedLight light = solver_.partedLight(ray.origin - worldOrigin_, ray.direction, key, sample);
    seen_.add(i, r, light.whole, factor);
    direct_.add(i, r, light.direct, factor);
  }

  [[nodiscard]] double halfWidth(std::size_t i) const { return seen_.halfWidth(i, 1) + missed_ * seen_.luminance(i); }
  [[nodiscard]] double meanLuminance() const {
    double sum = 0;
    for (std::size_t i = 0; i < count_; ++i) sum += seen_.luminance(i);
    return sum / static_cast<double>(count_);
  }
  /// Pixels much darker than the picture need not be known to the same share.
  [[nodiscard]] static double reference(double luminance, double mean) { return std::max(luminance, 0.1 * mean); }
  [[nodiscard]] double allowed(double luminance, double mean) const {
    return std::max(accuracy_.relative * reference(luminance, mean), accuracy_.absoluteFloor);
  }

  struct Need {
    float accuracy = 0, contrast = 0;  // times the first samples; 0: no more
  };
  [[nodiscard]] Need needOf(int x, int y, const PixelSamples::Half& other, const std::vector<float>& spread,
                            double mean) const {
    // Pooled over 3 x 3 pixels, this pixel's being that of its other half.
    double pooled = other.squaredHalfWidth, pixels = 1;
    aroundOf(x, y, 1, [&](std::size_t i) { pooled += static_cast<double>(spread[i]), ++pixels; });
    pooled /= pixels;
    // The systematic part takes its share of what is allowed; more samples do nothing about it.
    const double here = allowed(other.luminance, mean);
    const double limit = std::max(0.3 * here, here - missed_ * other.luminance);
    Need need;
    need.accuracy = static_cast<float>(pooled / (limit * limit));
    const double visible = std::max(2 * accuracy_.contrast * reference(other.luminance, mean), accuracy_.absoluteFloor);
    const double largest = std::max(pooled, other.squaredHalfWidth);
    if (accuracy_.contrast < 1 && largest > visible * visible && largest > standsOut * typicalSpread(x, y, spread))
      need.contrast = static_cast<float>(largest / (visible * visible));
    return need;
  }
  /// The median of the squared half-widths about a pixel.
  [[nodiscard]] double typicalSpread(int x, int y, const std::vector<float>& spread) const {
    std::array<float, (2 * surroundings + 1) * (2 * surroundings + 1)> about{};
    std::size_t count = 0;
    aroundOf(x, y, surroundings, [&](std::size_t i) { about[count++] = spread[i]; });
    const auto middle = about.begin() + static_cast<std::ptrdiff_t>(count / 2);
    std::nth_element(about.begin(), middle,
                     about.begin() + static_cast<std::ptrdiff_t>(std::max<std::size_t>(1, count)));
    return static_cast<double>(*middle);
  }

  void addParts(image::XyzImage& image) const {
    image::Layer direct{image::directLayer, {}, {}, {}, {}}, indirect{image::indirectLayer, {}, {}, {}, {}};
    for (std::size_t i = 0; i < count_; ++i) {
      const auto [x, y, z] = direct_.mean(i);
      const std::array<float, 3> part{static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)};
      direct.x.push_back(part[0]), direct.y.push_back(part[1]), direct.z.push_back(part[2]);
      indirect.x.push_back(image.x[i] - part[0]);
      indirect.y.push_back(image.y[i] - part[1]);
      indirect.z.push_back(image.z[i] - part[2]);
      direct.halfWidth.push_back(static_cast<float>(direct_.halfWidth(i, 1)));
      indirect.halfWidth.push_back(static_cast<float>(seen_.halfWidthBeyond(direct_, i)));
    }
    image.layers = {std::move(direct), std::move(indirect)};
  }

  const solver::Solver& solver_;
  const scene::View& view_;
  core::Vec3 worldOrigin_;
  std::uint64_t key_;
  PixelAccuracy accuracy_;
  core::Keeping keeping_;
  FilterPlaces filter_;
  std::uint32_t fewest_, most_;  // samples per replicate
  std::size_t count_;
  PixelSamples seen_, direct_;                        // direct_: empty unless asked for
  std::vector<std::array<std::uint32_t, 2>> wanted_;  // samples per replicate of each half
  std::vector<std::array<std::uint32_t, 2>> before_;  // the same before the present pass; only where work is kept
  std::vector<std::array<Need, 2>> needs_;
  int passes_ = 0;
  double told_ = 0;
  std::string reached_ = "first samples";
  std::uint32_t passed_ = fewest_;  // no pixel has more
  double missed_ = 0;               // relative
};

}  // namespace

ImageEstimate renderView(const solver::Solver& solver, const scene::View& view, const core::Vec3& worldOrigin,
                         std::uint64_t key, const PixelAccuracy& accuracy, double secondsLeft,
                         core::ProgressSink& progress, const ImageObserver& partial, const core::Keeping& keeping) {
  const double start = core::wallSeconds();
  const auto elapsed = [&] { return core::wallSeconds() - start; };

  PixelLoop loop(solver, view, worldOrigin, key, accuracy, keeping);
  loop.tellReached(progress, "first samples");
  loop.firstPass([&] { return elapsed() < secondsLeft; }, partial, progress);
  bool more = loop.firstPassIsComplete();
  if (more) {
    loop.tellReached(progress, "what the light solution misses");
    loop.findMissed(progress);
    loop.tellReached(progress, "first samples");
    loop.foretell();
  }
  double part = 0;  // contrast comes first; it may be enough
  while (more && elapsed() < secondsLeft) {
    if (loop.refine(part)) {
      more = loop.pass(progress);
      if (more && partial) partial(loop.result());
      continue;
    }
    const double share = loop.shareWithin();
    loop.tellReached(progress, fmt::format("pixels within {:g} %: {:.0f} %", 100 * accuracy.relative, 100 * share));
    if (share >= shareAsked || part > mostShare) break;
    part = std::max(firstShare, part * shareStep);
  }
  ImageEstimate estimate = loop.result();
  progress.progress(view.name, 1,
                    fmt::format("pixels within {:g} %: {:.0f} %", 100 * accuracy.relative, 100 * estimate.shareWithin));
  return estimate;
}

}  // namespace goniolux::viewing
