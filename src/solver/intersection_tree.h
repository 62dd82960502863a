// The paper's intersection tree: what the ray of a sample meets, and what the rays that it spawns meet.
//
// A node holds what is needed to evaluate a reflection model there: the surface, the direction of the view, the media
// on either side, the distance from the previous node, and the light sources that are seen. A kept tree can be
// evaluated again, for other lamps' spectra, other dimming, other finishes of the same geometry: nothing is traced
// then.
#pragma once

#include <cstdint>
#include <vector>

#include "core/random.h"
#include "reflection/shading.h"
#include "solver/media.h"
#include "solver/solver.h"

namespace goniolux::solver {

/// Light of an emitter that arrives at a node unblocked.
struct Arrival {
  std::uint32_t emitter = 0;  ///< index into World::emitters
  core::Vec3 in{0, 0, 1};     ///< where it comes from, in the node's frame
  double e = 0;               ///< lx at normal incidence
};

struct TreeNode {
  std::int32_t reflected = -1, transmitted = -1;  ///< children
  std::int32_t depth = 1;                         ///< 1: what the eye's ray meets
  double distance = 0;                            ///< from the previous node, m
  double bound = 1;  ///< largest share of its intensity that can reach the eye: the product of its ancestors' bounds
  core::Vec3 out{0, 0, 1};  ///< to the viewer, in the node's frame
  std::uint32_t material = 0;
  const reflection::Medium *here = nullptr, *beyond = nullptr;  ///< media on the viewer's side and behind; null: air
  bool forLampsOnly = false;  ///< beyond the cut-off: followed because a lamp may be at the end of it
  double luminance = 0;       ///< emitted, cd/m2
  std::uint32_t spectrum = 0, emitter = scene::none;  ///< of the emission
  std::size_t firstArrival = 0, arrivals = 0;
};

struct IntersectionTree {
  std::vector<TreeNode> nodes;  ///< parents before their children
  std::vector<Arrival> arrivals;
  double discarded = 0;  ///< cd/m2: the bounds of the nodes that were left out, times what they could have shown
  std::int32_t deepest = 0;
  std::uint64_t rays = 0;

  void clear() {
    nodes.clear();
    arrivals.clear();
    discarded = 0, deepest = 0, rays = 0;
  }
};

/// Depth control (docs/methods/tree.md).
struct TreeControl {
  int maxDepth = 15;
  double cutoff = 0.001;
  bool adaptive = true;  ///< false: every hit but a lamp spawns rays, up to the greatest depth
};

/// Luminances that a cut-off is measured by, cd/m2.
struct LuminanceScale {
  double white = 1;  ///< of a white surface under the mean direct illuminance
  double matt = 1;   ///< hardly any matt surface is brighter
  double lamp = 1;   ///< of the brightest emitter that a ray can hit
};
/// Found with a few thousand points of the world's surfaces, the same in every run.
LuminanceScale luminanceScale(const scene::World& world);

using Shadings = std::vector<std::unique_ptr<reflection::LocalShading>>;

class TreeBuilder {
 public:
  /// `nodes`: of the quadrature; `hero`: the one whose index refracted rays follow. All must outlive the builder.
  TreeBuilder(const scene::World& world, const tracer::Tracer& tracer, const Shadings& shadings, std::size_t nodes,
              std::size_t hero, const TreeControl& control, const LuminanceScale& scale)
      : world_(world),
        tracer_(tracer),
        shadings_(shadings),
        count_(nodes),
        hero_(hero),
        control_(control),
        scale_(scale) {}

  /// The tree of a ray; `random` chooses points on luminous openings.
  void build(const core::Vec3& origin, const core::Vec3& direction, core::Sampler& random,
             IntersectionTree& tree) const;
  /// The share of light that comes from `target`: panes filter it, everything else blocks it. Counts rays.
  [[nodiscard]] double seen(const scene::LightSource& source, core::Vec3 origin, const core::Vec3& target,
                            std::uint64_t& rays) const;

 private:
  /// A ray that waits to be traced.
  struct Pending {
    std::int32_t parent;
    bool transmitted;
    std::int32_t depth;
    core::Vec3 origin, direction;
    Media media;
    double bound;
    bool forLampsOnly;
  };

  void grow(const Pending& ray, core::Sampler& random, IntersectionTree& tree, std::vector<Pending>& waiting) const;
  void findArrivals(TreeNode& node, const core::Vec3& point, const core::Vec3& normal, const core::Frame& frame,
                    core::Sampler& random, IntersectionTree& tree) const;
  void spawn(const Pending& child, double factor, bool lamp, IntersectionTree& tree,
             std::vector<Pending>& waiting) const;

  const scene::World& world_;
  const tracer::Tracer& tracer_;
  const Shadings& shadings_;
  std::size_t count_, hero_;
  TreeControl control_;
  LuminanceScale scale_;
};

/// What lights the nodes of a tree when it is evaluated.
struct TreeLighting {
  std::vector<double> dimming;                           ///< per emitter, times what was traced; empty: 1
  std::vector<std::vector<spectrum::Response>> weights;  ///< [source spectrum][node]
  std::vector<double> ambient;                           ///< I_a at the nodes, cd/m2; empty: none
  std::vector<double> ambientShare;                      ///< of I_a, by source spectrum
};

/// The intensity at the eye, bottom-up: every node by its reflection model from its sources, the ambient term and its
/// children. cd/m2 (X, Y, Z, melanopic).
Response evaluate(const IntersectionTree& tree, const Shadings& shadings, const TreeLighting& lighting,
                  const scene::World& world);

}  // namespace goniolux::solver
