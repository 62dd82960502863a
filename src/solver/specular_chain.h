// A specular chain: the mirrors and smooth interfaces that a ray of light meets one after another.
//
// Followed by the tracer once, a chain is then a smooth function of the ray that starts it: every step is taken on the
// plane or quadric itself, in double precision and beyond the edges of the part that was hit, so that derivatives and
// Newton's method have something to hold on to. Whether the real ray goes that way is for the tracer to confirm.
// World frame of scene::World, metres.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "reflection/bsdf.h"
#include "scene/world.h"
#include "solver/media.h"
#include "tracer/tracer.h"

namespace goniolux::solver {

struct SpecularStep {
  enum class Kind : std::uint8_t { reflected, refracted, straight };
  Kind kind = Kind::reflected;
  bool isInterface = false;                                     ///< between two media: Fresnel's equations hold
  std::uint32_t patch = scene::none;                            ///< index into World::patches; none: a plane
  std::uint32_t surface = scene::none, material = scene::none;  ///< indices into the world's
  core::Vec3 point{0}, normal{0, 0, 1};                         ///< where it was met; of a plane, its normal
  const reflection::Medium *here = nullptr, *beyond = nullptr;  ///< where the light comes from, and the other side

  /// What the light is in after the step; null: air.
  [[nodiscard]] const reflection::Medium* after() const { return kind == Kind::refracted ? beyond : here; }
};

/// Where a chain's last step is taken, and how the light goes on from there.
struct ChainEnd {
  core::Vec3 origin{0}, direction{0, 0, 1};
};

class SpecularChains {
 public:
  using Bsdfs = std::vector<std::unique_ptr<reflection::Bsdf>>;
  /// All of them must outlive this. `nodes`: spectral samples.
  SpecularChains(const scene::World& world, const tracer::Tracer& tracer, const Bsdfs& bsdfs, std::size_t nodes)
      : world_(world), tracer_(tracer), bsdfs_(bsdfs), nodes_(nodes) {}

  /// A surface on the way: what lies on its two sides, and what it is.
  struct Encounter {
    tracer::Hit hit;
    bool fromInside = false, isSpecular = false;
    double distance = 0;  ///< from the start of the ray, m
    const reflection::Medium *here = nullptr, *beyond = nullptr;
    Media media;  ///< before it
  };
  /// The next surface that does something to light; interfaces within other bodies are passed. False: none.
  bool meet(core::Vec3 origin, const core::Vec3& direction, Media media, Encounter& met, std::uint64_t& rays) const;
  [[nodiscard]] SpecularStep stepAt(const Encounter& met, SpecularStep::Kind kind) const;
  /// Where the ray goes on after a step; false: the refracted ray is totally reflected. `node`: whose index holds.
  static bool bend(const SpecularStep& step, const core::Vec3& normal, std::size_t node, core::Vec3& direction);
  /// A thin pane, that light also goes straight through.
  [[nodiscard]] bool isPane(const Encounter& met) const;
  [[nodiscard]] core::Vec3 leave(const core::Vec3& point, const core::Vec3& side) const {
    return tracer_.leave(point, side);
  }
  /// The media after a step.
  [[nodiscard]] Media mediaAfter(const Encounter& met, SpecularStep::Kind kind) const;

  /// Takes a ray along a chain. False: it misses a step, or is totally reflected.
  bool run(std::span<const SpecularStep> steps, core::Vec3 origin, core::Vec3 direction, std::size_t node,
           ChainEnd& end) const;
  /// The same, with the factors of the steps and of absorption on the way, [nodes], multiplied into `filter`.
  bool run(std::span<const SpecularStep> steps, core::Vec3 origin, core::Vec3 direction, std::size_t node,
           ChainEnd& end, float* filter) const;
  /// Factors of one step at a cosine, multiplied into `filter`.
  void applyStep(const SpecularStep& step, double cosine, float* filter) const;
  void absorb(const reflection::Medium* medium, double distance, float* filter) const;
  /// True when a real ray takes these very steps and then reaches `target` unhindered.
  bool confirm(std::span<const SpecularStep> steps, core::Vec3 origin, core::Vec3 direction, std::size_t node,
               const core::Vec3& target, std::uint64_t& rays) const;

 private:
  bool advance(const SpecularStep& step, core::Vec3& origin, core::Vec3& direction, std::size_t node, double& length,
               double& cosine) const;

  const scene::World& world_;
  const tracer::Tracer& tracer_;
  const Bsdfs& bsdfs_;
  std::size_t nodes_;
};

}  // namespace goniolux::solver
