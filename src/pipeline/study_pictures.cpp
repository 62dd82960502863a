// The reference and the runs of a study on a picture: the project's first view, small.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/parallel.h"
#include "core/random.h"
#include "core/statistics.h"
#include "core/text.h"
#include "image/comparison.h"
#include "image/exr.h"
#include "pipeline/engine.h"
#include "pipeline/render.h"
#include "pipeline/study.h"
#include "pipeline/study_choices.h"
#include "viewing/pixel_loop.h"

namespace goniolux::pipeline {
namespace {

namespace fs = std::filesystem;

constexpr int studyWidth = 96;  // pixels
constexpr double referenceAccuracy = 0.005;
constexpr int referenceSamples = 1 << 16;
constexpr double longEnough = 0.7;  // of the time that a kept reference would be given now
constexpr double leastShare = 0.1;
// As pictures are asked for: 95 % of the pixels. The others lie across the edges of luminaires, whose place in a pixel
// is all that their error tells of.
constexpr double shareCounted = 0.95;
constexpr double replicates = 16;  // of every pixel
constexpr const char *keyAttribute = "studyKey", *secondsAttribute = "studySeconds";

bool isKnown(const image::XyzImage& image, const std::string& key, double seconds) {
  const auto of = image.attributes.find(keyAttribute), took = image.attributes.find(secondsAttribute);
  return of != image.attributes.end() && of->second == key && took != image.attributes.end() &&
         core::parseNumber(took->second).value_or(0) >= longEnough * seconds;
}

/// What errors of a pixel are relative to, as those of a grid's points: its luminance, or a tenth of the mean.
std::vector<double> scalesOf(const image::XyzImage& image) {
  double sum = 0;
  for (const float y : image.y) sum += static_cast<double>(y);
  std::vector<double> scales;
  for (const float y : image.y)
    scales.push_back(std::max(static_cast<double>(y), leastShare * sum / static_cast<double>(image.y.size())));
  return scales;
}

/// Root of the mean square, the farthest pixels left out.
double rmsOfMost(std::vector<double> squares) {
  std::sort(squares.begin(), squares.end());
  squares.resize(static_cast<std::size_t>(std::ceil(shareCounted * static_cast<double>(squares.size()))));
  double sum = 0;
  for (const double square : squares) sum += square;
  return squares.empty() ? 0 : std::sqrt(sum / static_cast<double>(squares.size()));
}

double noiseOf(const image::XyzImage& image, double confidence) {
  const double quantile = core::studentQuantile(replicates - 1, confidence);
  const std::vector<double> scales = scalesOf(image);
  std::vector<double> squares;
  for (std::size_t i = 0; i < image.halfWidth.size(); ++i)
    if (scales[i] > 0) squares.push_back(std::pow(static_cast<double>(image.halfWidth[i]) / quantile / scales[i], 2));
  return rmsOfMost(std::move(squares));
}

/// RMS, largest and mean error of the luminances.
void compareLuminances(const image::XyzImage& found, const image::XyzImage& reference, StudyRun& run) {
  const std::vector<double> scales = scalesOf(reference);
  std::vector<double> squares;
  double sum = 0;
  for (std::size_t i = 0; i < reference.y.size(); ++i) {
    if (!(scales[i] > 0) || !std::isfinite(found.y[i])) continue;
    const double error = (static_cast<double>(found.y[i]) - static_cast<double>(reference.y[i])) / scales[i];
    squares.push_back(error * error);
    sum += error;
    run.largest = std::max(run.largest, std::abs(error));
  }
  if (squares.empty()) return;
  run.mean = sum / static_cast<double>(squares.size());
  run.rms = rmsOfMost(std::move(squares));
}

}  // namespace

StudyPicture makePictureReference(const project::Project& project, const std::string& key, const std::string& file,
                                  double seconds, core::ProgressSink& progress) {
  StudyPicture picture;
  picture.view = smallFirstView(project, studyWidth);
  bool known = false;
  if (fs::exists(file)) {
    try {
      picture.image = image::readExr(file);
      known = picture.image.width == picture.view.width && picture.image.height == picture.view.height &&
              isKnown(picture.image, key, seconds);
    } catch (const core::InputError&) {
      known = false;  // damaged: made again
    }
  }
  if (!known) {
    project::Project own = project;
    own.settings.solver = "path";
    own.settings.accuracy.image = referenceAccuracy;
    own.settings.pixelMaxSamples = referenceSamples;
    own.settings.pixelContrast = 1;
    const double start = core::wallSeconds();
    const Engine engine(own, true);
    viewing::ImageEstimate estimate = viewing::renderView(*engine.solver, picture.view, engine.world.origin,
                                                          core::mix(project.settings.seed ^ 0x5eedull),
                                                          pixelAccuracyOf(own.settings), seconds, progress);
    picture.image = std::move(estimate.image);
    picture.image.attributes = {
        {keyAttribute, key},
        {secondsAttribute, fmt::format("{:g}", estimate.reached ? 1e9 : core::wallSeconds() - start)},
        {"program", "Goniolux " + programVersion()}};
    if (!progress.cancelled()) image::writeExr(file, picture.image);
  }
  picture.white = lightestOf(picture.image);
  picture.noise = noiseOf(picture.image, project.settings.accuracy.confidence);
  return picture;
}

StudyRun runPicture(const project::Project& project, const StudySetting& setting, const StudyPicture& reference,
                    std::uint64_t seed, double seconds, core::ProgressSink& progress) {
  project::Project own = withSetting(project, setting, seed, seconds);
  own.settings.accuracy.image = setting.accuracy;
  StudyRun run;
  run.setting = setting;
  forgetPeakMemory();
  const double cpu = core::processCpuSeconds(), wall = core::wallSeconds();
  const Engine engine(own, true);
  const viewing::ImageEstimate estimate =
      viewing::renderView(*engine.solver, reference.view, engine.world.origin, core::mix(seed),
                          pixelAccuracyOf(own.settings), seconds, progress);
  run.cpu_s = core::processCpuSeconds() - cpu;
  run.wall_s = core::wallSeconds() - wall;
  run.rays = engine.solver->rays();
  run.reached = estimate.reached;
  run.peakMemory_MiB = peakMemory_MiB();
  if (const std::vector<std::string> leftOut = leftOutSentences(engine); !leftOut.empty())
    run.leftOut = leftOut.front();
  const image::Comparison found = image::compare(reference.image, estimate.image, reference.white);
  compareLuminances(estimate.image, reference.image, run);
  run.inside = found.within.value_or(0);
  run.delta = found.deltaMean;
  run.deltaP95 = found.deltaP95;
  return run;
}

}  // namespace goniolux::pipeline
