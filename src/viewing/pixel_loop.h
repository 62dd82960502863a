// The pixel loop: an image of a view, each pixel sampled until its luminance is known to the accuracy asked for.
//
// Every pixel is 16 independent replicates of scrambled points over its area and its light paths. All start with the
// same few samples; then those pixels whose neighbourhood is not yet known well enough double theirs, up to the limit,
// until 95 % of the pixels are within the accuracy asked for. Decisions fall between passes, from spreads pooled over 3
// x 3 pixels.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "core/progress.h"
#include "image/xyz_image.h"
#include "scene/view.h"
#include "solver/solver.h"

namespace goniolux::viewing {

struct PixelAccuracy {
  double relative = 0.05;  ///< of the luminance of 95 % of the pixels
  double confidence = 0.95;
  double absoluteFloor = 0.01;  ///< cd/m2
  int mostSamples = 256;        ///< per pixel
};

struct ImageEstimate {
  image::XyzImage image;  ///< with half-widths
  double shareWithin = 0;
  double missed = 0;  ///< bound of what a light solution misses, of the mean luminance; in the half-widths
  bool reached = false;
  std::uint64_t samples = 0;
};

/// Sees the whole picture as it is known after each pass; called from the calling thread.
using ImageObserver = std::function<void(const ImageEstimate&)>;

/// Renders the view. `worldOrigin`: scene::World::origin. `secondsLeft`: wall clock, checked between passes.
ImageEstimate renderView(const solver::Solver& solver, const scene::View& view, const core::Vec3& worldOrigin,
                         std::uint64_t key, const PixelAccuracy& accuracy, double secondsLeft,
                         core::ProgressSink& progress, const ImageObserver& partial = {});

}  // namespace goniolux::viewing
