// The stage `compare`: how far two images of one view are apart.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/text.h"
#include "display/adopted_white.h"
#include "display/display_image.h"
#include "display/exposure.h"
#include "display/picture_file.h"
#include "image/comparison.h"
#include "image/exr.h"
#include "image/image_file.h"
#include "pipeline/stages.h"
#include "pipeline/text_option.h"

namespace goniolux::pipeline {
namespace {

using core::Value;

// White of CIELAB: its luminance given, or what automatic exposure of the first image shows as white.
double whiteLuminance(const StageRequest& request, const image::XyzImage& first) {
  const auto given = request.options.find("white");
  if (given == request.options.end())
    return display::automaticExposure(display::luminanceStatistics(first, core::Mat3(1))).white_cd_m2;
  const auto value = core::parseNumber(given->second);
  if (!value || !(*value > 0) || !std::isfinite(*value)) {
    throw core::InputError({"--white", 0, 0}, "white",
                           fmt::format("'{}' is no luminance; give cd/m2 above 0", given->second));
  }
  return *value;
}

// CIEDE2000 of every pixel in false colours; the scale ends at what 5 % of the pixels exceed, rounded up.
void writeDeltaMap(const std::string& path, const image::Comparison& result, int width, int height) {
  image::XyzImage map;
  map.width = width;
  map.height = height;
  map.x = map.y = map.z = result.delta;
  const double most = std::max(1.0, std::ceil(result.deltaP95));
  display::DisplaySettings settings;
  settings.mapping =
      display::mappingNamed(fmt::format("false-colour:max={:g},palette=viridis,unit=dE00", std::min(most, 100.0)));
  settings.bits = display::bitsOf(display::pictureFormat(path)).front();
  const display::Device srgb = display::readDevice("srgb");
  display::writePicture(path, display::displayImage(map, srgb, settings).codes, srgb);
}

StageReport run(const StageRequest& request, core::ProgressSink& progress) {
  if (request.inputs.size() != 2) {
    throw core::InputError({"compare", 0, 0}, "usage", "two images are needed: goniolux compare A.exr B.exr");
  }
  const std::string& nameA = request.inputs[0];
  const std::string& nameB = request.inputs[1];
  const std::string output = request.common.output.value_or("");
  if (!output.empty() && core::lowerCase(std::filesystem::path(output).extension().string()) != ".exr") {
    throw core::InputError({output, 0, 0}, "difference-image", "the difference image is an OpenEXR file; name it .exr");
  }
  const auto asked = request.options.find("map");
  const std::string map = asked != request.options.end() ? asked->second : "";
  if (!map.empty()) (void)display::pictureFormat(map);
  progress.progress("reading the images", 0, "");
  const image::XyzImage a = image::readImage(nameA), b = image::readImage(nameB);
  if (a.width != b.width || a.height != b.height) {
    throw core::InputError({nameB, 0, 0}, "image-size",
                           fmt::format("the images differ in size: {} x {} and {} x {} pixels; render both alike",
                                       a.width, a.height, b.width, b.height));
  }
  const double luminance = whiteLuminance(request, a);
  const spectrum::Chromaticity chromaticity = display::adoptedWhiteOf(a).value_or(display::daylight);
  const spectrum::Xyz white{luminance * chromaticity.x / chromaticity.y, luminance,
                            luminance * (1 - chromaticity.x - chromaticity.y) / chromaticity.y};
  progress.progress("comparing", 0.4, "");
  const image::Comparison result = image::compare(a, b, white);

  StageReport report;
  if (!output.empty()) {
    image::XyzImage difference = image::difference(a, b);
    difference.attributes = {{"program", "Goniolux"}, {"difference", nameB + " - " + nameA}};
    image::writeExr(output, difference);
    report.files.push_back(output);
  }
  if (!map.empty()) {
    writeDeltaMap(map, result, a.width, a.height);
    report.files.push_back(map);
  }
  Value& json = report.json;
  json.set("first", nameA);
  json.set("second", nameB);
  json.set("pixels", static_cast<std::uint64_t>(result.pixels));
  json.set("mean_luminance_cd_m2", result.meanLuminance);
  json.set("luminance_rmse", result.luminanceRmse);
  json.set("luminance_rmse_relative",
           result.meanLuminance > 0 ? Value(result.luminanceRmse / result.meanLuminance) : Value());
  json.set("luminance_bias", result.luminanceBias);
  json.set("luminance_max_difference", result.largestDifference);
  Value delta;
  delta.set("mean", result.deltaMean);
  delta.set("p95", result.deltaP95);
  delta.set("max", result.deltaMax);
  delta.set("white_cd_m2", luminance);
  delta.set("white_xy", Value::arrayOf(std::vector<double>{chromaticity.x, chromaticity.y}));
  json.set("delta_e00", std::move(delta));
  json.set("within_half_widths", result.within ? Value(*result.within) : Value());
  if (!output.empty()) json.set("file", output);

  report.text = fmt::format("{} and {}: {} x {} pixels\n", nameA, nameB, a.width, a.height);
  report.text +=
      fmt::format("  luminance    RMSE {:.4g} cd/m2 ({:.3g} % of the mean {:.4g}), bias {:+.4g}, largest {:.4g}\n",
                  result.luminanceRmse, 100 * result.luminanceRmse / result.meanLuminance, result.meanLuminance,
                  result.luminanceBias, result.largestDifference);
  report.text += fmt::format("  dE00         mean {:.3g}, 95 % {:.3g}, largest {:.3g} (white {:.4g} cd/m2)\n",
                             result.deltaMean, result.deltaP95, result.deltaMax, luminance);
  if (result.within)
    report.text += fmt::format("  half-widths  {:.1f} % of the pixels differ by no more than both have together\n",
                               100 * *result.within);
  const std::size_t left = a.y.size() - result.pixels;
  if (left > 0) {
    report.warnings.warning({nameA, 0, 0}, "invalid-pixels",
                            fmt::format("{} pixels are not numbers in one of the images and left out", left));
  }
  return report;
}

}  // namespace

Stage compareStage() {
  Stage stage;
  stage.name = "compare";
  stage.title = "Say how far two images are apart";
  stage.help =
      "Two images of one view (OpenEXR, Radiance .hdr): root mean square difference of luminance, CIEDE2000 colour "
      "difference (mean, 95 %, largest), and how many pixels agree within their half-widths. With -o FILE.exr the "
      "difference, second less first, is written as an image of X, Y, Z.";
  stage.inputName = "IMAGE";
  stage.manyInputs = true;
  stage.options = {textOption("map", "picture of the colour differences", "",
                              "CIEDE2000 of every pixel in false colours with a scale: .png, .tif, .jpg", false),
                   textOption("white", "luminance of CIELAB's white, cd/m2", "",
                              "by default what automatic exposure of the first image shows as white", false)};
  stage.run = run;
  return stage;
}

}  // namespace goniolux::pipeline
