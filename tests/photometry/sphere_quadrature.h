// An integration of intensity() over directions that knows nothing about tables: the independent check of closed forms.
#pragma once

#include <cmath>
#include <vector>

#include "photometry/intensity_distribution.h"

namespace goniolux::test {

/// Gauss-Legendre nodes on [0, 1] (two points; composite panels make it accurate).
inline constexpr double gaussNodes[2] = {0.21132486540518712, 0.78867513459481288};

/// Integral of I over the directions with gamma between the given angles (degrees), by composite Gauss quadrature on
/// gammaPanels x cPanels cells of the (C, gamma) sphere about the aim, whatever the type of the table.
template <typename Integrand>
double integrateOverSphere(const Integrand& intensity, double fromGamma, double toGamma, int gammaPanels, int cPanels) {
  using core::degree, core::pi;
  const double dGamma = (toGamma - fromGamma) * degree / gammaPanels, dC = 2 * pi / cPanels;
  double sum = 0;
  for (int i = 0; i < gammaPanels; ++i) {
    for (const double u : gaussNodes) {
      const double gamma = fromGamma * degree + (i + u) * dGamma;
      const double s = std::sin(gamma), z = std::cos(gamma);
      double ring = 0;
      for (int j = 0; j < cPanels; ++j) {
        for (const double v : gaussNodes) {
          const double c = (j + v) * dC;
          ring += intensity(core::Vec3(s * std::cos(c), s * std::sin(c), z));
        }
      }
      sum += ring * s;
    }
  }
  return sum * dGamma * dC / 4;
}

inline double quadratureFlux(const photometry::IntensityDistribution& distribution, double fromGamma = 0,
                             double toGamma = 180, int gammaPanels = 360, int cPanels = 360) {
  return integrateOverSphere([&](const core::Vec3& d) { return distribution.intensity(d); }, fromGamma, toGamma,
                             gammaPanels, cPanels);
}

}  // namespace goniolux::test
