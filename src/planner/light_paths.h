// LightPaths: the spectra that light is multiplied by on its likely ways through a scene.
//
// The room is thought of as well mixed: a reflection meets a finish in proportion to its area. With the mean
// reflectance m of the room, light that is reflected on and on amounts to 1 + m + m^2 + … = 1 / (1 - m). Where a
// point stands near one finish, it sees more of that one: half of its surroundings are taken to be that finish.
#pragma once

#include <cstddef>
#include <vector>

#include "scene/world.h"
#include "spectrum/spectral_distribution.h"

namespace goniolux::planner {

/// A finish as light paths meet it, and the share of the scene's area that it covers.
struct Finish {
  spectrum::SpectralDistribution reflectance;
  double share = 0;
};

/// The different reflectances of a scene with their shares of the area, largest first; the shares sum to 1.
std::vector<Finish> finishesOf(const scene::World& world);

class LightPaths {
 public:
  explicit LightPaths(const std::vector<Finish>& finishes);

  /// What a path's error spoils.
  enum class Seen {
    byGrid,  ///< the illuminance of a point without direct light: after one, two or all reflections near a finish
    byEye,   ///< a surface under direct light, under indirect light, under both, or under a neighbour's
  };
  [[nodiscard]] std::size_t size() const { return seen_.size(); }
  [[nodiscard]] Seen seen(std::size_t path) const { return seen_[path]; }

  /// Transmittances [path][node] from the finishes' reflectances [finish][node] at any nodes.
  [[nodiscard]] std::vector<std::vector<double>> transmittances(
      const std::vector<std::vector<double>>& reflectances) const;

 private:
  std::vector<double> shares_;
  std::vector<std::pair<std::size_t, std::size_t>> pairs_;
  std::vector<Seen> seen_;
};

}  // namespace goniolux::planner
