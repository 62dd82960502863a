#include "photometry/flux_check.h"

#include <fmt/format.h>

#include <cmath>
#include <vector>

namespace goniolux::photometry {
namespace {

using core::degree;
using core::pi;

// The antiderivative of an angle's factor in the solid angle.
enum class Zone { gamma, latitude, uniform };
double antiderivative(Zone zone, double degrees) {
  switch (zone) {
    case Zone::gamma:
      return -std::cos(degrees * degree);
    case Zone::latitude:
      return std::sin(degrees * degree);
    case Zone::uniform:
      break;
  }
  return degrees * degree;
}

// Half of the zone on either side of each angle: a zone's intensity is the mean of its two bounding angles.
std::vector<double> zoneWeights(const std::vector<double>& degrees, Zone zone) {
  std::vector<double> weights(degrees.size(), 0.0);
  for (std::size_t i = 0; i + 1 < degrees.size(); ++i) {
    const double solidAngle = antiderivative(zone, degrees[i + 1]) - antiderivative(zone, degrees[i]);
    weights[i] += 0.5 * solidAngle;
    weights[i + 1] += 0.5 * solidAngle;
  }
  return weights;
}

bool differ(double a, double b) {
  return std::abs(a - b) > fluxAgreement * std::max(std::abs(a), std::abs(b));
}

}  // namespace

double zonalConstantFlux(const TabulatedDistribution& d) {
  const bool isB = d.type() == PhotometryType::b, isA = d.type() == PhotometryType::a;
  std::vector<double> horizontal = d.horizontalAngles();
  const std::size_t stated = horizontal.size();
  if (d.symmetry() == HorizontalSymmetry::none && !isA && !isB && horizontal.back() < 360 - 1e-6)
    horizontal.push_back(360);
  std::vector<double> weightsH = zoneWeights(horizontal, isB ? Zone::latitude : Zone::uniform);
  const std::vector<double> weightsV = zoneWeights(d.verticalAngles(), isB   ? Zone::uniform
                                                                       : isA ? Zone::latitude
                                                                             : Zone::gamma);
  if (d.symmetry() == HorizontalSymmetry::rotational) weightsH[0] = 2 * pi;
  double sum = 0;
  for (std::size_t h = 0; h < weightsH.size(); ++h) {
    for (std::size_t v = 0; v < weightsV.size(); ++v)
      sum += weightsH[h] * weightsV[v] * d.candela(h < stated ? h : 0, v);
  }
  return symmetryCopies(d.symmetry()) * sum;
}

void warnOfFluxes(PhotometricFile& file) {
  const double exact = file.distribution->flux();
  if (exact <= 0) return;
  const std::string& unit = file.fluxUnit;
  const core::SourcePosition whole{file.file, 0, 0};
  const double zonal = zonalConstantFlux(*file.distribution);
  if (differ(exact, zonal)) {
    file.warnings.warning(
        whole, "flux-zonal",
        fmt::format(
            "the exact flux of the interpolated table is {:.6g} {}, the zonal-constant sum {:.6g} {} ({:+.1f} %): the "
            "table is coarse for this distribution; the exact flux is what is used",
            exact, unit, zonal, unit, 100 * (zonal / exact - 1)));
  }
  if (file.declaredLuminaireLumens && differ(exact, *file.declaredLuminaireLumens)) {
    file.warnings.warning(
        whole, "flux-declared",
        fmt::format(
            "the file declares a luminaire flux of {:.6g} {}, its table gives {:.6g} {} ({:+.1f} %); the table is "
            "used: set 'flux' in the project to scale it",
            *file.declaredLuminaireLumens, unit, exact, unit, 100 * (exact / *file.declaredLuminaireLumens - 1)));
  }
  if (file.declaredLumens && exact > (1 + fluxAgreement) * *file.declaredLumens) {
    file.warnings.warning(
        whole, "flux-above-lamps",
        fmt::format(
            "the table gives {:.6g} {}, {:.0f} % of the declared lamp flux of {:.6g} lm; is the multiplier that of "
            "another lamp? The table is used as it is",
            exact, unit, 100 * exact / *file.declaredLumens, *file.declaredLumens));
  }
  constexpr double leastRatio = 0.2;  // of the lamps' light leaves even a poor luminaire
  if (file.declaredLumens && exact < leastRatio * *file.declaredLumens) {
    file.warnings.warning(
        whole, "flux-below-lamps",
        fmt::format(
            "the table gives {:.6g} {}, only {:.1f} % of the declared lamp flux of {:.6g} lm; are its values cd "
            "per 1000 lm? The table is used as it is",
            exact, unit, 100 * exact / *file.declaredLumens, *file.declaredLumens));
  }
}

}  // namespace goniolux::photometry
