// The pixel loop: an image of a view, each pixel sampled until its luminance is known to the accuracy asked for.
//
// Every pixel is 16 independent replicates of scrambled points over the filter's area and its light paths
// (pixel_samples.h). All start with the same few samples, which foretell how many each pixel needs, up to the limit,
// - for its neighbourhood to be known well enough: a growing part of that, until 95 % of the pixels are within the
//   accuracy asked for;
// - where the samples' contrast stands out from the surroundings, so at the edges of luminaires and other things, until
//   what the pixel may be off is no visible contrast.
// Decisions fall between passes, for each half of a pixel's replicates from the other half's first samples.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "core/kept_work.h"
#include "core/progress.h"
#include "image/xyz_image.h"
#include "scene/view.h"
#include "solver/solver.h"
#include "viewing/pixel_filter.h"

namespace goniolux::viewing {

struct PixelAccuracy {
  double relative = 0.05;  ///< of the luminance of 95 % of the pixels
  double confidence = 0.95;
  double absoluteFloor = 0.01;  ///< cd/m2
  int mostSamples = 256;        ///< per pixel
  int fewestSamples = 1;        ///< per pixel; at least one a replicate are taken
  /// Where the samples' contrast stands out, pixels are divided until their half-width is a contrast below this,
  /// (Lmax - Lmin)/(Lmax + Lmin); 1: nowhere.
  double contrast = 0.02;
  const PixelFilter* filter = nullptr;  ///< nothing: box
  bool parts = false;                   ///< direct and indirect light as layers too; the solver must part them
};

struct ImageEstimate {
  image::XyzImage image;                      ///< with half-widths
  std::vector<float> halfWidthX, halfWidthZ;  ///< statistical, as image.halfWidth is of Y
  double shareWithin = 0;
  double missed = 0;  ///< bound of what a light solution misses, of the mean luminance; in the half-widths
  bool reached = false;
  std::uint64_t samples = 0;
};

/// Sees the whole picture as it is known after each pass; called from the calling thread.
using ImageObserver = std::function<void(const ImageEstimate&)>;

/// Renders the view. `worldOrigin`: scene::World::origin. `secondsLeft`: wall clock, checked between passes.
/// Finished work goes to `keeping`, and what is there is not done anew.
ImageEstimate renderView(const solver::Solver& solver, const scene::View& view, const core::Vec3& worldOrigin,
                         std::uint64_t key, const PixelAccuracy& accuracy, double secondsLeft,
                         core::ProgressSink& progress, const ImageObserver& partial = {},
                         const core::Keeping& keeping = {});

}  // namespace goniolux::viewing
