#include "viewing/pixel_filter.h"

#include <algorithm>
#include <cmath>

namespace goniolux::viewing {
namespace {

constexpr std::size_t cells = 4096;  // of a profile's table

double box(double) {
  return 1;
}

double tent(double x) {
  return std::max(0.0, 1 - std::abs(x));
}

// Standard deviation 0.5 pixels, let down to 0 at 1.5 pixels.
double gaussian(double x) {
  constexpr double inverse = 1 / (2 * 0.5 * 0.5);
  return std::max(0.0, std::exp(-x * x * inverse) - std::exp(-1.5 * 1.5 * inverse));
}

// B = C = 1/3, the authors' choice [mitchell88].
double mitchell(double x) {
  constexpr double B = 1.0 / 3, C = 1.0 / 3;
  const double a = std::abs(x);
  if (a < 1) return ((12 - 9 * B - 6 * C) * a * a * a + (-18 + 12 * B + 6 * C) * a * a + (6 - 2 * B)) / 6;
  if (a < 2) return ((-B - 6 * C) * a * a * a + (6 * B + 30 * C) * a * a + (-12 * B - 48 * C) * a + 8 * B + 24 * C) / 6;
  return 0;
}

}  // namespace

const std::vector<PixelFilter>& pixelFilters() {
  static const std::vector<PixelFilter> list{
      {"box", "the pixel's own square, as a luminance meter measures", "", 0.5, box},
      {"tent", "falls off evenly over one pixel", "", 1, tent},
      {"gaussian", "smooth, standard deviation half a pixel, to 1.5 pixels", "", 1.5, gaussian},
      {"mitchell", "crisp, rings by some per cent beside bright edges (values below 0 there), to 2 pixels",
       "Mitchell and Netravali, SIGGRAPH 1988", 2, mitchell},
  };
  return list;
}

const PixelFilter* findPixelFilter(const std::string& name) {
  for (const PixelFilter& filter : pixelFilters())
    if (filter.name == name) return &filter;
  return nullptr;
}

FilterPlaces::FilterPlaces(const PixelFilter& filter) : radius_(filter.radius), isBox_(filter.profile == box) {
  for (Part* part : {&above_, &below_}) {
    const double sign = part == &above_ ? 1 : -1;
    part->cumulative.push_back(0);
    for (std::size_t i = 0; i < cells; ++i) {
      const double x = radius_ * (2 * (static_cast<double>(i) + 0.5) / cells - 1);
      part->cumulative.push_back(part->cumulative.back() + std::max(0.0, sign * filter.profile(x)));
    }
    part->integral = part->cumulative.back();
    for (double& each : part->cumulative) each /= std::max(part->integral, 1e-300);
  }
  // f = (p - n)(p - n) over both axes, with integrals P and N: positive is pp + nn, negative pn + np.
  const double P = above_.integral / (above_.integral - below_.integral), N = P - 1;
  gain_ = P * P + N * N;
  bothNegative_ = N * N / gain_;
}

double FilterPlaces::place(const Part& part, double u) const {
  const auto after = std::upper_bound(part.cumulative.begin() + 1, part.cumulative.end() - 1, u);
  const double high = *after, low = *(after - 1);
  const double within = high > low ? std::clamp((u - low) / (high - low), 0.0, 1.0) : 0.5;
  const double cell = static_cast<double>(after - 1 - part.cumulative.begin());
  return radius_ * (2 * (cell + within) / cells - 1);
}

core::Vec2 FilterPlaces::positive(core::Vec2 u) const {
  if (isBox_) return u - 0.5;
  if (u.x < bothNegative_) return {place(below_, u.x / bothNegative_), place(below_, u.y)};
  return {place(above_, (u.x - bothNegative_) / (1 - bothNegative_)), place(above_, u.y)};
}

core::Vec2 FilterPlaces::negative(core::Vec2 u) const {
  if (u.x < 0.5) return {place(above_, 2 * u.x), place(below_, u.y)};
  return {place(below_, 2 * u.x - 1), place(above_, u.y)};
}

}  // namespace goniolux::viewing
