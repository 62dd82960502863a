// BrightSpots: small bright places of matt surfaces (the pool of a narrow spotlight, the batten beside its tube), as
// secondary sources that the points of a path are connected to.
//
// A cosine-distributed direction meets a spot of 8 cm on a ceiling 4.5 m away once in ten thousand times. So points are
// also connected to places of the spots, as they are to lights, for the direct light that is reflected there. Both ways
// find that light, and share it by the densities with which each chooses a direction (balance heuristic, E. Veach
// 1997): the expectation stays what it was, wherever the spots are and however roughly they were found. World frame of
// scene::World, metres.
//
// Spots are rectangles. They are found by light sent out from the emitters: what lands on a surface is halved until few
// arrivals are left in each part, and parts that are much brighter than the scene's surfaces on average are kept.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/vector.h"

namespace goniolux::solver {

/// Light that has come from an emitter to a matt surface.
struct LandedLight {
  core::Vec3 position{0}, normal{0, 0, 1};  ///< normal: unit, on the lit side
  std::uint32_t surface = 0;
  double reflected = 0;  ///< flux that goes on from there, lm
};

class BrightSpots {
 public:
  /// How finely spots are cut.
  struct Detail {
    std::size_t fewest;   ///< arrivals in a part
    double brighter;      ///< than the mean of all surfaces: what is kept
    double worthParting;  ///< gain in concentration that a cut must bring
  };
  static const Detail coarse;  ///< to find out whether there are any, with a few thousand arrivals
  static const Detail fine;    ///< for ten times as many

  BrightSpots() = default;
  /// `area`: of all surfaces, m2.
  BrightSpots(std::vector<LandedLight> landed, double area, const Detail& detail = coarse);

  [[nodiscard]] bool empty() const { return spots_.empty(); }
  [[nodiscard]] std::size_t size() const { return spots_.size(); }
  /// Share of a path's points that are worth connecting.
  [[nodiscard]] double share() const { return share_; }

  /// A choice of directions for one point of a matt surface.
  struct Choice {
    core::Vec3 origin{0}, normal{0, 0, 1};
    double total = 0;  ///< sum of the spots' importance; 0: none can be seen
  };
  [[nodiscard]] Choice from(const core::Vec3& origin, const core::Vec3& normal) const;
  /// A direction towards a spot, chosen by u and a place of it; `surface` is what it means to meet. False where that
  /// would be below the surface's horizon.
  bool direction(const Choice& choice, double u, const core::Vec2& place, core::Vec3& direction,
                 std::uint32_t& surface) const;
  /// The density per sr with which direction() chooses a direction that meets `surface`.
  [[nodiscard]] double density(const Choice& choice, const core::Vec3& direction, std::uint32_t surface) const;

 private:
  struct Spot {
    core::Vec3 center{0}, normal{0, 0, 1};
    core::Vec3 halfU{0}, halfV{0};
    double area = 0, radius = 0, reflected = 0;
    std::uint32_t surface = 0;
    /// What it adds to the variance of directions that are chosen regardless of it.
    [[nodiscard]] double spread() const { return reflected * reflected / area; }
  };
  [[nodiscard]] static Spot around(const LandedLight* first, std::size_t count);
  /// The parts that light on one surface is best cut into; none of fewer than `fewest` arrivals.
  static std::vector<Spot> partsOf(LandedLight* first, std::size_t count, std::size_t fewest, double worthParting);
  [[nodiscard]] static double importance(const Spot& spot, const core::Vec3& origin, const core::Vec3& normal);

  std::vector<Spot> spots_;  ///< by surface
  double share_ = 0;
};

}  // namespace goniolux::solver
