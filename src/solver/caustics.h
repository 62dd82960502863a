// Caustics: the light of small luminaires that comes to a place by curved mirrors, and through solid glass and water.
//
// No path can meet a point, few meet a small lamp, and no straight connection leads to it by a curved mirror. But the
// light of a point is a function of two numbers, its direction; so rays are sent out over all directions once (beams),
// each with the chain of mirrors and interfaces that it meets and with its derivatives. A place is lit by the
// directions whose rays pass through it: the beams near by say where to look, Newton's method on the chain finds the
// direction to rounding, a traced ray confirms it. The illuminance is then exact, I(w) F / |dA/dw|: no noise, and no
// area to average over. (J. Hanika et al., "Manifold next event estimation", CGF 34(4), 2015, and T. Zeltner et al.,
// "Specular manifold sampling", ACM TOG 39(4), 2020, solve for the same chains from the other side; beams after P.
// Heckbert and P. Hanrahan, SIGGRAPH 1984, and M. Watt, SIGGRAPH 1990.) A lamp that is small, and not a point, is a few
// elements: for each of them the place that a direction leaves from is a function of that direction.
//
// What may be missed is a direction whose part of the sky is smaller than the beams are apart; what only one beam leads
// to is a measure of it (Good and Turing). World frame of scene::World, metres.
#pragma once

#include <cstdint>
#include <limits>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "core/vector.h"
#include "scene/world.h"
#include "solver/light_list.h"
#include "solver/place_index.h"
#include "solver/specular_chain.h"

namespace goniolux::solver {

class Caustics {
 public:
  /// Everything must outlive this. `hero`: the node whose refractive indices the beams follow. `accuracy`: relative,
  /// asked of the results.
  Caustics(const scene::World& world, const tracer::Tracer& tracer, const SpecularChains::Bsdfs& bsdfs,
           const LightList& lights, std::size_t nodes, std::size_t hero, double accuracy);

  /// No light goes such ways here.
  [[nodiscard]] bool empty() const { return beams_.empty(); }
  [[nodiscard]] std::size_t beamCount() const { return beams_.size(); }
  /// Solid glass or water whose index is not the same at all nodes is among what the beams meet: each node has ways of
  /// its own.
  [[nodiscard]] bool disperses() const { return disperses_; }

  /// Light that arrives from one direction.
  struct Arrival {
    std::uint32_t source = 0;       ///< index into World::emitters
    std::uint32_t element = 0;      ///< which of its elements
    core::Vec3 direction{0, 0, 1};  ///< unit, towards where it comes from
    double normalIlluminance = 0;   ///< lx on a plane that faces it, if nothing on the way took any of it
    bool isLone = false;            ///< only one beam leads to it
    core::Vec3 start{0};            ///< its direction at the luminaire
    std::uint32_t beam = 0;
    double distance = 0;  ///< from the last step of the chain, m
  };
  /// All of it at a place, by rays of this node's wavelength. `draw` < 0: from every element of the sources; else, in
  /// [0, 1), from one that is drawn with it and stands for its source.
  void arrivals(const core::Vec3& place, std::size_t node, double draw, std::vector<Arrival>& found,
                std::uint64_t& rays) const;
  /// True when a source's light is found here, and paths need not meet it.
  [[nodiscard]] bool serves(std::uint32_t source) const { return isServed_[source]; }
  struct Source {
    std::uint32_t emitter, first, count;  ///< its elements, in a row
  };
  [[nodiscard]] const std::vector<Source>& sources() const { return sources_; }
  [[nodiscard]] std::size_t elementCount() const { return elements_.size(); }
  /// The most illuminance that is worth counting where the light is to be reflected on, lx: at its edges a caustic is
  /// infinitely bright, and what exceeds this is less of all light than a small share of the accuracy asked for.
  [[nodiscard]] double brightest() const { return brightest_; }
  /// What is left on the way, multiplied into filter[nodes].
  void applyFilter(const Arrival& arrival, std::size_t node, float* filter) const;

  /// What is not followed, as sentences; empty: nothing.
  [[nodiscard]] std::vector<std::string> leftOut() const;

 private:
  struct Beam {
    std::uint32_t element = 0, kind = 0, firstStep = 0, steps = 0;
    core::Vec3 start{0, 0, 1};             ///< direction at the luminaire
    core::Vec3 origin{0}, along{0, 0, 1};  ///< after the last step
    core::Vec3 originBy[2], alongBy[2];    ///< derivatives by the start, along its perpendiculars
    double reach = 0;                      ///< m, to what it meets next
    double spacing = 0;                    ///< rad, to the next beams
  };
  struct Pending;

  /// A place of a source, with its share of the light: of a point all of it.
  struct Element {
    std::uint32_t source, of;  ///< indices into World::emitters and sources_
    core::Vec3 center;
    core::Vec2 place;  ///< which place, as Emitter::sample() chooses it
    double share, far;
  };
  /// A ray as it leaves an element.
  struct Ray {
    core::Vec3 origin;
    double candela;
  };
  [[nodiscard]] Ray leave(const Element& element, const core::Vec3& direction) const;
  /// `onlyUnseen`: not what paths can meet.
  void addElements(std::uint32_t source, bool onlyUnseen);
  [[nodiscard]] std::size_t directionsOfEach() const;
  [[nodiscard]] bool resolvesFacets() const;
  void sendOut(std::uint32_t element, std::size_t directions, std::uint64_t& rays);
  void follow(std::uint32_t element, const core::Vec3& start, double spacing, std::uint64_t& rays);
  bool addBeam(std::uint32_t element, const core::Vec3& start, double spacing, const std::vector<SpecularStep>& steps,
               double reach);
  /// A beam's light where it comes to a surface that scatters it.
  void land(const Beam& beam, double flux);
  void index();
  void limitBrightness(double accuracy);
  [[nodiscard]] std::span<const SpecularStep> stepsOf(const Beam& beam) const {
    return {steps_.data() + beam.firstStep, beam.steps};
  }
  [[nodiscard]] std::uint32_t kindOf(std::uint32_t element, const std::vector<SpecularStep>& steps);
  enum class Sharpness { rough, sharp };  ///< one-sided or central differences
  /// Derivatives of a chain's end by the direction of its start. False: it is at the edge of what the chain can do.
  bool differentiate(std::uint32_t element, std::span<const SpecularStep> steps, const core::Vec3& start,
                     std::size_t node, Sharpness sharpness, ChainEnd& end, core::Vec3 (&originBy)[2],
                     core::Vec3 (&alongBy)[2]) const;
  struct Solution {
    core::Vec3 start{0};
    ChainEnd end;
    double area = 0;  ///< across the ray at the place, m2/sr
  };
  /// Finds the start whose ray passes through a place, by a beam's chain and from `start` on.
  bool aim(const Beam& beam, const core::Vec3& place, std::size_t node, core::Vec3 start, Solution& found) const;

  const scene::World& world_;
  const LightList& lights_;
  SpecularChains chains_;
  std::size_t nodes_, hero_;
  bool disperses_ = false;
  double margin_ = 0;  ///< of the spacing: how far from a beam its chain is tried
  std::vector<geometry::Bounds> targets_;
  std::size_t mostFacets_ = 0;  ///< triangles of one target
  std::vector<Source> sources_;
  std::vector<Element> elements_;
  std::vector<bool> isServed_;  ///< of World::emitters
  std::vector<SpecularStep> steps_;
  std::vector<Beam> beams_;
  std::map<std::vector<std::uint32_t>, std::uint32_t> kinds_;
  PlaceIndex places_;
  std::vector<std::uint32_t> wide_;  ///< beams that may be anywhere
  double dropped_ = 0, sent_ = 0;    ///< flux of chains that were cut short; of all beams' directions, lm
  struct Landing {
    double flux, illuminance;  ///< lm, lx
  };
  std::vector<Landing> landings_;
  double brightest_ = std::numeric_limits<double>::infinity();
};

}  // namespace goniolux::solver
