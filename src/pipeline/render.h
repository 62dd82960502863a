// Render: a view of a project to an XYZ image in cd/m2 (the paper's fourth step, the intensity function at the image
// plane).
#pragma once

#include <map>
#include <optional>

#include "core/estimate.h"
#include "core/kept_work.h"
#include "image/exr.h"
#include "pipeline/engine.h"
#include "pipeline/render_spectrum.h"
#include "viewing/pixel_loop.h"

namespace goniolux::pipeline {

struct RenderedView {
  std::string name, file;
  bool reached = false;
  double shareWithin = 0, wallTime_s = 0, cpuTime_s = 0;
  double missed = 0;  ///< viewing::ImageEstimate::missed
  std::uint64_t rays = 0, samples = 0;
  int width = 0, height = 0;
  core::Estimate luminance;                   ///< mean of the picture, cd/m2
  double least = 0, most = 0;                 ///< of its pixels
  std::map<int, core::Estimate> percentiles;  ///< by percent: that share of the pixels has no more
};

struct RenderOptions {
  image::ExrForm form = image::ExrForm::float32;
  std::optional<SpectralRange> channels;          ///< spectral channels beside X, Y, Z
  bool parts = false;                             ///< direct and indirect light as layers
  std::map<std::string, std::string> attributes;  ///< further ones of the image
  core::Keeping keeping;                          ///< where finished work is kept
};

/// What a project asks of its pictures.
viewing::PixelAccuracy pixelAccuracyOf(const project::Settings& settings);

/// Renders one view and writes NAME.exr into the folder. `partial` sees the picture as it grows, its attributes set.
RenderedView renderToFile(const project::Project& project, const Engine& engine, const scene::View& view,
                          const std::string& folder, double secondsLeft, core::ProgressSink& progress,
                          const viewing::ImageObserver& partial = {}, const RenderOptions& options = {});
/// The name of a view's image.
std::string imageFileName(const scene::View& view);
core::Value toJson(const RenderedView& view, const Engine& engine);
std::string renderText(const RenderedView& view, const project::Project& project);

}  // namespace goniolux::pipeline
