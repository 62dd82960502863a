// PlaceIndex: which of many things may lie at a place: a lattice of cubes with the things whose boxes touch them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/vector.h"
#include "geometry/bounds.h"

namespace goniolux::solver {

class PlaceIndex {
 public:
  PlaceIndex() = default;
  /// A lattice over `box` with `cells` cubes along its longest side.
  PlaceIndex(const geometry::Bounds& box, int cells);

  [[nodiscard]] double cellSize() const { return size_; }
  /// All boxes of one thing in a row.
  void add(std::uint32_t thing, const geometry::Bounds& box);
  /// After the last add().
  void finish();
  /// The things about a place, each once; none outside the lattice.
  [[nodiscard]] std::span<const std::uint32_t> at(const core::Vec3& place) const;

 private:
  geometry::Bounds box_{};
  double size_ = 1;
  std::array<int, 3> count_{1, 1, 1};
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs_;  // cube, thing
  std::vector<std::uint32_t> last_;                             // of each cube, while things are added
  std::vector<std::uint32_t> first_, things_;
};

}  // namespace goniolux::solver
