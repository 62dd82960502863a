// Unified glare rating of an observer (CIE 117:1995), with its interval.
//
//   UGR = 8 log10( 0.25 / L_b * sum over luminaires of L^2 omega / p^2 )
//
// L: mean luminance of a luminaire's luminous part as far as the eye sees it, omega: its solid angle, p: Guth's
// position index within the field of CIE 117's table (position_index.h); L_b: the indirect vertical illuminance at the
// eye over pi, the background. Luminous parts that look smaller than 0.005 m2 count as 0.005 m2 (small sources of CIE
// 147:2002); lights seen in mirrors belong to the background. docs/methods/glare.md.
#pragma once

#include <cstdint>
#include <vector>

#include "analysis/grid.h"
#include "core/estimate.h"
#include "core/kept_work.h"
#include "core/progress.h"
#include "solver/seen_lights.h"

namespace goniolux::analysis {

/// A luminaire that an observer sees, as the rating counts it.
struct SeenGlare {
  std::uint32_t source = 0;  ///< index into World::emitters
  double luminance = 0;      ///< cd/m2, mean of the luminous part
  double solidAngle = 0;     ///< sr
  double positionIndex = 1;
  double share = 0;  ///< of the sum
};

struct GlareEstimate {
  core::Estimate ugr;              ///< 0 without any glare source; NaN without any background
  core::Estimate background;       ///< cd/m2
  std::vector<SeenGlare> sources;  ///< by share, the largest first
  bool reached = false;
  /// Sources outside 0.0003 to 0.1 sr, for which CIE 117 does not vouch.
  std::size_t tooSmall = 0, tooLarge = 0;
};

/// `eye` in the world frame. Goes on until the half-width of UGR at `confidence` is at most `accuracy`, or until
/// `secondsLeft` are used up. Finished work goes to `keeping`, and what is there is not done anew.
GlareEstimate estimateGlare(const solver::Solver& solver, const solver::SeenLights& lights, const core::Vec3& eye,
                            const core::Vec3& direction, std::uint64_t key, double accuracy, double confidence,
                            double secondsLeft, const core::ProgressSink& progress, const core::Keeping& keeping = {});

}  // namespace goniolux::analysis
