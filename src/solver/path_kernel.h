// The path tracing kernel, compiled for a few widths of the spectral block: W is the number of spectral samples rounded
// up, so that every loop over the block has a constant count and becomes vector code.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include "reflection/bsdf.h"
#include "solver/bright_spots.h"
#include "solver/caustics.h"
#include "solver/free_view.h"
#include "solver/light_list.h"
#include "solver/light_solution.h"
#include "solver/media.h"
#include "solver/solver.h"

namespace goniolux::solver {

/// Far beyond what Russian roulette lets live; guards against mirrors of reflectance 1.
inline constexpr int mostReflections = 10000;

/// Keys of the independent random streams of one estimate.
inline constexpr std::uint64_t indirectStream = 0x1d1, lightStream = 0x119;

inline double photopic(const Response& r) {
  return r[1];
}

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

/// Where a path may end in a light solution instead of going on.
enum class Ending {
  never,     ///< the path goes on to its own end
  solution,  ///< at the first point that the solution answers for
  remainder  ///< the path goes on, and the solution's answer is taken away: what ending there would have missed
};

template <int W>
class PathSolver : public Solver {
 public:
  explicit PathSolver(const Problem& problem);

  [[nodiscard]] std::unique_ptr<ReceiverPlan> plan(const Receiver& receiver, std::uint64_t key) const override;
  [[nodiscard]] Response illuminance(const Receiver& receiver, const ReceiverPlan& plan, std::uint64_t key,
                                     std::uint32_t samples) const override;
  [[nodiscard]] Response wholeIlluminance(const Receiver& receiver, const ReceiverPlan& plan, std::uint64_t key,
                                          std::uint32_t samples) const override;
  [[nodiscard]] Response radiance(const core::Vec3& origin, const core::Vec3& direction, std::uint64_t key,
                                  std::uint32_t sample) const override;
  [[nodiscard]] bool partsLight() const override { return true; }
  [[nodiscard]] PartedLight partedLight(const core::Vec3& origin, const core::Vec3& direction, std::uint64_t key,
                                        std::uint32_t sample) const override;
  [[nodiscard]] std::vector<std::string> leftOut() const override;

 protected:
  using Vec3 = core::Vec3;
  using Spectral = Block<W>;

  /// A light's share in the plan of a receiver.
  struct LightPlan {
    std::uint32_t light;
    bool fromExact;  ///< the estimate starts from the unoccluded value and takes away what is blocked; else it adds
                     ///< what is seen
    double sigma;    ///< standard deviation of one sample, lx
    std::uint32_t pilot;  ///< shadow rays that found this out; 0: nothing can stand in the way
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
  /// Where a ray meets the first diffuse surface, and what the mirrors and glass on the way leave of its light.
  struct Arrival {
    bool found = false, filtered = false, textured = false;
    std::uint32_t surface = 0;
    Vertex at;
    Spectral filter;
    Spectral reflectance{};  ///< of a textured finish there
  };
  /// The point that a direction leaves from, as connections to bright spots know it.
  struct Guidance {
    bool pending = false;
    BrightSpots::Choice choice{};
  };
  /// A path under way, and what its last connections to the lights have already found.
  struct Path {
    Vec3 origin, direction;
    Spectral throughput;
    Media media{};
    std::size_t hero = 0;    ///< the node whose refractive index it follows
    bool dispersed = false;  ///< it carries the light of that node only
    bool connected = false;  ///< emitters met from here on are those that the last point was connected to
    int mirrors = 0;         ///< plane mirrors met since
    double density = 0;      ///< with which a glossy finish chose this direction; 0: connections found everything
    double share = 1;        ///< a light's nominal probability of being connected to
    Vec3 seenFrom{0};        ///< the last point, as it appears through those mirrors
    Guidance guidance{};
    bool isOpen = false;         ///< its last point was connected to the lights in the direction that it goes
    bool isBent = false;         ///< has met a curved mirror or an interface since
    bool onSpot = false;         ///< what it has met is a bright spot
    double white = 0;            ///< it carries every wavelength alike, times this; 0: no longer
    Response* direct = nullptr;  ///< gets the emitted light that is met before the next matt or glossy surface, too
  };
  struct Meeting {
    tracer::Hit hit;
    reflection::Interface interface;
    const reflection::Bsdf* bsdf = nullptr;
    texture::Mixture mixture{};  ///< of a textured finish; the interface points to it
  };
  /// How a surface is shaded: its local frame, about the geometric normal or, in pictures, about one that makes it look
  /// round or rough. `gain` gives back what the tilt of that frame would lose of even light (addDirect, radianceBy).
  struct Shading {
    core::Frame frame;
    bool isTilted = false;
    double gain = 1;
  };

  void add(Response& sum, std::uint32_t spectrum, const Spectral& throughput, double factor) const;
  /// Follows a connection; false when something blocks it. `filter` gets the reflectances of mirrors and the
  /// transmittances of panes.
  bool connected(const Light& light, const Vertex& from, const Vec3& unfoldedDirection, double distance,
                 Spectral& filter, std::uint64_t& rays) const;
  /// True when only panes lie on the way, and the luminaire's own housing.
  bool seenThroughPanes(const std::vector<std::uint32_t>& housings, Vec3 origin, const Vec3& direction, double length,
                        Spectral& filter, std::uint64_t& rays) const;
  /// What a receiver makes of a unit of light from a light's (unfolded) direction; 0 below a plane's horizon.
  [[nodiscard]] double answerTo(const Light& light, const Receiver& receiver, const Vec3& unfoldedDirection) const;
  [[nodiscard]] Vertex vertexOf(const Receiver& receiver) const {
    return {receiver.point, tracer_.leave(receiver.point, receiver.normal), receiver.normal};
  }
  Response connectOnce(const LightPlan& plan, const Receiver& receiver, const core::Vec2& u, std::uint64_t& rays) const;
  /// Shadow rays towards a light: what share of it is seen, and how its samples scatter.
  void studyVisibility(LightPlan& entry, const Receiver& receiver, std::uint64_t key, std::uint64_t& rays) const;
  /// Unoccluded illuminance from a light with its mirrors' reflectances, as a response.
  Response exactResponse(const Light& light, double value) const;
  void addDirect(Response& sum, const Vertex& at, const Meeting& met, const Vec3& out, const Shading& shading,
                 const Path& path, bool everyLight, core::Sampler& random, std::uint64_t& rays) const;
  /// The same at a vertex of a path, times a share.
  void addShared(Response& sum, const Vertex& at, const Meeting& met, const core::Frame& frame, const Vec3& out,
                 const Path& path, double share, core::Sampler& random, std::uint64_t& rays) const;
  /// For what the eye sees first; everywhere else surfaces are as flat as they are.
  [[nodiscard]] Shading shadingSeen(const Meeting& met, const Vertex& at, const Vec3& towardsEye) const;
  /// Everything that arrives along a path.
  void follow(Response& sum, Path& path, Ending ending, core::Sampler& random, std::uint64_t& rays) const;
  /// What the solution knows about the light of a hit.
  struct CellAnswer {
    std::uint32_t cell = LightSolution::none;  ///< none: nothing
    bool withoutDirect = false;                ///< it answers for what is interreflected only
  };
  [[nodiscard]] CellAnswer cellAt(const Path& path, const tracer::Hit& hit, const Vertex& at,
                                  core::Sampler& random) const;
  /// Adds `factor` times what a cell reflects.
  void addCell(Response& sum, const CellAnswer& answer, const Spectral& throughput, double factor) const;
  [[nodiscard]] Ending ending() const { return solution_ != nullptr ? Ending::solution : Ending::never; }
  Response directLight(const Plan& plan, const Receiver& receiver, std::uint64_t key, std::uint32_t samples,
                       std::uint64_t& rays) const;
  Response radianceBy(Ending ending, const core::Vec3& origin, const core::Vec3& direction, std::uint64_t key,
                      std::uint32_t sample, Response* direct = nullptr) const;
  Response illuminanceBy(Ending ending, const Receiver& receiver, const ReceiverPlan& plan, std::uint64_t key,
                         std::uint32_t samples) const;
  /// Adds what one path from a receiver brings after reflections, lx.
  void addPath(Response& sum, const Receiver& receiver, std::uint64_t stream, std::uint32_t sample, Ending ending,
               std::uint64_t& rays) const;
  /// A path that starts at a receiver whose direct light is counted already.
  [[nodiscard]] Path pathFrom(const Vertex& at, const core::Frame& frame, core::Sampler& random) const;
  /// The next surface that does something to the light; absorption on the way is applied. False: none.
  bool meet(Path& path, Meeting& met, std::uint64_t& rays) const;
  /// Emitted light that the path finds at a hit, as far as connections did not find it.
  void addEmitted(Response& sum, const Path& path, const tracer::Hit& hit) const;
  /// Takes the path on in a sampled direction. False: it ends there (Russian roulette).
  bool goOn(Path& path, const Meeting& met, const Vertex& at, const core::Frame& frame,
            const reflection::BsdfSample& next, const Spectral& weight, bool roulette, core::Sampler& random) const;
  /// Connects `at`, from where the path goes on in a cosine-distributed direction, to a bright spot, with some
  /// probability: adds the direct light that is reflected there. What the path meets itself is shared with that.
  void addSpot(Response& sum, Path& path, const Vertex& at, Ending ending, core::Sampler& random,
               std::uint64_t& rays) const;
  /// The share with which the direct light of what a path has met counts: 1 where no connection could have found it.
  double directShare(Path& path, const tracer::Hit& hit) const;
  /// Some `wanted` rays as the luminaires emit them, where they meet the first matt surface.
  [[nodiscard]] std::vector<LandedLight> landLight(std::size_t wanted) const;
  void findSpots(double area);
  void findCaustics(std::size_t nodes, double accuracy);
  /// visit(arrival, filter) for what comes to a point from small luminaires by curved mirrors and through solid glass.
  template <typename Visit>
  void eachCausticAt(const Vec3& point, std::size_t node, double draw, std::uint64_t& rays, const Visit& visit) const;
  /// The same for all wavelengths, where each goes its own way.
  template <typename Visit>
  void everyCausticAt(const Vec3& point, double draw, std::uint64_t& rays, const Visit& visit) const;
  void planCaustics(Plan& plan, const Receiver& receiver, std::uint64_t& rays) const;
  void addCaustics(Response& sum, const Vertex& at, const Meeting& met, const Vec3& out, const Shading& shading,
                   const Path& path, bool isSeen, core::Sampler& random, std::uint64_t& rays) const;
  /// Follows a ray over mirrors and through glass to the first diffuse surface.
  [[nodiscard]] Arrival arrive(const Vec3& origin, const Vec3& direction, core::Sampler& random,
                               std::uint64_t& rays) const;
  void collapse(Path& path) const;
  void chooseHero(Path& path, core::Sampler& random) const;
  /// The hit as a point to shade, on the side that the ray came from.
  [[nodiscard]] Vertex vertexAt(const tracer::Hit& hit, const Vec3& direction) const;
  [[nodiscard]] double emittedLuminance(const tracer::Hit& hit, const Vec3& towards, std::uint32_t& spectrum) const;
  /// Index into World::emitters, or scene::none.
  [[nodiscard]] std::uint32_t emitterAt(const tracer::Hit& hit) const;
  [[nodiscard]] const reflection::Bsdf& bsdfOf(std::uint32_t surface) const {
    return *bsdfs_[world_.surfaces[surface].material];
  }

  const scene::World& world_;
  const tracer::Tracer& tracer_;
  std::vector<std::unique_ptr<reflection::Bsdf>> bsdfs_;    // per material
  std::vector<Spectral> mirrorReflectance_;                 // per material, at normal incidence; 1 where no mirror
  std::vector<std::vector<std::array<float, W>>> weights_;  // [spectrum][channel][node]
  std::unique_ptr<LightList> lights_;
  std::vector<std::uint32_t> emitterOfTriangle_;  // index into World::emitters, of emitting finishes
  std::vector<double> heroProbability_, heroCumulative_;
  bool lightsAreFew_ = false;
  bool hasMedia_ = false, disperses_ = false, hasTextures_ = false;
  FreeView freeView_;
  BrightSpots spots_;
  std::unique_ptr<Caustics> caustics_;  ///< null: there are none
  std::vector<std::string> leftOut_;
  double brightest_ = 0;                     // luminance of what emits, roughly, cd/m2
  double pilotRays_;                         // shadow rays of a receiver's pilot, over all lights
  std::unique_ptr<LightSolution> solution_;  // of solvers that end paths in one
  bool hasPanes_ = false;  ///< something goes straight through, or mirrors differently at different angles
};

}  // namespace goniolux::solver
