// The form in which an image file is written: its ending and the option --form.
#pragma once

#include <string>

#include "image/exr.h"
#include "image/hdr.h"
#include "pipeline/stage.h"

namespace goniolux::pipeline {

struct ImageForm {
  bool radiance = false;  ///< .hdr, else OpenEXR
  image::ExrForm exr = image::ExrForm::float32;
  image::HdrForm hdr = image::HdrForm::xyze;
};

/// --form: float, half or paper for .exr; xyze or rgbe for .hdr. core::InputError for what does not go together.
ImageForm imageFormFrom(const StageRequest& request, const std::string& path);
core::Parameter imageFormOption();
void writeImage(const std::string& path, const image::XyzImage& image, const ImageForm& form);

}  // namespace goniolux::pipeline
