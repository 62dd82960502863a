#include "photometry/comparison.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace goniolux::photometry {
namespace {

using core::degree;
using core::pi;

core::Vec3 direction(double c, double gamma) {
  return {std::sin(gamma * degree) * std::cos(c * degree), std::sin(gamma * degree) * std::sin(c * degree),
          std::cos(gamma * degree)};
}

// The gammas of a diagram: those of the table, or every degree where the table's angles are none (types A and B).
std::vector<double> gammasOf(const TabulatedDistribution& d) {
  if (d.type() == PhotometryType::c) return d.verticalAngles();
  std::vector<double> gammas;
  for (int gamma = 0; gamma <= 180; ++gamma) gammas.push_back(gamma);
  return gammas;
}

}  // namespace

DistributionDifference difference(const IntensityDistribution& a, const IntensityDistribution& b) {
  constexpr int rings = 180, sectors = 180;
  DistributionDifference result;
  double squares = 0;
  for (int i = 0; i < rings; ++i) {
    const double gamma = i + 0.5;
    const double solidAngle = 2 * pi / sectors * (std::cos(i * degree) - std::cos((i + 1) * degree));
    for (int j = 0; j < sectors; ++j) {
      const double c = (j + 0.5) * 360 / sectors;
      const core::Vec3 local = direction(c, gamma);
      const double apart = std::abs(a.intensity(local) - b.intensity(local));
      result.misplaced += 0.5 * apart * solidAngle;
      squares += apart * apart * solidAngle;
      if (apart <= result.largest) continue;
      result.largest = apart;
      result.c = c;
      result.gamma = gamma;
    }
  }
  result.rms = std::sqrt(squares / (4 * pi));
  return result;
}

double largestChange(const TabulatedDistribution& before, const TabulatedDistribution& after) {
  // Planes 0 and 360 are one direction but two columns of a table; they are compared as such where both tables have
  // both.
  const bool sameColumns =
      before.horizontalAngles() == after.horizontalAngles() && before.verticalAngles() == after.verticalAngles();
  double largest = 0;
  for (std::size_t h = 0; h < before.horizontalAngles().size(); ++h)
    for (std::size_t v = 0; v < before.verticalAngles().size(); ++v) {
      const double now =
          sameColumns ? after.candela(h, v) : after.atAngles(before.horizontalAngles()[h], before.verticalAngles()[v]);
      largest = std::max(largest, std::abs(now - before.candela(h, v)));
    }
  return largest;
}

TurnedDistribution::TurnedDistribution(std::shared_ptr<const IntensityDistribution> distribution, double degrees)
    : distribution_(std::move(distribution)), cosine_(std::cos(degrees * degree)), sine_(std::sin(degrees * degree)) {}

double TurnedDistribution::intensity(const core::Vec3& local) const {
  return distribution_->intensity({local.x * cosine_ + local.y * sine_, local.y * cosine_ - local.x * sine_, local.z});
}

std::shared_ptr<const TabulatedDistribution> oneDiagram(const TabulatedDistribution& d) {
  constexpr int planes = 360;
  const std::vector<double> gammas = gammasOf(d);
  std::vector<double> mean;
  for (const double gamma : gammas) {
    double sum = 0;
    for (int i = 0; i < planes; ++i) {
      const double c = (i + 0.5) * 360 / planes;
      sum += d.type() == PhotometryType::c ? d.atAngles(c, gamma) : d.intensity(direction(c, gamma));
    }
    mean.push_back(sum / planes);
  }
  return std::make_shared<const TabulatedDistribution>(PhotometryType::c, std::vector<double>{0}, gammas, mean);
}

std::shared_ptr<const TabulatedDistribution> twoDiagrams(const TabulatedDistribution& d) {
  const std::vector<double> gammas = gammasOf(d);
  std::vector<double> candelas;
  for (const double c : {0.0, 90.0})
    for (const double gamma : gammas) {
      const auto at = [&](double plane) {
        return d.type() == PhotometryType::c ? d.atAngles(plane, gamma) : d.intensity(direction(plane, gamma));
      };
      candelas.push_back(0.5 * (at(c) + at(c + 180)));
    }
  return std::make_shared<const TabulatedDistribution>(PhotometryType::c, std::vector<double>{0, 90}, gammas, candelas);
}

}  // namespace goniolux::photometry
