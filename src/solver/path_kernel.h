// The path tracing kernel, compiled for a few widths of the spectral block: W is the number of spectral samples rounded
// up, so that every loop over the block has a constant count and becomes vector code.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include "reflection/bsdf.h"
#include "solver/light_list.h"
#include "solver/solver.h"

namespace goniolux::solver {

/// A spectral block: one value per node, zero beyond them.
template <int W>
struct alignas(W >= 8 ? 32 : 4 * W) Block {
  std::array<float, W> v;
  [[nodiscard]] static Block filled(float value) {
    Block b;
    b.v.fill(value);
    return b;
  }
  void operator*=(const Block& other) {
#pragma omp simd
    for (int k = 0; k < W; ++k) v[k] *= other.v[k];
  }
  void operator*=(float factor) {
#pragma omp simd
    for (int k = 0; k < W; ++k) v[k] *= factor;
  }
  [[nodiscard]] float largest() const { return *std::max_element(v.begin(), v.end()); }
};

template <int W>
class PathSolver final : public Solver {
 public:
  explicit PathSolver(const Problem& problem);

  [[nodiscard]] std::unique_ptr<ReceiverPlan> plan(const Receiver& receiver, std::uint64_t key) const override;
  [[nodiscard]] Response illuminance(const Receiver& receiver, const ReceiverPlan& plan, std::uint64_t key,
                                     std::uint32_t samples) const override;
  [[nodiscard]] Response radiance(const core::Vec3& origin, const core::Vec3& direction, std::uint64_t key,
                                  std::uint32_t sample) const override;
  [[nodiscard]] std::vector<std::string> leftOut() const override;

 private:
  using Vec3 = core::Vec3;
  using Spectral = Block<W>;

  /// A light's share in the plan of a receiver.
  struct LightPlan {
    std::uint32_t light;
    bool fromExact;  ///< the estimate starts from the unoccluded value and takes away what is blocked; else it adds
                     ///< what is seen
    double sigma;    ///< standard deviation of one sample, lx
    std::uint32_t pilot;  ///< shadow rays that found this out
  };
  struct Plan final : ReceiverPlan {
    Response exact{};  ///< deterministic part
    std::vector<LightPlan> lights;
    double indirectSigma = 0;
  };
  /// A point of a path: where it is, and the local frame on the side that is lit.
  struct Vertex {
    Vec3 point, start, normal;  ///< start: where rays leave
  };

  void add(Response& sum, std::uint32_t spectrum, const Spectral& throughput, double factor) const;
  /// Follows a connection; false when something blocks it. `filter` gets the mirrors' reflectances.
  bool connected(const Light& light, const Vertex& from, const Vec3& unfoldedDirection, double distance,
                 Spectral& filter, std::uint64_t& rays) const;
  Response connectOnce(const LightPlan& plan, const Vertex& at, const core::Vec2& u, std::uint64_t& rays) const;
  /// Shadow rays towards a light: what share of it is seen, and how its samples scatter.
  void studyVisibility(LightPlan& entry, const Vertex& at, std::uint64_t key, std::uint64_t& rays) const;
  /// Unoccluded illuminance from a light with its mirrors' reflectances, as a response.
  Response exactResponse(const Light& light, double value) const;
  void addDirect(Response& sum, const Vertex& at, const reflection::Bsdf& bsdf, const Vec3& out,
                 const core::Frame& frame, const Spectral& throughput, bool everyLight, core::Sampler& random,
                 std::uint64_t& rays) const;
  /// Everything that arrives along a ray that left a point whose direct light is counted already.
  void follow(Response& sum, Vec3 origin, Vec3 direction, Spectral throughput, core::Sampler& random,
              std::uint64_t& rays) const;
  /// The hit as a point to shade, on the side that the ray came from.
  [[nodiscard]] Vertex vertexAt(const tracer::Hit& hit, const Vec3& direction) const;
  [[nodiscard]] double emittedLuminance(const tracer::Hit& hit, const Vec3& towards, std::uint32_t& spectrum) const;

  const scene::World& world_;
  const tracer::Tracer& tracer_;
  std::vector<std::unique_ptr<reflection::Bsdf>> bsdfs_;    // per material
  std::vector<Spectral> mirrorReflectance_;                 // per material; 1 where no mirror
  std::vector<std::vector<std::array<float, W>>> weights_;  // [spectrum][channel][node]
  std::unique_ptr<LightList> lights_;
  bool lightsAreFew_ = false, losesCaustics_ = false;
};

}  // namespace goniolux::solver
