#include "pipeline/image_form.h"

#include <fmt/format.h>

#include <filesystem>

#include "core/document.h"
#include "core/text.h"
#include "pipeline/text_option.h"

namespace goniolux::pipeline {

ImageForm imageFormFrom(const StageRequest& request, const std::string& path) {
  const std::string ending = core::lowerCase(std::filesystem::path(path).extension().string());
  const auto asked = request.options.find("form");
  const std::string form = asked != request.options.end() ? asked->second : "";
  ImageForm result;
  result.radiance = ending == ".hdr" || ending == ".pic";
  if (!result.radiance && ending != ".exr")
    throw core::InputError({path, 0, 0}, "image-format",
                           "images are OpenEXR or Radiance pictures; name it .exr or .hdr");
  if (form.empty()) return result;
  const bool fits =
      result.radiance ? form == "xyze" || form == "rgbe" : form == "float" || form == "half" || form == "paper";
  if (!fits)
    throw core::InputError({"--form", 0, 0}, "form",
                           result.radiance
                               ? fmt::format("'{}' is no form of a Radiance picture; give xyze or rgbe", form)
                               : fmt::format("'{}' is no form of an OpenEXR image; give float, half or paper", form));
  if (form == "rgbe") result.hdr = image::HdrForm::rgbe;
  if (form == "half") result.exr = image::ExrForm::half;
  if (form == "paper") result.exr = image::ExrForm::paper;
  return result;
}

core::Parameter imageFormOption() {
  return textOption(
      "form", "form of the image file", "",
      "float (32 bit, the standard), half (16 bit), paper (three 16-bit channels, run-length encoded) for .exr; "
      "xyze or rgbe for .hdr",
      false);
}

void writeImage(const std::string& path, const image::XyzImage& image, const ImageForm& form) {
  if (form.radiance)
    core::writeFile(path, image::encodeHdr(image, form.hdr));
  else
    image::writeExr(path, image, form.exr);
}

}  // namespace goniolux::pipeline
