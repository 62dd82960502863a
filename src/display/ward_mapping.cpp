// Ward's visibility matching by histogram adjustment: contrast goes where luminances are, but nowhere beyond what the
// eye would see in the scene — Ward Larson, Rushmeier and Piatko, IEEE TVCG 3(4), 1997.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/diagnostics.h"
#include "display/mapping_types.h"
#include "display/seen_image.h"
#include "display/visual_threshold.h"

namespace goniolux::display {
namespace {

constexpr std::size_t bins = 100;
constexpr double tolerance = 0.025;  // of the histogram that may be left to trim

// Cumulative histogram of brightness B = ln L, and the range of B.
struct Histogram {
  double from = 0, to = 1;
  std::vector<double> counts = std::vector<double>(bins, 0);
  [[nodiscard]] double step() const { return (to - from) / bins; }
  [[nodiscard]] double total() const { return std::accumulate(counts.begin(), counts.end(), 0.0); }
  /// Share of the histogram below B.
  [[nodiscard]] std::vector<double> cumulative() const {
    std::vector<double> sums{0};
    for (const double count : counts) sums.push_back(sums.back() + count);
    for (double& sum : sums) sum = sums.back() > 0 ? sum / sums.back() : 0;
    for (std::size_t i = 0; sums.back() == 0 && i <= bins; ++i) sums[i] = static_cast<double>(i) / bins;
    return sums;
  }
};

Histogram histogramOf(const FovealImage& foveal) {
  Histogram histogram;
  double least = 1e30, most = 0;
  for (const double y : foveal.y)
    if (y > 1e-4) least = std::min(least, y), most = std::max(most, y);
  if (!(most > 0)) return histogram;
  histogram.from = std::log(least);
  histogram.to = std::log(most * 1.0001) + 1e-6;
  for (const double y : foveal.y)
    if (y > 1e-4)
      ++histogram
            .counts[std::min(bins - 1, static_cast<std::size_t>((std::log(y) - histogram.from) / histogram.step()))];
  return histogram;
}

// Trims counts to what may at most stand in each bin. False when too little is left: a linear mapping then loses
// nothing.
bool adjust(Histogram& histogram, double displayFrom, double displayTo, bool human) {
  const double displayRange = displayTo - displayFrom, all = histogram.total();
  for (int round = 0; round < 200; ++round) {
    const double total = histogram.total();
    if (total < tolerance * all || !(total > 0)) return false;
    const std::vector<double> cumulative = histogram.cumulative();
    double trimmed = 0;
    for (std::size_t i = 0; i < bins; ++i) {
      double ceiling = total * histogram.step() / displayRange;  // equation 5: contrast no higher than linear
      if (human) {
        // Equation 8: no difference is seen here that would not be seen there.
        const double world = std::exp(histogram.from + (static_cast<double>(i) + 0.5) * histogram.step());
        const double shown = std::exp(displayFrom + displayRange * 0.5 * (cumulative[i] + cumulative[i + 1]));
        ceiling *= justNoticeable(shown) / justNoticeable(world) * world / shown;
      }
      if (histogram.counts[i] > ceiling) {
        trimmed += histogram.counts[i] - ceiling;
        histogram.counts[i] = ceiling;
      }
    }
    if (trimmed <= tolerance * all) return true;
  }
  return true;
}

ToneMap make(const MappingTask& task, const core::Arguments& arguments) {
  const std::string& contrast = textOf(arguments, "contrast");
  if (contrast != "human" && contrast != "linear")
    throw core::InputError({}, "mapping", fmt::format("'contrast' of ward is human or linear, not '{}'", contrast));
  const double field = numberOf(arguments, "field") > 0 ? numberOf(arguments, "field") : degreesAcross(task.image);
  ToneMap map;
  FovealImage foveal = fovealImage(task.image, field);
  const bool glare = isOn(arguments, "glare"), sharpness = isOn(arguments, "acuity"),
             colour = isOn(arguments, "colour");
  if (glare || sharpness || colour) {
    map.seen = task.image;
    if (glare) addVeil(*map.seen, foveal);
    if (colour) fadeColours(*map.seen, foveal);
    if (sharpness) blurToAcuity(*map.seen, foveal);
  }
  const double white = task.white_cd_m2 > 0 ? task.white_cd_m2 : 100;
  const double displayTo = std::log(white),
               displayFrom = std::log(white * std::max(task.darkest, 1 / numberOf(arguments, "range")));
  Histogram histogram = histogramOf(foveal);
  const bool adjusted = adjust(histogram, displayFrom, displayTo, contrast == "human");
  if (!adjusted) {  // the scene's range fits: the same visibility by one factor
    const double average = task.statistics.logAverage_cd_m2 > 0 ? task.statistics.logAverage_cd_m2 : 1;
    double factor = justNoticeable(std::sqrt(white * std::exp(displayFrom))) / justNoticeable(average);
    factor = std::min(factor, white / std::exp(histogram.to));
    map.curve = std::make_shared<ToneCurve>([&](double luminance) { return luminance * factor / white; });
    map.white_cd_m2 = white / factor;
    map.method =
        fmt::format("Ward: the scene's contrast fits the display, linear; white is {:.4g} cd/m2", map.white_cd_m2);
    return map;
  }
  const std::vector<double> cumulative = histogram.cumulative();
  map.curve = std::make_shared<ToneCurve>([&](double luminance) {
    const double at = (std::log(luminance) - histogram.from) / histogram.step();
    // Below the darkest fixation: in proportion; above the brightest: white.
    if (at <= 0) return std::exp(displayFrom) / white * luminance / std::exp(histogram.from);
    if (at >= bins) return 1.0;
    const auto i = static_cast<std::size_t>(at);
    const double share = cumulative[i] + (at - static_cast<double>(i)) * (cumulative[i + 1] - cumulative[i]);
    return std::exp(displayFrom + (displayTo - displayFrom) * share) / white;  // equation 4
  });
  map.method = fmt::format("Ward: histogram adjustment, contrast as seen {}{}{}{}, from {:.3g} to {:.3g} cd/m2",
                           contrast == "human" ? "by the eye" : "at most linear", glare ? ", glare" : "",
                           sharpness ? ", acuity" : "", colour ? ", colour" : "", std::exp(histogram.from),
                           std::exp(histogram.to));
  return map;
}

}  // namespace

MappingType wardMapping() {
  return {
      "ward",
      "visibility matching: every contrast that is seen in the scene is seen on the display, and none besides",
      "Ward Larson, Rushmeier and Piatko, IEEE TVCG 3(4), 1997",
      {mappingText("contrast", "human", "what bounds contrast: human (the eye's threshold) or linear"),
       mappingSwitch("glare", "veiling luminance in the eye"), mappingSwitch("acuity", "loss of sharpness in the dark"),
       mappingSwitch("colour", "loss of colour in the dark"),
       mappingNumber("range", "100", 1, false, "of the display's luminances, where black and flare are less"),
       mappingNumber("field", "0", 0, true, "width of the view in degrees; 0: as the image says, else 60")},
      make};
}

}  // namespace goniolux::display
