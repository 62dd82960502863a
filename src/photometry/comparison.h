// How far two distributions are apart, and the paper's own model of a luminaire (one or two goniometric diagrams)
// beside the full table.
#pragma once

#include <memory>

#include "photometry/intensity_distribution.h"

namespace goniolux::photometry {

/// By quadrature over directions with panels of 1 degree of gamma by 2 of C.
struct DistributionDifference {
  double misplaced = 0;     ///< half the integral of |a - b|, lm: what would have to move (with equal fluxes)
  double rms = 0;           ///< cd, over the sphere
  double largest = 0;       ///< cd, the largest |a - b| met
  double c = 0, gamma = 0;  ///< where, degrees
};
DistributionDifference difference(const IntensityDistribution& a, const IntensityDistribution& b);

/// The largest change of a stated candela, cd: `after` at the angles of `before`.
double largestChange(const TabulatedDistribution& before, const TabulatedDistribution& after);

/// `distribution` turned about its aim: what is at C there is at C + `degrees` here.
class TurnedDistribution final : public IntensityDistribution {
 public:
  TurnedDistribution(std::shared_ptr<const IntensityDistribution> distribution, double degrees);
  [[nodiscard]] double intensity(const core::Vec3& local) const override;
  [[nodiscard]] double flux() const override { return distribution_->flux(); }
  [[nodiscard]] double forwardFlux() const override { return distribution_->forwardFlux(); }
  [[nodiscard]] double maximumIntensity() const override { return distribution_->maximumIntensity(); }

 private:
  std::shared_ptr<const IntensityDistribution> distribution_;
  double cosine_, sine_;
};

/// The paper's model with one diagram: the mean over C, a distribution of revolution ([hall83], goniometric diagrams).
std::shared_ptr<const TabulatedDistribution> oneDiagram(const TabulatedDistribution& distribution);
/// With two: the means of C0 with C180 and of C90 with C270, joined linearly in the angle C between.
std::shared_ptr<const TabulatedDistribution> twoDiagrams(const TabulatedDistribution& distribution);

}  // namespace goniolux::photometry
