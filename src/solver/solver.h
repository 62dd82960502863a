// Solver: answers "what illuminance arrives at this point and normal" and "what radiance comes along this ray", each as
// an unbiased estimate that is a pure function of its key, so that independent keys give independent replicates. World
// frame (scene/world.h).
//
// Results are Responses (spectrum/spectral_quadrature.h): X, Y, Z and melanopic; channel 1 is photometric: lx, or
// cd/m2.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/random.h"
#include "core/vector.h"
#include "scene/world.h"
#include "solver/receiver.h"
#include "spectrum/spectral_quadrature.h"
#include "tracer/tracer.h"

namespace goniolux::solver {

using spectrum::Response;

/// What a solver found out about a receiver before it estimates: which light is exact, where samples are needed.
class ReceiverPlan {
 public:
  virtual ~ReceiverPlan() = default;
  /// Bound of the deterministic part's error ("source_subdivision").
  Response quadratureBound{};
  /// Interreflected illuminance, roughly.
  Response interreflected{};
};

/// What arrives along a ray, and the part of it that is direct: emitted light seen by itself, in mirrors or through
/// glass, or after one reflection from a matt or glossy surface.
struct PartedLight {
  Response whole{}, direct{};
};

/// A figure of a solver's own: "average_tree_depth".
struct Statistic {
  std::string name;
  double value = 0;
  std::string unit;
};

class Solver {
 public:
  virtual ~Solver() = default;
  /// Studies a receiver with samples of its own (`key`): later estimates with other keys stay unbiased.
  [[nodiscard]] virtual std::unique_ptr<ReceiverPlan> plan(const Receiver& receiver, std::uint64_t key) const = 0;
  /// One unbiased estimate of the illuminance from `samples` light paths.
  [[nodiscard]] virtual Response illuminance(const Receiver& receiver, const ReceiverPlan& plan, std::uint64_t key,
                                             std::uint32_t samples) const = 0;
  /// One unbiased estimate of the luminance (and X, Z) that arrives at `origin` from `direction`. Estimates with the
  /// same key and samples 0, 1, 2 … are spread evenly over light paths; their mean is one replicate.
  [[nodiscard]] virtual Response radiance(const core::Vec3& origin, const core::Vec3& direction, std::uint64_t key,
                                          std::uint32_t sample) const = 0;

  /// The same with the direct part apart; only by solvers that part them.
  [[nodiscard]] virtual bool partsLight() const { return false; }
  [[nodiscard]] virtual PartedLight partedLight(const core::Vec3& origin, const core::Vec3& direction,
                                                std::uint64_t key, std::uint32_t sample) const {
    return {radiance(origin, direction, key, sample), {}};
  }

  /// The same without a light solution, where the solver has one: dearer, and unbiased.
  [[nodiscard]] virtual Response wholeIlluminance(const Receiver& receiver, const ReceiverPlan& plan, std::uint64_t key,
                                                  std::uint32_t samples) const {
    return illuminance(receiver, plan, key, samples);
  }

  /// False for a solver whose expectation is not the answer itself, but the answer less what missed() estimates.
  [[nodiscard]] virtual bool isUnbiased() const { return true; }
  /// One unbiased estimate of what illuminance() misses at a receiver; may be negative. Samples 0, 1, 2 … of a key
  /// are spread evenly over directions, also when each is taken at another receiver.
  [[nodiscard]] virtual Response missed(const Receiver&, std::uint64_t /*key*/, std::uint32_t /*sample*/) const {
    return {};
  }

  /// The same for radiance(), cd/m2.
  [[nodiscard]] virtual double missedLuminance(const core::Vec3& /*origin*/, const core::Vec3& /*direction*/,
                                               std::uint64_t /*key*/, std::uint32_t /*sample*/) const {
    return 0;
  }

  /// What this solver leaves out in this world, as sentences; empty: nothing.
  [[nodiscard]] virtual std::vector<std::string> leftOut() const { return {}; }
  /// Figures of what was done so far, for the results.
  [[nodiscard]] virtual std::vector<Statistic> statistics() const { return {}; }
  /// Rays traced so far.
  [[nodiscard]] std::uint64_t rays() const { return rays_.load(std::memory_order_relaxed); }

 protected:
  mutable std::atomic<std::uint64_t> rays_{0};
};

/// What the solver `tree` is told by the project's settings.
struct TreeSettings {
  int maxDepth = 15;
  double cutoff = 0.001;
  bool adaptive = true;
  std::string reflectionModel = "material";  ///< or one of the paper's, for all finishes
  bool asPrinted = false;
  spectrum::SpectralDistribution ambient;  ///< I_a, cd/m2
};

/// Everything a solver works on; must outlive it.
struct Problem {
  const scene::World& world;
  const tracer::Tracer& tracer;
  const spectrum::SpectralQuadrature& quadrature;
  double accuracy = 0.01;  ///< relative, asked of the results: how fine a light solution is worth its while
  TreeSettings tree{};
};

/// The registry of solvers: adding one is a file of its own and a line in solvers.cpp.
struct SolverType {
  std::string name, title, help;
  std::unique_ptr<Solver> (*make)(const Problem& problem);
};
const std::vector<SolverType>& solverTypes();
const SolverType* findSolverType(const std::string& name);

}  // namespace goniolux::solver
