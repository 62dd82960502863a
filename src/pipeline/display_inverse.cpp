#include "pipeline/display_inverse.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "core/text.h"
#include "display/inverse.h"
#include "display/picture_file.h"
#include "image/exr.h"

namespace goniolux::pipeline {
namespace {

using core::Value;

bool isPicture(const std::string& path) {
  const std::string ending = core::lowerCase(std::filesystem::path(path).extension().string());
  return ending == ".png" || ending == ".tif" || ending == ".tiff" || ending == ".dpx" || ending == ".jpg" ||
         ending == ".jpeg";
}

Value three(double a, double b, double c) {
  return Value::arrayOf(std::vector<double>{a, b, c});
}

StageReport patches(const StageRequest& request, const display::Device& device) {
  const std::string& input = request.inputs.at(0);
  const auto asked = request.options.find("bits");
  const std::string bitsText = asked != request.options.end() ? asked->second : "8";
  if (bitsText != "8" && bitsText != "10" && bitsText != "16")
    throw core::InputError({"--bits", 0, 0}, "bits",
                           fmt::format("'{}' bits are not known; give 8, 10 or 16", bitsText));
  const int bits = std::stoi(bitsText);
  std::vector<display::Patch> list = display::readPatches(core::readFile(input), input, bits);
  display::predict(list, device, bits);

  StageReport report;
  const bool absolute = device.white_cd_m2 > 0;
  report.text =
      fmt::format("{}: X, Y, Z {} of {}-bit codes\n     R     G     B          X          Y          Z    dE00\n",
                  device.name, absolute ? "in cd/m2" : "(white: Y = 1)", bits);
  Value::Array rows;
  double sum = 0, largest = 0;
  std::size_t measured = 0;
  for (const display::Patch& patch : list) {
    const core::Vec3& p = patch.predicted;
    report.text += fmt::format("{:6g}{:6g}{:6g} {:10.4f} {:10.4f} {:10.4f}", patch.codes[0], patch.codes[1],
                               patch.codes[2], p.x, p.y, p.z);
    Value row;
    row.set("codes", three(patch.codes[0], patch.codes[1], patch.codes[2]));
    row.set("xyz", three(p.x, p.y, p.z));
    if (patch.delta) {
      row.set("measured", three(patch.measured->x, patch.measured->y, patch.measured->z));
      row.set("delta_e00", *patch.delta);
      report.text += fmt::format(" {:7.2f}", *patch.delta);
      sum += *patch.delta;
      largest = std::max(largest, *patch.delta);
      ++measured;
    }
    report.text += "\n";
    rows.push_back(std::move(row));
  }
  report.json.set("device", device.name);
  report.json.set("unit", absolute ? "cd/m2" : "relative");
  report.json.set("patches", std::move(rows));
  if (measured > 0) {
    const double mean = sum / static_cast<double>(measured);
    report.json.set("delta_e00_mean", mean);
    report.json.set("delta_e00_max", largest);
    report.text += fmt::format("  measured against predicted: dE00 mean {:.2f}, largest {:.2f}, over {} patches\n",
                               mean, largest, measured);
  }
  return report;
}

}  // namespace

StageReport inverseReport(const StageRequest& request, const display::Device& device) {
  const std::string& input = request.inputs.at(0);
  if (!isPicture(input)) return patches(request, device);
  const std::string output =
      request.common.output.value_or(std::filesystem::path(input).replace_extension(".exr").string());
  if (core::lowerCase(std::filesystem::path(output).extension().string()) != ".exr")
    throw core::InputError({output, 0, 0}, "inverse", "X, Y, Z of a picture are an OpenEXR image; name it .exr");
  const image::XyzImage light = display::lightOf(display::readPicture(input), device);
  image::writeExr(output, light);
  StageReport report;
  report.files = {output};
  report.json.set("picture", input);
  report.json.set("file", output);
  report.json.set("device", device.name);
  report.json.set("unit", light.attributes.at(image::unitsAttribute));
  report.text = fmt::format("{}: {} x {} pixels, the light of {}, {}\n", output, light.width, light.height, device.name,
                            light.attributes.at(image::unitsAttribute));
  return report;
}

}  // namespace goniolux::pipeline
