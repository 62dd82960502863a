#include "photometry/metrics.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace goniolux::photometry {
namespace {

using core::degree;
using core::pi;

core::Vec3 direction(double c, double gamma) {
  return {std::sin(gamma * degree) * std::cos(c * degree), std::sin(gamma * degree) * std::sin(c * degree),
          std::cos(gamma * degree)};
}

// Midpoint rule on cells of at most half a degree of gamma by one of C: for types A and B, whose cells lie across the
// zones.
double quadratureZone(const TabulatedDistribution& d, double from, double to) {
  const int rings = std::max(1, static_cast<int>(std::ceil((to - from) / 0.5)));
  constexpr int sectors = 360;
  const double dGamma = (to - from) / rings;
  double sum = 0;
  for (int i = 0; i < rings; ++i) {
    const double low = from + i * dGamma,
                 solidAngle = 2 * pi / sectors * (std::cos(low * degree) - std::cos((low + dGamma) * degree));
    for (int j = 0; j < sectors; ++j) sum += solidAngle * d.intensity(direction(j + 0.5, low + 0.5 * dGamma));
  }
  return sum;
}

// Intensities along a full plane; theta runs from -180 to 180, positive on the side of C.
struct Profile {
  std::vector<double> theta, intensity;
};

Profile profileOf(const TabulatedDistribution& d, PrincipalPlane plane) {
  const double c = plane == PrincipalPlane::c0_180 ? 0 : 90;
  std::vector<double> gammas{0, 90, 180};
  if (d.type() == PhotometryType::c) {
    gammas.insert(gammas.end(), d.verticalAngles().begin(), d.verticalAngles().end());
    // Where the table begins or ends, the intensity drops to 0 at once.
    constexpr double justOutside = 1e-6;
    gammas.push_back(std::max(0.0, d.verticalAngles().front() - justOutside));
    gammas.push_back(std::min(180.0, d.verticalAngles().back() + justOutside));
  } else {
    constexpr double step = 0.1;
    for (int i = 1; i < 1800; ++i) gammas.push_back(i * step);
  }
  std::sort(gammas.begin(), gammas.end());
  gammas.erase(std::unique(gammas.begin(), gammas.end()), gammas.end());
  const auto value = [&](double side, double gamma) {
    return d.type() == PhotometryType::c ? d.atAngles(side, gamma) : d.intensity(direction(side, gamma));
  };
  Profile profile;
  for (std::size_t i = gammas.size(); i-- > 1;) {
    profile.theta.push_back(-gammas[i]);
    profile.intensity.push_back(value(c + 180, gammas[i]));
  }
  for (const double gamma : gammas) {
    profile.theta.push_back(gamma);
    profile.intensity.push_back(value(c, gamma));
  }
  return profile;
}

// Theta counted from the other pole, so that light which goes up is measured as light that goes down is.
Profile turnedOver(const Profile& p) {
  Profile result;
  const std::size_t middle = p.theta.size() / 2;  // theta = 0
  for (std::size_t i = middle; i < p.theta.size(); ++i) {
    result.theta.push_back(p.theta[i] - 180);
    result.intensity.push_back(p.intensity[i]);
  }
  for (std::size_t i = 1; i <= middle; ++i) {
    result.theta.push_back(p.theta[i] + 180);
    result.intensity.push_back(p.intensity[i]);
  }
  return result;
}

// Where the straight line between points i and i + 1 has the given level.
double crossing(const Profile& p, std::size_t i, double level) {
  const double a = p.intensity[i], b = p.intensity[i + 1];
  return p.theta[i] + (p.theta[i + 1] - p.theta[i]) * (level - a) / (b - a);
}

}  // namespace

double zoneFlux(const TabulatedDistribution& distribution, double from, double to) {
  return distribution.type() == PhotometryType::c ? distribution.verticalBandFlux(from, to)
                                                  : quadratureZone(distribution, from, to);
}

std::array<double, 18> zonalLumens(const TabulatedDistribution& distribution) {
  std::array<double, 18> zones{};
  for (std::size_t i = 0; i < zones.size(); ++i)
    zones[i] = zoneFlux(distribution, 10.0 * double(i), 10.0 * double(i + 1));
  return zones;
}

IntensityPeak intensityPeak(const TabulatedDistribution& d) {
  IntensityPeak peak{-1, 0, 0};
  for (std::size_t h = 0; h < d.horizontalAngles().size(); ++h) {
    for (std::size_t v = 0; v < d.verticalAngles().size(); ++v) {
      if (d.candela(h, v) <= peak.intensity_cd) continue;
      peak = {d.candela(h, v), d.horizontalAngles()[h], d.verticalAngles()[v]};
    }
  }
  if (d.type() == PhotometryType::c) return peak;
  const double h = peak.c * degree, v = peak.gamma * degree;  // see PhotometryType
  const core::Vec3 local = d.type() == PhotometryType::b
                               ? core::Vec3(std::sin(h), std::sin(v) * std::cos(h), std::cos(v) * std::cos(h))
                               : core::Vec3(std::cos(v) * std::sin(h), std::sin(v), std::cos(v) * std::cos(h));
  const double c = std::atan2(local.y, local.x) / degree;
  peak.gamma = std::atan2(std::hypot(local.x, local.y), local.z) / degree;
  peak.c = peak.gamma == 0 ? 0 : c < 0 ? c + 360 : c;
  return peak;
}

std::optional<double> fullWidth(const TabulatedDistribution& distribution, PrincipalPlane plane, double fraction) {
  Profile p = profileOf(distribution, plane);
  double largest = 0, largestBelow = 0;
  for (std::size_t i = 0; i < p.theta.size(); ++i) {
    largest = std::max(largest, p.intensity[i]);
    if (std::abs(p.theta[i]) <= 90) largestBelow = std::max(largestBelow, p.intensity[i]);
  }
  if (largest <= 0) return std::nullopt;
  // A plateau that reaches past the horizontal, as a bare batten's does, belongs to the light that goes down.
  constexpr double rounding = 1e-9;
  if (largestBelow < (1 - rounding) * largest) p = turnedOver(p);
  const double level = fraction * largest;
  std::size_t first = p.theta.size(), last = 0;
  for (std::size_t i = 0; i < p.theta.size(); ++i) {
    if (std::abs(p.theta[i]) > 90 || p.intensity[i] < level) continue;
    first = std::min(first, i);
    last = i;
  }
  while (first > 0 && p.intensity[first - 1] >= level) --first;
  while (last + 1 < p.theta.size() && p.intensity[last + 1] >= level) ++last;
  const double low = first > 0 ? crossing(p, first - 1, level) : p.theta.front();
  const double high = last + 1 < p.theta.size() ? crossing(p, last, level) : p.theta.back();
  return std::min(360.0, high - low);
}

std::array<double, 5> cieFluxCode(const TabulatedDistribution& distribution, std::optional<double> lampFlux) {
  // Cones of pi/2, pi and 3 pi/2 sr: cos(gamma) = 3/4, 1/2, 1/4.
  const double cone1 = zoneFlux(distribution, 0, std::acos(0.75) / degree), cone2 = zoneFlux(distribution, 0, 60),
               cone3 = zoneFlux(distribution, 0, std::acos(0.25) / degree);
  const double below = distribution.forwardFlux(), all = distribution.flux();
  const auto percent = [](double part, double whole) { return whole > 0 ? 100 * part / whole : 0; };
  return {percent(cone1, below), percent(cone2, below), percent(cone3, below), percent(below, all),
          lampFlux ? percent(all, *lampFlux) : 100};
}

}  // namespace goniolux::photometry
