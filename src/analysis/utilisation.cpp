#include "analysis/utilisation.h"

#include <algorithm>
#include <cmath>

#include "photometry/metrics.h"

namespace goniolux::analysis {
namespace {

using core::degree;
using core::pi;
using core::Vec3;

Vec3 direction(double c, double gamma) {
  return {std::sin(gamma) * std::cos(c), std::sin(gamma) * std::sin(c), std::cos(gamma)};
}

// For a room cavity ratio: square rooms have k = 5 / RCR.
Cavity cavityOf(double roomCavityRatio) {
  return Cavity::square(5 / roomCavityRatio);
}

}  // namespace

double floorToCeiling(const Cavity& cavity) {
  const double x = cavity.length, y = cavity.width;
  const double rx = std::sqrt(1 + x * x), ry = std::sqrt(1 + y * y);
  return 2 / (pi * x * y) *
         (0.5 * std::log(rx * rx * ry * ry / (1 + x * x + y * y)) + x * ry * std::atan(x / ry) +
          y * rx * std::atan(y / rx) - x * std::atan(x) - y * std::atan(y));
}

double directRatio(const photometry::IntensityDistribution& distribution, const Cavity& cavity) {
  // Midpoint rule; the kernel is smooth but for its edge, where it comes to 0.
  constexpr int rings = 180, sectors = 180;
  double down = 0, direct = 0;
  for (int i = 0; i < rings; ++i) {
    const double low = 0.5 * i * degree, high = 0.5 * (i + 1) * degree, gamma = 0.5 * (low + high);
    const double solidAngle = 2 * pi / sectors * (std::cos(low) - std::cos(high));
    for (int j = 0; j < sectors; ++j) {
      const double c = 2 * pi * (j + 0.5) / sectors;
      const double flux = distribution.intensity(direction(c, gamma)) * solidAngle;
      down += flux;
      direct += flux * std::max(0.0, 1 - std::abs(std::tan(gamma) * std::cos(c)) / cavity.length) *
                std::max(0.0, 1 - std::abs(std::tan(gamma) * std::sin(c)) / cavity.width);
    }
  }
  return down > 0 ? direct / down : 0;
}

double zonalDirectRatio(const std::array<double, 18>& zonalLumens, double roomCavityRatio) {
  static constexpr std::array<double, 9> a{0, 0.041, 0.070, 0.100, 0.136, 0.190, 0.315, 0.640, 2.10};
  static constexpr std::array<double, 9> b{0, 0.98, 1.05, 1.12, 1.16, 1.25, 1.25, 1.25, 0.80};
  double down = 0, direct = 0;
  for (std::size_t n = 0; n < a.size(); ++n) {
    down += zonalLumens[n];
    direct += zonalLumens[n] * std::exp(-a[n] * std::pow(roomCavityRatio, b[n]));
  }
  return down > 0 ? direct / down : 0;
}

CavityFlux exchange(const CavityFlux& first, double f, double wallArea, const CavityReflectances& rho) {
  // Areas in units of the floor's. F_wc = (1 - f) / A_w by reciprocity, F_ww = 1 - 2 F_wc.
  const double toWalls = 1 - f, fromWalls = wallArea > 0 ? toWalls / wallArea : 0,
               within = wallArea > 0 ? 1 - 2 * fromWalls : 0;
  // incident = first + transfer * incident
  const glm::dmat3 transfer(0, rho.ceiling * toWalls, rho.ceiling * f,  // column: from the ceiling to each
                            rho.walls * fromWalls, rho.walls * within, rho.walls * fromWalls,  //
                            rho.floor * f, rho.floor * toWalls, 0);
  const Vec3 incident = glm::inverse(glm::dmat3(1.0) - transfer) * Vec3(first.ceiling, first.walls, first.floor);
  return {incident.x, incident.y, incident.z};
}

double utilisationFactor(double upwardFlux, double downwardFlux, double lampFlux, double ratio, const Cavity& cavity,
                         const CavityReflectances& reflectances) {
  if (!(lampFlux > 0)) return 0;
  const CavityFlux first{upwardFlux, (1 - ratio) * downwardFlux, ratio * downwardFlux};
  return exchange(first, floorToCeiling(cavity), 2 / cavity.roomIndex(), reflectances).floor / lampFlux;
}

UtilisationTable roomIndexTable(const photometry::TabulatedDistribution& d, double lampFlux) {
  UtilisationTable table;
  table.rooms = {0.6, 0.8, 1, 1.25, 1.5, 2, 2.5, 3, 4, 5};
  table.reflectances = {{.8, .5, .2}, {.8, .3, .2}, {.7, .5, .2}, {.7, .3, .2}, {.7, .1, .2},
                        {.5, .5, .2}, {.5, .3, .2}, {.5, .1, .2}, {.3, .3, .2}, {0, 0, 0}};
  for (const double k : table.rooms) {
    const Cavity cavity = Cavity::square(k);
    const double ratio = directRatio(d, cavity);
    std::vector<double> row;
    for (const CavityReflectances& rho : table.reflectances)
      row.push_back(utilisationFactor(d.flux() - d.forwardFlux(), d.forwardFlux(), lampFlux, ratio, cavity, rho));
    table.factors.push_back(std::move(row));
  }
  return table;
}

UtilisationTable zonalCavityTable(const photometry::TabulatedDistribution& d, double lampFlux) {
  UtilisationTable table;
  table.reflectances = {{.8, .5, .2}, {.8, .3, .2}, {.8, .1, .2}, {.7, .5, .2}, {.7, .3, .2}, {.7, .1, .2},
                        {.5, .5, .2}, {.5, .3, .2}, {.5, .1, .2}, {.3, .3, .2}, {.1, .1, .2}, {0, 0, 0}};
  const std::array<double, 18> zones = photometry::zonalLumens(d);
  const double down = d.forwardFlux(), up = d.flux() - down;
  for (int ratio = 0; ratio <= 10; ++ratio) {
    table.rooms.push_back(ratio);
    std::vector<double> row;
    for (const CavityReflectances& rho : table.reflectances) {
      // Ratio 0: no walls; floor and ceiling see only each other.
      const double factor =
          ratio == 0 ? exchange({up, 0, down}, 1, 0, rho).floor / lampFlux
                     : utilisationFactor(up, down, lampFlux, zonalDirectRatio(zones, ratio), cavityOf(ratio), rho);
      row.push_back(lampFlux > 0 ? factor : 0);
    }
    table.factors.push_back(std::move(row));
  }
  return table;
}

SpacingCriterion spacingCriterion(const photometry::IntensityDistribution& d) {
  // Outermost angle at which I cos^3 is still the given part of what it is straight down; both sides of a plane.
  const double below = d.intensity({0, 0, 1});
  const auto reach = [&](double c, double part) {
    constexpr double step = 0.1 * degree;
    double last = 0;
    for (double gamma = 0; gamma < 89 * degree; gamma += step) {
      const double cosine = std::cos(gamma);
      const double mean = 0.5 * (d.intensity(direction(c, gamma)) + d.intensity(direction(c + pi, gamma)));
      if (mean * cosine * cosine * cosine >= part * below) last = gamma;
    }
    return std::tan(last);
  };
  if (!(below > 0)) return {};
  const double four = 0.5 * (reach(0.25 * pi, 0.25) + reach(0.75 * pi, 0.25));
  return {2 * reach(0, 0.5), 2 * reach(0.5 * pi, 0.5), std::sqrt(2.0) * four};
}

}  // namespace goniolux::analysis
