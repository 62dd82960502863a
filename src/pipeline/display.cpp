// The display stage: a calibrated image becomes a picture for a device, with an account of what the device cannot show.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <charconv>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string>

#include "display/adopted_white.h"
#include "display/device.h"
#include "display/exposure.h"
#include "display/mapping.h"
#include "display/picture_file.h"
#include "image/image_file.h"
#include "pipeline/stages.h"

namespace goniolux::pipeline {
namespace {

using core::Value;
using spectrum::Chromaticity;

std::string optionOr(const StageRequest& request, const char* key, std::string otherwise) {
  const auto found = request.options.find(key);
  return found != request.options.end() ? found->second : std::move(otherwise);
}

std::optional<Chromaticity> adoptedWhite(const StageRequest& request, const image::XyzImage& image) {
  const std::string adapt = optionOr(request, "adapt", "auto");
  if (adapt == "none") return std::nullopt;
  if (adapt == "auto") return display::adoptedWhiteOf(image);
  const auto white = display::chromaticityFrom(adapt);
  if (!white) {
    throw core::InputError({"--adapt", 0, 0}, "adapt",
                           fmt::format("'{}' is no white; give auto, none, or CIE x,y such as 0.4476,0.4074", adapt));
  }
  return white;
}

display::Exposure exposure(const StageRequest& request, const display::LuminanceStatistics& statistics) {
  const auto white = request.options.find("white");
  if (white == request.options.end()) return display::exposureFrom(optionOr(request, "exposure", "auto"), statistics);
  if (request.options.contains("exposure")) {
    throw core::InputError({"--white", 0, 0}, "exposure",
                           "--white and --exposure both set the brightness; give one of them");
  }
  double value = 0;
  const std::string& text = white->second;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || stop != text.data() + text.size() || !(value > 0) || !std::isfinite(value)) {
    throw core::InputError({"--white", 0, 0}, "exposure",
                           fmt::format("'{}' is no luminance; give cd/m2 above 0", text));
  }
  return display::whiteAt(value);
}

int bits(const StageRequest& request, display::PictureFormat format) {
  const std::string text = optionOr(request, "bits", format == display::PictureFormat::png ? "8" : "16");
  if (text == "16" || (text == "8" && format == display::PictureFormat::png)) return std::stoi(text);
  throw core::InputError({"--bits", 0, 0}, "bits",
                         format == display::PictureFormat::png
                             ? fmt::format("'{}' bits cannot be written; give 8 or 16", text)
                             : "TIFF pictures have 16 bits");
}

Value counted(std::size_t pixels, std::size_t all) {
  Value value;
  value.set("pixels", static_cast<std::uint64_t>(pixels));
  value.set("fraction", static_cast<double>(pixels) / static_cast<double>(all));
  return value;
}

std::string share(std::size_t pixels, std::size_t all) {
  return fmt::format("{} ({:.2f} %)", pixels, 100 * static_cast<double>(pixels) / static_cast<double>(all));
}

StageReport run(const StageRequest& request, core::ProgressSink& progress) {
  const std::string& input = request.inputs.at(0);
  const std::string output =
      request.common.output.value_or(std::filesystem::path(input).replace_extension(".png").string());
  const display::Device device = display::readDevice(optionOr(request, "device", "srgb"));
  display::MappingSettings settings;
  settings.bits = bits(request, display::pictureFormat(output));

  progress.progress("reading the image", 0, "");
  const image::XyzImage image = image::readImage(input);
  settings.adoptedWhite = adoptedWhite(request, image);
  const display::LuminanceStatistics statistics =
      display::luminanceStatistics(image, display::rgbFromXyz(device, settings.adoptedWhite));
  const display::Exposure exposed = exposure(request, statistics);
  settings.white_cd_m2 = exposed.white_cd_m2;
  progress.progress("mapping to the device", 0.4, "");
  const display::CodeImage codes = display::mapToDevice(image, device, settings);
  progress.progress("writing the picture", 0.6, "");
  display::writePicture(output, codes, device);
  progress.progress("done", 1, output);

  const std::size_t all = image.y.size();
  StageReport report;
  report.files = {output};
  Value& json = report.json;
  json.set("image", input);
  json.set("file", output);
  json.set("device", device.name);
  json.set("width", image.width);
  json.set("height", image.height);
  json.set("bits", codes.bits);
  Value brightness;
  brightness.set("method", exposed.method);
  brightness.set("white_cd_m2", exposed.white_cd_m2);
  brightness.set("log_average_cd_m2", statistics.logAverage_cd_m2);
  json.set("exposure", brightness);
  const auto& white = settings.adoptedWhite;
  json.set("adopted_white", white ? Value::arrayOf(std::vector<double>{white->x, white->y}) : Value());
  json.set("clipped", counted(codes.clipped, all));
  json.set("out_of_gamut", counted(codes.outOfGamut, all));
  json.set("invalid", counted(codes.invalid, all));

  report.text =
      fmt::format("{}: {} x {} pixels, {} bit, {}\n", output, image.width, image.height, codes.bits, device.name);
  report.text += fmt::format("  exposure     {}; white is {:.4g} cd/m2\n", exposed.method, exposed.white_cd_m2);
  if (settings.adoptedWhite) {
    report.text += fmt::format("  adaptation   from white x = {:.4f}, y = {:.4f} to the device's\n",
                               settings.adoptedWhite->x, settings.adoptedWhite->y);
  }
  report.text += fmt::format("  too bright   {} pixels clipped\n", share(codes.clipped, all));
  report.text += fmt::format("  too pure     {} pixels out of gamut, clipped\n", share(codes.outOfGamut, all));
  if (codes.invalid > 0) {
    report.warnings.warning(
        {input, 0, 0}, "invalid-pixels",
        fmt::format("{} pixels are not numbers (not rendered yet?) and shown black", share(codes.invalid, all)));
  }
  return report;
}

core::Parameter option(std::string key, std::string title, std::string standard, std::string help) {
  core::Parameter parameter;
  parameter.key = std::move(key);
  parameter.title = std::move(title);
  parameter.kind = core::ParameterKind::text;
  parameter.defaultText = std::move(standard);
  parameter.help = std::move(help);
  return parameter;
}

}  // namespace

Stage displayStage() {
  Stage stage;
  stage.name = "display";
  stage.title = "Turn a calibrated image into a picture for a device";
  stage.help =
      "Reads an OpenEXR image of CIE X, Y, Z in cd/m2 and writes a PNG or TIFF for a display, as the ending of -o "
      "says. Colours that "
      "the device cannot show are clipped to its gamut and counted.";
  stage.inputName = "IMAGE.exr";
  stage.options = {
      option("device", "the display", "srgb",
             fmt::format("a *.device.json file, or one of the presets {}", fmt::join(display::presetNames(), ", "))),
      option("exposure", "brightness", "auto",
             "auto: the log-average luminance is shown as 18 % of white, or darker where that clips over 5 %; auto+1, "
             "auto-1: stops brighter or darker; a "
             "number: EV at "
             "ISO 100"),
      option("white", "luminance shown as white, cd/m2", "", "instead of --exposure"),
      option("adapt", "white that the eye is adapted to", "auto",
             "auto: the white that the image names, none, or CIE x,y; it becomes the device's white (CAT16)"),
      option("bits", "bits per channel", "", "8 or 16 for PNG (8 when not given), 16 for TIFF")};
  stage.run = run;
  return stage;
}

}  // namespace goniolux::pipeline
