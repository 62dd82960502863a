#include "solver/place_index.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace goniolux::solver {

using core::Vec3;

PlaceIndex::PlaceIndex(const geometry::Bounds& box, int cells) : box_(box) {
  const Vec3 extent = box.extent();
  size_ = std::max({extent.x, extent.y, extent.z, 1e-9}) / cells;
  for (int axis = 0; axis < 3; ++axis)
    count_[static_cast<std::size_t>(axis)] = static_cast<int>(std::floor(extent[axis] / size_)) + 1;
  last_.assign(
      static_cast<std::size_t>(count_[0]) * static_cast<std::size_t>(count_[1]) * static_cast<std::size_t>(count_[2]),
      std::numeric_limits<std::uint32_t>::max());
}

void PlaceIndex::add(std::uint32_t thing, const geometry::Bounds& box) {
  std::array<int, 3> low{}, high{};
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    const double from = (box.min[axis] - box_.min[axis]) / size_, to = (box.max[axis] - box_.min[axis]) / size_;
    if (!(to >= 0) || !(from < count_[a])) return;
    low[a] = static_cast<int>(std::max(0.0, from));
    high[a] = static_cast<int>(std::min(to, count_[a] - 1.0));
  }
  for (int z = low[2]; z <= high[2]; ++z)
    for (int y = low[1]; y <= high[1]; ++y)
      for (int x = low[0]; x <= high[0]; ++x) {
        const auto cube = static_cast<std::uint32_t>((z * count_[1] + y) * count_[0] + x);
        if (last_[cube] == thing) continue;
        last_[cube] = thing;
        pairs_.emplace_back(cube, thing);
      }
}

void PlaceIndex::finish() {
  first_.assign(last_.size() + 1, 0);
  for (const auto& [cube, thing] : pairs_) ++first_[cube + 1];
  for (std::size_t i = 0; i < last_.size(); ++i) first_[i + 1] += first_[i];
  things_.resize(pairs_.size());
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for (const auto& [cube, thing] : pairs_) things_[next[cube]++] = thing;
  last_ = {};
  pairs_ = {};
}

std::span<const std::uint32_t> PlaceIndex::at(const Vec3& place) const {
  std::array<int, 3> cube{};
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    const double at = (place[axis] - box_.min[axis]) / size_;
    if (!(at >= 0 && at < count_[a])) return {};
    cube[a] = static_cast<int>(at);
  }
  const auto i = static_cast<std::size_t>((cube[2] * count_[1] + cube[1]) * count_[0] + cube[0]);
  return {things_.data() + first_[i], things_.data() + first_[i + 1]};
}

}  // namespace goniolux::solver
