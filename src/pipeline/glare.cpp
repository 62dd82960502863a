// The stage `glare`: luminous sources of an image, UGR, and DGP as what it is.
#include <fmt/format.h>

#include <cmath>

#include "analysis/image_glare.h"
#include "core/text.h"
#include "image/image_file.h"
#include "pipeline/stages.h"
#include "pipeline/text_option.h"
#include "scene/view_text.h"

namespace goniolux::pipeline {
namespace {

using core::Value;

scene::View viewOf(const image::XyzImage& image, const std::string& path) {
  for (const char* name : {image::viewGeometryAttribute, image::viewAttribute}) {
    const auto found = image.attributes.find(name);
    if (found == image.attributes.end()) continue;
    const auto view = scene::viewFromText(found->second, image.width, image.height);
    if (!view)
      throw core::InputError({path, 0, 0}, "view",
                             fmt::format("the image's view '{}' is not understood", found->second));
    if (view->projection == scene::View::Projection::orthographic)
      throw core::InputError({path, 0, 0}, "view", "an orthographic image has no eye: render a fisheye");
    return *view;
  }
  throw core::InputError(
      {path, 0, 0}, "view",
      "the image does not say which view it shows; render it anew, or give a Radiance picture with a "
      "line VIEW=");
}

double thresholdFrom(const StageRequest& request, const image::XyzImage& image) {
  const auto given = request.options.find("threshold");
  const std::string text = given != request.options.end() ? given->second : "2000";
  const bool relative = text.ends_with('x');
  const auto value =
      core::parseNumber(relative ? std::string_view(text).substr(0, text.size() - 1) : std::string_view(text));
  if (!value || !(*value > 0) || !std::isfinite(*value))
    throw core::InputError({"--threshold", 0, 0}, "threshold",
                           fmt::format("'{}' is no threshold; give cd/m2, or 5x for five times the mean", text));
  if (!relative) return *value;
  double sum = 0;
  std::size_t count = 0;
  for (const float y : image.y)
    if (std::isfinite(y) && y > 0) sum += static_cast<double>(y), ++count;
  return *value * sum / static_cast<double>(std::max<std::size_t>(1, count));
}

StageReport run(const StageRequest& request, core::ProgressSink&) {
  const std::string& input = request.inputs.at(0);
  const image::XyzImage image = image::readImage(input);
  const scene::View view = viewOf(image, input);
  const analysis::ImageGlare glare = analysis::glareOf(image, view, thresholdFrom(request, image));
  // A hemisphere has 2 pi; its corners are outside a fisheye's circle.
  const bool whole = glare.solidAngle_sr > 0.98 * 2 * core::pi;

  StageReport report;
  Value& json = report.json;
  json.set("image", input);
  json.set("threshold_cd_m2", glare.threshold_cd_m2);
  json.set("vertical_illuminance_lx", glare.verticalIlluminance_lx);
  json.set("background_cd_m2", glare.background_cd_m2);
  json.set("solid_angle_sr", glare.solidAngle_sr);
  json.set("ugr", glare.sources.empty() ? Value() : Value(glare.ugr));
  json.set("dgp", glare.dgp);
  json.set("dgp_note", "fitted to observers in daylit offices; for electric light a number for comparison only");
  Value::Array sources;
  for (const analysis::ImageSource& source : glare.sources) {
    Value each;
    each.set("luminance_cd_m2", source.luminance_cd_m2);
    each.set("solid_angle_sr", source.solidAngle_sr);
    each.set("position_index", source.positionIndex);
    each.set("pixel",
             Value::arrayOf(std::vector<double>{static_cast<double>(source.column), static_cast<double>(source.row)}));
    each.set("pixels", static_cast<std::uint64_t>(source.pixels));
    sources.push_back(std::move(each));
  }
  json.set("sources", std::move(sources));

  report.text = fmt::format("{}: {} sources above {:.4g} cd/m2\n", input, glare.sources.size(), glare.threshold_cd_m2);
  for (std::size_t i = 0; i < glare.sources.size() && i < 12; ++i) {
    const analysis::ImageSource& s = glare.sources[i];
    report.text += fmt::format("  at ({:4}, {:4})  {:9.4g} cd/m2  {:8.3g} sr  position index {:.2f}\n", s.column, s.row,
                               s.luminance_cd_m2, s.solidAngle_sr, s.positionIndex);
  }
  report.text += fmt::format("  illuminance at the eye {:.4g} lx, background {:.4g} cd/m2\n",
                             glare.verticalIlluminance_lx, glare.background_cd_m2);
  report.text += glare.sources.empty() ? "  UGR  none: no source\n" : fmt::format("  UGR  {:.1f}\n", glare.ugr);
  report.text +=
      fmt::format("  DGP  {:.3f} (fitted to daylit offices; for electric light for comparison only)\n", glare.dgp);
  if (!whole) {
    report.warnings.warning(
        {input, 0, 0}, "part-of-field",
        fmt::format("the image sees {:.0f} % of the hemisphere: illuminance, background and the glare "
                    "figures are those of that part; render a fisheye of 180 degrees",
                    100 * glare.solidAngle_sr / (2 * core::pi)));
  }
  return report;
}

}  // namespace

Stage glareStage() {
  Stage stage;
  stage.name = "glare";
  stage.title = "Find luminous sources in an image and rate their glare";
  stage.help =
      "Reads an image that says its view (OpenEXR as 'render' writes it, Radiance .hdr with VIEW=), best a fisheye of "
      "180 "
      "degrees, and finds what is brighter than the threshold: luminance, solid angle, position index; UGR (CIE 117), "
      "and "
      "the daylight glare probability DGP, which was fitted to daylit offices.";
  stage.inputName = "IMAGE";
  stage.options = {
      textOption("threshold", "what is a source", "2000", "cd/m2, or 5x: times the mean luminance", false)};
  stage.run = run;
  return stage;
}

}  // namespace goniolux::pipeline
