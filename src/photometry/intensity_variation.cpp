// How the interpolated table changes within an angle of a direction: bounds from the slopes of the cells that are
// reached. A source that is seen under a small angle may be one point as far as these are small (emitter/far_field.h).
#include <algorithm>
#include <cmath>

#include "photometry/intensity_distribution.h"

namespace goniolux::photometry {
namespace {

// Beyond this multiple of the angle from a pole the planes are as good as parallel there.
constexpr double polarAngles = 2;

/// The least and the largest of slopes, cd per radian.
struct Slopes {
  double least = 0, most = 0;
  bool any = false;
  void add(double slope) {
    least = any ? std::min(least, slope) : slope;
    most = any ? std::max(most, slope) : slope;
    any = true;
  }
  [[nodiscard]] double steepest() const { return std::max(std::abs(least), std::abs(most)); }
};

}  // namespace

std::optional<IntensityVariation> TabulatedDistribution::variation(const core::Vec3& local, double angle) const {
  if (type_ != PhotometryType::c) return std::nullopt;
  const std::vector<double>&gammas = vertical_.degrees(), &planes = horizontal_.degrees();
  const double gamma = std::acos(std::clamp(local.z, -1.0, 1.0)), sine = std::sin(gamma);
  const double low = (gamma - angle) / core::degree, high = (gamma + angle) / core::degree;
  // The table's end is a step, unless it is a pole.
  if ((low < vertical_.first() && vertical_.first() > 0) || (high > vertical_.last() && vertical_.last() < 180))
    return std::nullopt;
  const std::size_t v0 = std::min(vertical_.find(low).index, gammas.size() - 2),
                    v1 = std::min(vertical_.find(high).index, gammas.size() - 2);
  const bool polar = sine < polarAngles * std::sin(angle), rotational = symmetry_ == HorizontalSymmetry::rotational;
  std::size_t h0 = 0, h1 = rotational ? 0 : planes.size() - 2;
  double across = core::pi;
  bool mirrored = !rotational;
  if (!polar && !rotational) {
    across = std::asin(std::sin(angle) / sine);
    const double c = fold(std::atan2(local.y, local.x) / core::degree);
    const double from = c - across / core::degree, to = c + across / core::degree;
    if (from >= horizontal_.first() && to <= horizontal_.last()) {
      h0 = horizontal_.find(from).index;
      h1 = horizontal_.find(to).index;
      mirrored = false;
    }  // else the mirror plane or the seam is reached: all planes are looked at, and their mirror images
  }
  const auto at = [&](std::size_t h, std::size_t v) { return candelas_[h * gammas.size() + v]; };
  Slopes down, around;
  const std::size_t lastPlane = rotational ? 0 : h1 + 1;
  for (std::size_t h = h0; h <= lastPlane; ++h)
    for (std::size_t v = v0; v <= v1; ++v)
      down.add((at(h, v + 1) - at(h, v)) / ((gammas[v + 1] - gammas[v]) * core::degree));
  for (std::size_t h = h0; h < lastPlane; ++h)
    for (std::size_t v = v0; v <= v1 + 1; ++v) {
      const double slope = (at(h + 1, v) - at(h, v)) / ((planes[h + 1] - planes[h]) * core::degree);
      around.add(slope);
      if (mirrored) around.add(-slope);
    }
  IntensityVariation result;
  if (polar) {
    // Through the pole, where all planes meet in one value: as steep down as up.
    const std::size_t pole = local.z > 0 ? 0 : gammas.size() - 1;
    for (std::size_t h = h0; h <= lastPlane; ++h)
      if (at(h, pole) != at(0, pole)) return std::nullopt;
    const double fromPole = local.z > 0 ? gamma : core::pi - gamma;
    result.first = result.even = down.steepest() * (2 * fromPole + angle);
    return result;
  }
  result.first = down.steepest() * angle + around.steepest() * across;
  // Slopes that differ between the two sides, and circles about the pole that are no straight lines.
  const double nearest = std::max(sine - std::sin(angle), 0.5 * sine);
  result.even = 0.5 * (down.most - down.least) * angle + 0.5 * (around.most - around.least) * across +
                0.5 * down.steepest() * angle * angle / nearest +
                around.steepest() * angle * angle / (nearest * nearest);
  return result;
}

}  // namespace goniolux::photometry
