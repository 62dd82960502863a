// The display stage: a calibrated image becomes a picture for a device, with an account of what the device cannot show.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string>

#include "core/text.h"
#include "display/adopted_white.h"
#include "display/display_image.h"
#include "display/film.h"
#include "display/picture_file.h"
#include "image/image_file.h"
#include "pipeline/display_inverse.h"
#include "pipeline/stages.h"
#include "pipeline/text_option.h"

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

// --exposure and --white are short for the mapping "linear" with ev and white.
display::MappingChoice mapping(const StageRequest& request) {
  const bool hasWhite = request.options.contains("white"), hasExposure = request.options.contains("exposure");
  if (hasWhite && hasExposure) {
    throw core::InputError({"--white", 0, 0}, "exposure",
                           "--white and --exposure both set the brightness; give one of them");
  }
  if ((hasWhite || hasExposure) && request.options.contains("mapping")) {
    throw core::InputError({"--mapping", 0, 0}, "exposure",
                           "--mapping sets the brightness itself; give it without --exposure and --white");
  }
  if (hasExposure) return display::mappingNamed("linear:ev=" + request.options.at("exposure"));
  if (!hasWhite) return display::mappingNamed(optionOr(request, "mapping", "linear"));
  const std::string& text = request.options.at("white");
  const auto value = core::parseNumber(text);
  if (!value || !(*value > 0) || !std::isfinite(*value)) {
    throw core::InputError({"--white", 0, 0}, "exposure",
                           fmt::format("'{}' is no luminance; give cd/m2 above 0", text));
  }
  return display::mappingNamed("linear:white=" + text);
}

int bits(const StageRequest& request, const std::string& output) {
  const std::vector<int> possible = display::bitsOf(display::pictureFormat(output));
  const std::string text = optionOr(request, "bits", std::to_string(possible.front()));
  for (const int each : possible)
    if (text == std::to_string(each)) return each;
  throw core::InputError(
      {"--bits", 0, 0}, "bits",
      fmt::format("{} pictures cannot have '{}' bits; they have {}", std::filesystem::path(output).extension().string(),
                  text, fmt::join(possible, " or ")));
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

Value rowsOf(const core::Mat3& matrix) {
  Value::Array rows;
  for (int row = 0; row < 3; ++row)
    rows.push_back(Value::arrayOf(std::vector<double>{matrix[0][row], matrix[1][row], matrix[2][row]}));
  return rows;
}

std::string printed(const char* title, const core::Mat3& matrix) {
  std::string text = fmt::format("  {}\n", title);
  for (int row = 0; row < 3; ++row)
    text += fmt::format("               {:9.6f} {:9.6f} {:9.6f}\n", matrix[0][row], matrix[1][row], matrix[2][row]);
  return text;
}

// The matrices that the device's description gives.
void addMatrices(StageReport& report, const display::Device& device) {
  if (device.kind == display::Device::Kind::icc) return;
  const core::Mat3 fromXyz = glm::inverse(display::xyzFromRgb(device));
  const bool film = device.kind == display::Device::Kind::film;
  report.json.set("rgb_from_xyz", rowsOf(fromXyz));
  report.text += printed(film ? "R, G, B of the composite primaries from X, Y, Z (white: Y = 1)"
                              : "linear R, G, B from X, Y, Z (white: Y = 1)",
                         fromXyz);
  if (!film) return;
  const core::Mat3 crosstalk = display::recorderCrosstalk(*device.film);
  report.json.set("recorder_crosstalk", rowsOf(crosstalk));
  report.text += printed("exposure of the film's layers by the recorder's colours (columns)", crosstalk);
}

void addShortfalls(StageReport& report, const display::DisplayedImage& shown) {
  const std::size_t all = shown.shortfalls.size();
  Value& json = report.json;
  json.set("clipped", counted(shown.tooBright, all));
  json.set("out_of_gamut", counted(shown.outOfGamut, all));
  json.set("too_dark", counted(shown.tooDark, all));
  json.set("invalid", counted(shown.invalid, all));
  Value delta;
  delta.set("mean", shown.deltaMean);
  delta.set("p95", shown.deltaP95);
  delta.set("max", shown.deltaMax);
  delta.set("pixels", static_cast<std::uint64_t>(shown.deltaPixels));
  json.set("delta_e00", std::move(delta));
  report.text += fmt::format("  too bright   {} pixels clipped\n", share(shown.tooBright, all));
  report.text += fmt::format("  too pure     {} pixels out of gamut\n", share(shown.outOfGamut, all));
  if (shown.tooDark > 0)
    report.text += fmt::format("  too dark     {} pixels below black and flare\n", share(shown.tooDark, all));
  report.text += fmt::format("  colours      dE00 from intended to shown: mean {:.2f}, 95 % {:.2f}, largest {:.1f}\n",
                             shown.deltaMean, shown.deltaP95, shown.deltaMax);
}

StageReport run(const StageRequest& request, core::ProgressSink& progress) {
  const std::string& input = request.inputs.at(0);
  const display::Device device = display::readDevice(optionOr(request, "device", "srgb"));
  if (request.options.contains("inverse")) return inverseReport(request, device);
  const std::string output =
      request.common.output.value_or(std::filesystem::path(input).replace_extension(".png").string());
  std::error_code ignored;
  if (std::filesystem::equivalent(input, output, ignored))
    throw core::InputError({output, 0, 0}, "overwrite",
                           "the picture would take the place of the calibrated image; give it another name with -o");
  display::DisplaySettings settings;
  settings.bits = bits(request, output);
  settings.mapping = mapping(request);
  settings.adaptation = display::adaptationNamed(optionOr(request, "cat", "cat16"));
  settings.gamut = display::gamutMappingNamed(optionOr(request, "gamut", "clip"));
  const std::string map = optionOr(request, "map", "");
  if (!map.empty()) (void)display::pictureFormat(map);

  progress.progress("reading the image", 0, "");
  const image::XyzImage image = image::readImage(input);
  settings.adoptedWhite = adoptedWhite(request, image);
  progress.progress("mapping to the device", 0.4, "");
  const display::DisplayedImage shown = display::displayImage(image, device, settings);
  progress.progress("writing the picture", 0.6, "");
  display::writePicture(output, shown.codes, device);
  StageReport report;
  report.files = {output};
  if (!map.empty()) {
    display::CodeImage codes = display::shortfallMap(shown);
    const int wanted = display::bitsOf(display::pictureFormat(map)).front();
    for (std::uint16_t& code : codes.rgb) code = static_cast<std::uint16_t>(code << (wanted - codes.bits));
    codes.bits = wanted;
    display::writePicture(map, codes, display::readDevice("srgb"));
    report.files.push_back(map);
  }
  progress.progress("done", 1, output);

  Value& json = report.json;
  json.set("image", input);
  json.set("file", output);
  if (!map.empty()) json.set("map", map);
  json.set("device", device.name);
  json.set("width", shown.codes.width);
  json.set("height", shown.codes.height);
  json.set("bits", shown.codes.bits);
  json.set("mapping", settings.mapping.type->name);
  Value brightness;
  brightness.set("method", shown.method);
  brightness.set("white_cd_m2", shown.white_cd_m2 > 0 ? Value(shown.white_cd_m2) : Value());
  brightness.set("log_average_cd_m2", shown.statistics.logAverage_cd_m2);
  json.set("exposure", brightness);
  const auto& white = settings.adoptedWhite;
  json.set("adopted_white", white ? Value::arrayOf(std::vector<double>{white->x, white->y}) : Value());

  report.text = fmt::format("{}: {} x {} pixels, {} bit, {}\n", output, shown.codes.width, shown.codes.height,
                            shown.codes.bits, device.name);
  report.text += fmt::format("  mapping      {}", shown.method);
  report.text += shown.white_cd_m2 > 0 ? fmt::format("; white is {:.4g} cd/m2\n", shown.white_cd_m2) : "\n";
  if (white) {
    report.text +=
        fmt::format("  adaptation   from white x = {:.4f}, y = {:.4f} to the device's\n", white->x, white->y);
  }
  addShortfalls(report, shown);
  addMatrices(report, device);
  if (shown.invalid > 0) {
    report.warnings.warning({input, 0, 0}, "invalid-pixels",
                            fmt::format("{} pixels are not numbers (not rendered yet?) and shown black",
                                        share(shown.invalid, shown.shortfalls.size())));
  }
  return report;
}

std::string mappingHelp() {
  std::string text = "NAME or NAME:KEY=VALUE,KEY: ";
  for (const display::MappingType& type : display::mappingTypes()) {
    text += fmt::format("{} ({}", type.name, type.title);
    if (!type.parameters.empty()) {
      std::vector<std::string> keys;
      for (const core::Parameter& parameter : type.parameters) keys.push_back(parameter.key);
      text += fmt::format("; keys {}", fmt::join(keys, ", "));
    }
    text += &type == &display::mappingTypes().back() ? ")" : "); ";
  }
  return text;
}

}  // namespace

Stage displayStage() {
  Stage stage;
  stage.name = "display";
  stage.title = "Turn a calibrated image into a picture for a device";
  stage.help =
      "Reads an image of CIE X, Y, Z in cd/m2 (OpenEXR, Radiance .hdr) and writes a picture for a monitor, a film "
      "recorder or any device with an ICC profile: PNG, TIFF, JPEG, DPX, or EXR (the light that the device gives), as "
      "the "
      "ending of -o says. Reports what the device cannot show, and the device's matrix. With --inverse the way back: a "
      "picture (PNG, TIFF, JPEG, DPX) becomes "
      "the "
      "X, Y, Z that the device gives for its codes, and a text file with lines 'R G B' or 'R G B X Y Z' (measured) a "
      "table of predictions and colour differences.";
  stage.inputName = "IMAGE";
  const std::string devices = fmt::format("a *.device.json file, an ICC profile, or one of the presets {}",
                                          fmt::join(display::presetNames(), ", "));
  const std::string gamuts = fmt::format("{}: neutral and compress go towards the grey of the same luminance",
                                         fmt::join(display::gamutMappingNames(), ", "));
  core::Parameter inverse =
      textOption("inverse", "the way back", "", "from code values to the light of the device", false);
  inverse.kind = core::ParameterKind::boolean;
  stage.options = {
      textOption("device", "the device", "srgb", devices.c_str(), false),
      textOption("mapping", "luminance mapping", "linear", mappingHelp().c_str(), false),
      textOption("exposure", "brightness", "auto",
                 "short for --mapping linear:ev=...; auto: the log-average luminance is shown as 18 % of white, or "
                 "darker where that clips over 5 %; auto+1, auto-1: stops brighter or darker; a number: EV at ISO 100",
                 false),
      textOption("white", "luminance shown as white, cd/m2", "", "instead of --exposure", false),
      textOption("adapt", "white that the eye is adapted to", "auto",
                 "auto: the white that the image names, none, or CIE x,y; it becomes the device's white", false),
      textOption("cat", "chromatic adaptation", "cat16",
                 fmt::format("{}", fmt::join(display::adaptationNames(), ", ")).c_str(), false),
      textOption("gamut", "colours that are too pure", "clip", gamuts.c_str(), false),
      textOption("bits", "bits per channel", "", "8 or 16 for PNG (8 when not given), 16 TIFF and EXR, 8 JPEG, 10 DPX",
                 false),
      textOption("map", "picture of what cannot be shown", "",
                 "magenta: out of gamut, yellow: too bright, red: both, cyan: too dark", false),
      inverse};
  stage.run = run;
  return stage;
}

}  // namespace goniolux::pipeline
