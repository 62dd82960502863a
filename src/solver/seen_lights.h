// Seen lights: the luminous parts of luminaires and emitting surfaces as an eye sees them, past and through what stands
// between: what glare ratings are made of.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "reflection/bsdf.h"
#include "solver/solver.h"

namespace goniolux::solver {

/// One emitter of the world. World frame.
struct SeenLight {
  std::uint32_t source = 0;      ///< index into World::emitters
  core::Vec3 direction{0};       ///< unit: from the eye to the middle of the luminous part that it sees
  double distance = 0;           ///< m, to that
  double normalIlluminance = 0;  ///< lx on planes facing the light: the integral of luminance over solid angle
  double solidAngle = 0;         ///< sr, of the luminous part that is seen; 0 for points and lines
};

/// Thread safe. The problem's parts must outlive it.
class SeenLights {
 public:
  explicit SeenLights(const Problem& problem);

  /// The lights that send light to `eye`, one unbiased estimate of each from `samples` rays. Mirror images are not
  /// lights here.
  [[nodiscard]] std::vector<SeenLight> from(const core::Vec3& eye, std::uint64_t key, std::uint32_t samples) const;

 private:
  /// Transmittance (photopic) of what stands before `distance`; 0: blocked. `normal` is that of the emitter where the
  /// ray met it, if it did.
  double transmittance(const core::Vec3& eye, const core::Vec3& direction, double distance, std::uint32_t source,
                       core::Vec3& normal) const;

  const Problem problem_;
  std::vector<std::unique_ptr<reflection::Bsdf>> bsdfs_;  // per material
};

}  // namespace goniolux::solver
