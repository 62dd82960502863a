// The stage `probe`: what an imaging luminance meter would read in an image.
#include <fmt/format.h>

#include <cmath>

#include "core/text.h"
#include "image/image_file.h"
#include "image/patch.h"
#include "pipeline/stages.h"

namespace goniolux::pipeline {
namespace {

using core::Value;
using image::Measured;

struct Place {
  int column = 0, row = 0;
  double radius = 0;
};

// "x,y" or "x,y,radius", pixels from the top left.
Place placeFrom(const std::string& text, const image::XyzImage& image) {
  core::TextScanner scanner(text);
  std::vector<double> numbers;
  while (const auto word = scanner.word(",")) {
    const auto value = core::parseNumber(word->text);
    if (!value || !std::isfinite(*value)) break;
    numbers.push_back(*value);
  }
  const bool fits = scanner.atEnd() && (numbers.size() == 2 || numbers.size() == 3);
  if (!fits || (numbers.size() == 3 && numbers[2] < 0)) {
    throw core::InputError({text, 0, 0}, "place",
                           fmt::format("'{}' is no place in an image; give x,y or x,y,radius in pixels from the top "
                                       "left, such as 320,240,5",
                                       text));
  }
  if (!(numbers[0] >= 0 && numbers[0] < image.width && numbers[1] >= 0 && numbers[1] < image.height)) {
    throw core::InputError({text, 0, 0}, "place",
                           fmt::format("({:g}, {:g}) lies outside the image; x runs from 0 to {}, y from 0 (top) to {}",
                                       numbers[0], numbers[1], image.width - 1, image.height - 1));
  }
  return {static_cast<int>(numbers[0]), static_cast<int>(numbers[1]), numbers.size() == 3 ? numbers[2] : 0};
}

Value toJson(const Measured& measured) {
  Value value;
  value.set("value", measured.value);
  value.set("half_width", measured.halfWidth);
  return value;
}

Value toJson(const Place& place, const image::PatchReading& reading) {
  Value json;
  json.set("pixel",
           Value::arrayOf(std::vector<double>{static_cast<double>(place.column), static_cast<double>(place.row)}));
  json.set("radius", place.radius);
  json.set("pixels", static_cast<std::uint64_t>(reading.pixels));
  if (reading.invalid > 0) json.set("invalid", static_cast<std::uint64_t>(reading.invalid));
  json.set("luminance_cd_m2", toJson(reading.luminance));
  json.set("x", toJson(reading.x));
  json.set("y", toJson(reading.y));
  json.set("cct_k", reading.colourTemperature ? toJson(*reading.colourTemperature) : Value());
  json.set("duv", reading.duv);
  json.set("least_cd_m2", reading.least);
  json.set("most_cd_m2", reading.most);
  if (!reading.spectrum.empty()) {
    std::vector<double> wavelengths, values;
    for (const auto& [wavelength, value] : reading.spectrum) {
      wavelengths.push_back(wavelength);
      values.push_back(value);
    }
    Value spectrum;
    spectrum.set("wavelengths_nm", Value::arrayOf(wavelengths));
    spectrum.set("radiance_w_m2_sr_nm", Value::arrayOf(values));
    json.set("spectrum", std::move(spectrum));
  }
  return json;
}

std::string text(const Measured& measured, const char* format) {
  const std::string value = fmt::format(fmt::runtime(format), measured.value);
  if (std::isnan(measured.halfWidth)) return value;
  return fmt::format("{} ± {:.2g}", value, measured.halfWidth);
}

std::string text(const Place& place, const image::PatchReading& reading, const std::string& unit) {
  std::string out = fmt::format("({}, {})", place.column, place.row);
  if (place.radius > 0) out += fmt::format(" and {:g} pixels about it ({} pixels)", place.radius, reading.pixels);
  if (reading.pixels == 0) return out + ": no number there\n";
  out += fmt::format("\n  luminance        {} {}", text(reading.luminance, "{:.5g}"), unit);
  if (reading.pixels > 1) out += fmt::format("  ({:.4g} to {:.4g})", reading.least, reading.most);
  out += fmt::format("\n  chromaticity     x {}, y {}\n", text(reading.x, "{:.4f}"), text(reading.y, "{:.4f}"));
  if (reading.colourTemperature) {
    out +=
        fmt::format("  colour temp.     {} K, Duv {:+.4f}\n", text(*reading.colourTemperature, "{:.0f}"), reading.duv);
  } else {
    out += "  colour temp.     none: too far from the colours of black bodies\n";
  }
  for (const auto& [wavelength, value] : reading.spectrum)
    out += fmt::format("  {:>8g} nm      {:.5g} W/(m2 sr nm)\n", wavelength, value);
  return out;
}

StageReport run(const StageRequest& request, core::ProgressSink&) {
  if (request.inputs.size() < 2) {
    throw core::InputError({"probe", 0, 0}, "usage",
                           "an image and a place are needed: goniolux probe IMAGE x,y or x,y,radius");
  }
  const image::XyzImage image = image::readImage(request.inputs.front());
  const auto units = image.attributes.find(image::unitsAttribute);
  const bool relative = units != image.attributes.end() && units->second == "relative";
  StageReport report;
  Value::Array list;
  for (std::size_t i = 1; i < request.inputs.size(); ++i) {
    const Place place = placeFrom(request.inputs[i], image);
    const image::PatchReading reading = image::readPatch(image, place.column, place.row, place.radius);
    report.text += text(place, reading, relative ? "(relative)" : "cd/m2");
    list.push_back(toJson(place, reading));
  }
  if (relative) {
    report.warnings.warning({request.inputs.front(), 0, 0}, "relative-image",
                            "the file does not say how many cd/m2 its white has: luminances are relative");
  }
  report.json = list.front();
  report.json.set("image", request.inputs.front());
  if (const auto found = image.attributes.find(image::confidenceAttribute); found != image.attributes.end())
    report.json.set("confidence", found->second);
  if (list.size() > 1) report.json.set("points", std::move(list));
  return report;
}

}  // namespace

Stage probeStage() {
  Stage stage;
  stage.name = "probe";
  stage.title = "Read luminance and colour from an image";
  stage.help =
      "Reads one or more places of an image (OpenEXR, Radiance .hdr) as a luminance meter would: luminance, "
      "chromaticity, correlated colour temperature, each with its half-width, and the spectrum where the image stores "
      "it. The first argument is the image, each further one a place: x,y or x,y,radius in pixels from the top left.";
  stage.inputName = "IMAGE x,y[,radius]";
  stage.manyInputs = true;
  stage.run = run;
  return stage;
}

}  // namespace goniolux::pipeline
