// PixelFilter: over which part of the image plane, and with which weight, a pixel's value is the mean of the luminance
// there. By name; the registry is in pixel_filter.cpp.
//
// `box`, the standard, is the pixel's own square: its value is what a luminance meter with that field would read. Wider
// filters draw smoother edges and are means over neighbouring pixels' places too.
#pragma once

#include <string>
#include <vector>

#include "core/vector.h"

namespace goniolux::viewing {

struct PixelFilter {
  std::string name, title, source;
  double radius;                ///< pixels; 0 beyond, on either axis
  double (*profile)(double x);  ///< weight at x pixels from the pixel's centre, on one axis; the filter is separable
};

const std::vector<PixelFilter>& pixelFilters();
/// Nothing where there is none of this name.
const PixelFilter* findPixelFilter(const std::string& name);

/// Places on the image plane, distributed as the filter's weights, so that the plain mean of what is seen there is the
/// pixel's value. A filter with negative lobes is the difference of two such means: `gain` times the one over its
/// positive part less (gain - 1) times the one over its negative part, exact where the picture is even. Thread-safe.
class FilterPlaces {
 public:
  explicit FilterPlaces(const PixelFilter& filter);

  [[nodiscard]] double gain() const { return gain_; }
  [[nodiscard]] bool hasLobes() const { return gain_ > 1; }
  /// Offset from the pixel's centre, pixels; `u` uniform in the unit square.
  [[nodiscard]] core::Vec2 positive(core::Vec2 u) const;
  [[nodiscard]] core::Vec2 negative(core::Vec2 u) const;

 private:
  /// One sign of the profile: its integral, and places by the share of it that lies below them.
  struct Part {
    double integral = 0;
    std::vector<double> cumulative;
  };
  [[nodiscard]] double place(const Part& part, double u) const;

  double radius_ = 0.5, gain_ = 1, bothNegative_ = 0;  // bothNegative_: share of the positive part
  bool isBox_ = true;
  Part above_, below_;
};

}  // namespace goniolux::viewing
