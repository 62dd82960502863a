// The stage `mix`: images of luminaire groups added up with levels, without tracing anything; also the way to other
// forms of image files.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <filesystem>

#include "core/text.h"
#include "image/image_file.h"
#include "image/mix.h"
#include "pipeline/image_form.h"
#include "pipeline/stages.h"

namespace goniolux::pipeline {
namespace {

struct Input {
  std::string path;
  double level = 1;
  std::string layer;  // of the file; none: the whole image
  [[nodiscard]] std::string name() const { return layer.empty() ? path : path + ':' + layer; }
};

// "FILE", "FILE:LAYER"; a file whose name holds ':' is a file.
Input fileFrom(const std::string& text, double level) {
  const std::size_t colon = text.rfind(':');
  if (colon == std::string::npos || std::filesystem::exists(text)) return {text, level, ""};
  return {text.substr(0, colon), level, text.substr(colon + 1)};
}

// The same with "=LEVEL"; a file whose name holds '=' is a file.
Input inputFrom(const std::string& text) {
  const std::size_t sign = text.rfind('=');
  if (sign == std::string::npos || std::filesystem::exists(text)) return fileFrom(text, 1);
  const auto level = core::parseNumber(text.substr(sign + 1));
  if (!level || !(*level >= 0) || !std::isfinite(*level))
    throw core::InputError({text, 0, 0}, "level",
                           fmt::format("'{}' is no level; give a number from 0, such as {}=0.5", text.substr(sign + 1),
                                       text.substr(0, sign)));
  return fileFrom(text.substr(0, sign), *level);
}

image::XyzImage read(const Input& input) {
  image::XyzImage whole = image::readImage(input.path);
  if (input.layer.empty()) return whole;
  if (auto layer = image::layerOf(whole, input.layer)) return std::move(*layer);
  std::vector<std::string> names;
  for (const image::Layer& each : whole.layers) names.push_back(each.name);
  throw core::InputError(
      {input.path, 0, 0}, "layer",
      names.empty()
          ? fmt::format("the image has no layers, so none called '{}'; 'render --parts' makes them", input.layer)
          : fmt::format("the image has no layer '{}'; it has {}", input.layer, fmt::join(names, ", ")));
}

StageReport run(const StageRequest& request, core::ProgressSink&) {
  if (!request.common.output)
    throw core::InputError({"mix", 0, 0}, "usage", "name the image to write: -o NAME.exr or -o NAME.hdr");
  const ImageForm form = imageFormFrom(request, *request.common.output);
  std::vector<Input> inputs;
  std::vector<image::XyzImage> images;
  for (const std::string& text : request.inputs) {
    inputs.push_back(inputFrom(text));
    images.push_back(read(inputs.back()));
    if (images.back().width != images.front().width || images.back().height != images.front().height)
      throw core::InputError({inputs.back().path, 0, 0}, "image-size",
                             fmt::format("the images differ in size: {} x {} and {} x {} pixels", images.front().width,
                                         images.front().height, images.back().width, images.back().height));
  }
  std::vector<image::MixPart> parts;
  for (std::size_t i = 0; i < images.size(); ++i) parts.push_back({&images[i], inputs[i].level});
  image::XyzImage sum = image::mixed(parts);
  std::string recipe;
  for (const Input& input : inputs)
    recipe += fmt::format("{}{:g} {}", recipe.empty() ? "" : " + ", input.level, input.name());
  if (inputs.size() > 1 || inputs[0].level != 1 || !inputs[0].layer.empty()) sum.attributes["mixedFrom"] = recipe;
  writeImage(*request.common.output, sum, form);
  StageReport report;
  report.files = {*request.common.output};
  report.json.set("file", *request.common.output);
  report.json.set("mixed_from", recipe);
  report.text = fmt::format("{}: {} x {} pixels, {}\n", *request.common.output, sum.width, sum.height, recipe);
  return report;
}

}  // namespace

Stage mixStage() {
  Stage stage;
  stage.name = "mix";
  stage.title = "Add up images of luminaire groups, or write an image in another form";
  stage.help =
      "Light adds up: layers/GROUP/NAME.exr of 'render --layers', each with a level (FILE=0.5), give the image of any "
      "dimming, or of lamps of another flux, without tracing. FILE:LAYER takes one layer of a file: of 'render "
      "--parts' "
      "FILE:direct and FILE:indirect. Half-widths are carried along. Also a single image: -o NAME.hdr writes a "
      "Radiance "
      "picture, --form half or paper a smaller OpenEXR file.";
  stage.inputName = "IMAGE[:LAYER][=LEVEL]";
  stage.manyInputs = true;
  stage.options = {imageFormOption()};
  stage.run = run;
  return stage;
}

}  // namespace goniolux::pipeline
