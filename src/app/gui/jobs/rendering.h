// Rendering: a view of the open project as work for a job, and pictures of its image for a display.
#pragma once

#include <QImage>
#include <functional>
#include <memory>
#include <string>

#include "app/gui/jobs/calculations.h"
#include "image/xyz_image.h"

namespace goniolux::gui {

struct RenderOutcome {
  std::shared_ptr<const image::XyzImage> image;
  std::string view, file;  ///< file: of the finished image
  double shareWithin = 0;  ///< of the pixels, within the accuracy asked for
  double accuracy = 0.05;
  bool isFinal = false;
};

/// The option --channels of `goniolux render` for pictures with spectra.
inline constexpr const char* spectralChannels = "400:700:20";

/// Renders a view into folder/NAME.exr, with spectra where they are wanted; `deliver` gets the picture as it grows.
Job::Work renderWork(Source source, std::string view, std::string folder, bool withSpectra,
                     std::function<void(RenderOutcome)> deliver);

/// How an image is shown.
struct DisplayChoice {
  std::string device = "srgb";
  std::string mapping = "linear";  ///< a name of display::mappingTypes()
  double stops = 0;                ///< brighter or darker than the automatic exposure
  bool adapts = true;              ///< the scene's white becomes the device's
};

struct ShownImage {
  QImage picture;
  std::size_t tooBright = 0, outOfGamut = 0;  ///< pixels
  double white_cd_m2 = 0;
  QString method;   ///< what the luminance mapping did
  QString failure;  ///< why there is no picture
};

/// The mapping as `goniolux display --mapping` is told: the stops belong to "linear".
std::string mappingText(const DisplayChoice& choice);

/// Runs on a drawing thread.
std::shared_ptr<const ShownImage> shownImage(const image::XyzImage& image, const DisplayChoice& choice);

}  // namespace goniolux::gui
