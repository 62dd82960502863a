// LightSolution: the view-independent light of a scene: the radiance that diffuse surfaces reflect, kept in cells.
//
// A cell is what lies of one surface in one cube of a lattice, facing one of six ways; it needs no mesh, so triangles,
// exact quadrics and any number of small parts are served alike. Its light is the mean over a few of its points. Light
// goes from cell to cell along rays that were traced once (the links); solving is then a matter of arithmetic, so other
// spectra or dimming levels need no ray. World frame of scene::World.
//
// The solution is an approximation: who uses it adds the remainder or states it (docs/methods/light-solution.md).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/vector.h"
#include "scene/world.h"
#include "spectrum/spectral_quadrature.h"

namespace goniolux::solver {

class LightSolution {
 public:
  static constexpr std::uint32_t none = scene::none;
  /// Points that stand for a cell.
  static constexpr std::size_t pointsPerCell = 4;

  struct Point {
    core::Vec3 position{0}, normal{0, 0, 1};  ///< normal: unit, on the side that the cell faces
  };
  /// Light that comes to a cell from another, by way of mirrors whose reflectance is filters[filter].
  struct Link {
    std::uint32_t cell = none;    ///< none: nothing comes this way
    std::uint32_t filter = none;  ///< none: nothing between
  };

  /// `cellSize` in m; spectral blocks have `stride` values for each of `sources` source spectra.
  LightSolution(double cellSize, std::size_t sources, std::size_t stride);

  [[nodiscard]] double cellSize() const { return cellSize_; }
  [[nodiscard]] std::size_t cellCount() const { return surface_.size(); }
  [[nodiscard]] std::uint32_t surfaceOf(std::uint32_t cell) const { return surface_[cell]; }
  [[nodiscard]] std::span<const Point> pointsOf(std::uint32_t cell) const {
    return {points_.data() + cell * pointsPerCell, pointCount_[cell]};
  }

  /// The cell that holds a point of a surface, or none.
  [[nodiscard]] std::uint32_t find(std::uint32_t surface, const core::Vec3& position, const core::Vec3& normal) const;
  /// The same, made when it is not there yet; the point becomes one of those that stand for it while there is room.
  std::uint32_t add(std::uint32_t surface, const core::Vec3& position, const core::Vec3& normal);

  /// What the solution starts from, for every cell in order: `direct` irradiance [cell][source][stride] per unit of
  /// source spectrum (lx), `reflectance` [cell][stride], `links` [cell][linksPerCell] of equal weight, and `filters`
  /// [filter][stride].
  struct Transport {
    std::vector<float> direct, reflectance;
    std::size_t linksPerCell = 0;
    std::vector<Link> links;
    std::vector<float> filters;
  };
  /// Solves for the reflected radiance by Gauss-Seidel sweeps until the largest change is below `tolerance` of the
  /// largest irradiance; returns the sweeps.
  int solve(const Transport& transport, double tolerance);

  /// Reflected radiance [stride] of a cell for a source spectrum, in cd/m2 per unit of that spectrum's weights.
  [[nodiscard]] const float* radiance(std::uint32_t cell, std::size_t source) const {
    return radiance_.data() + (cell * sources_ + source) * stride_;
  }
  /// The part of it that has come to the cell by reflection.
  [[nodiscard]] const float* interreflected(std::uint32_t cell, std::size_t source) const {
    return interreflected_.data() + (cell * sources_ + source) * stride_;
  }
  [[nodiscard]] std::size_t sources() const { return sources_; }
  /// The same two as X, Y, Z and melanopic; filled by setResponses().
  [[nodiscard]] const spectrum::Response& response(std::uint32_t cell) const { return responses_[cell]; }
  [[nodiscard]] const spectrum::Response& interreflectedResponse(std::uint32_t cell) const {
    return interreflectedResponses_[cell];
  }
  void setResponses(std::vector<spectrum::Response> all, std::vector<spectrum::Response> interreflected) {
    responses_ = std::move(all);
    interreflectedResponses_ = std::move(interreflected);
  }

  /// Cells whose direct light changes so much within them that its mean must not stand for a point: they answer for
  /// what is interreflected only.
  [[nodiscard]] bool isRough(std::uint32_t cell) const { return rough_[cell] != 0; }
  void setRough(std::uint32_t cell) { rough_[cell] = 1; }

 private:
  [[nodiscard]] std::uint64_t keyOf(std::uint32_t surface, const core::Vec3& position, const core::Vec3& normal) const;
  [[nodiscard]] std::size_t slotOf(std::uint64_t key) const;
  void grow();

  double cellSize_;
  std::size_t sources_, stride_;
  std::vector<std::uint64_t> slotKeys_;   // open addressing; 0: free
  std::vector<std::uint32_t> slotCells_;  // beside slotKeys_
  std::vector<std::uint32_t> surface_;
  std::vector<Point> points_;
  std::vector<std::uint8_t> pointCount_, rough_;
  std::vector<float> radiance_, interreflected_;
  std::vector<spectrum::Response> responses_, interreflectedResponses_;
};

}  // namespace goniolux::solver
