// How far a spectral quadrature is from the 1 nm control, on the light paths that are likely in a scene.
#pragma once

#include <vector>

#include "planner/light_paths.h"
#include "spectrum/spectral_quadrature.h"

namespace goniolux::planner {

/// Bounds, with a margin for paths like those looked at. Relative errors are those of adapted_quadrature.h: of the
/// path's own light, but no less than `darkestShare`.
struct SpectralError {
  double illuminance = 0;  ///< largest relative error of Y over the paths that a grid sees
  double melanopic = 0;    ///< the same of the melanopic response
  double luminance = 0;    ///< of Y over the paths that an eye sees
  double colour = 0;       ///< largest CIEDE2000 over the paths that an eye sees; white is the unreflected light
};

/// Measures quadratures of the same sources on the same finishes. Thread safe.
class SpectralErrors {
 public:
  SpectralErrors(const std::vector<Finish>& finishes, const std::vector<spectrum::SpectralDistribution>& sources);

  [[nodiscard]] SpectralError of(const spectrum::SpectralQuadrature& quadrature) const;

  [[nodiscard]] const LightPaths& paths() const { return paths_; }
  [[nodiscard]] const spectrum::SpectralQuadrature& control() const { return control_; }
  /// [path][node of the control].
  [[nodiscard]] const std::vector<std::vector<double>>& transmittances() const { return fine_; }

 private:
  std::vector<Finish> finishes_;
  LightPaths paths_;
  spectrum::SpectralQuadrature control_;
  std::vector<std::vector<double>> fine_;
  std::vector<std::vector<spectrum::Response>> exact_;  // [source][path]
};

}  // namespace goniolux::planner
