#include "solver/light_solution.h"

#include <algorithm>
#include <cmath>

#include "core/random.h"

namespace goniolux::solver {

using core::Vec3;

namespace {

// The lattice is shifted by an odd part of its step, so that surfaces at round coordinates do not lie on cell walls.
constexpr double shift = 0.3819660112501051;
constexpr int mostSweeps = 2000;

// Which of the six ways along the axes a normal points.
std::uint64_t facing(const Vec3& n) {
  const Vec3 a = glm::abs(n);
  const int axis = a.x >= a.y && a.x >= a.z ? 0 : a.y >= a.z ? 1 : 2;
  return static_cast<std::uint64_t>(2 * axis + (n[axis] < 0 ? 1 : 0));
}

}  // namespace

LightSolution::LightSolution(double cellSize, std::size_t sources, std::size_t stride)
    : cellSize_(cellSize), sources_(sources), stride_(stride), slotKeys_(1024, 0), slotCells_(1024, none) {}

std::uint64_t LightSolution::keyOf(std::uint32_t surface, const Vec3& position, const Vec3& normal) const {
  // Twenty bits an axis: a million cells, then it wraps; cells so far apart do not meet in one scene.
  const auto step = [&](double x) {
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(x / cellSize_ + shift))) & 0xfffffu;
  };
  const std::uint64_t place = step(position.x) << 40 | step(position.y) << 20 | step(position.z);
  const std::uint64_t key = core::mix(place ^ core::mix((static_cast<std::uint64_t>(surface) << 3) | facing(normal)));
  return key | 1;  // 0 marks a free slot
}

std::size_t LightSolution::slotOf(std::uint64_t key) const {
  const std::size_t mask = slotKeys_.size() - 1;
  std::size_t slot = (key >> 1) & mask;
  while (slotKeys_[slot] != 0 && slotKeys_[slot] != key) slot = (slot + 1) & mask;
  return slot;
}

std::uint32_t LightSolution::find(std::uint32_t surface, const Vec3& position, const Vec3& normal) const {
  return slotCells_[slotOf(keyOf(surface, position, normal))];
}

void LightSolution::grow() {
  std::vector<std::uint64_t> keys(slotKeys_.size() * 2, 0);
  std::vector<std::uint32_t> cells(slotKeys_.size() * 2, none);
  keys.swap(slotKeys_);
  cells.swap(slotCells_);
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (keys[i] == 0) continue;
    const std::size_t slot = slotOf(keys[i]);
    slotKeys_[slot] = keys[i];
    slotCells_[slot] = cells[i];
  }
}

std::uint32_t LightSolution::add(std::uint32_t surface, const Vec3& position, const Vec3& normal) {
  const std::uint64_t key = keyOf(surface, position, normal);
  std::size_t slot = slotOf(key);
  if (slotKeys_[slot] == 0) {
    if (2 * (surface_.size() + 1) > slotKeys_.size()) {
      grow();
      slot = slotOf(key);
    }
    slotKeys_[slot] = key;
    slotCells_[slot] = static_cast<std::uint32_t>(surface_.size());
    surface_.push_back(surface);
    pointCount_.push_back(0);
    rough_.push_back(0);
    points_.resize(points_.size() + pointsPerCell);
  }
  const std::uint32_t cell = slotCells_[slot];
  if (pointCount_[cell] < pointsPerCell) points_[cell * pointsPerCell + pointCount_[cell]++] = {position, normal};
  return cell;
}

int LightSolution::solve(const Transport& transport, double tolerance) {
  const std::size_t cells = surface_.size(), row = sources_ * stride_;
  radiance_.assign(cells * row, 0.0f);
  const float overPi = static_cast<float>(1 / core::pi);
  // Cosine-distributed links: irradiance = pi * mean of the radiances that they bring.
  const float perLink =
      transport.linksPerCell > 0 ? static_cast<float>(core::pi / static_cast<double>(transport.linksPerCell)) : 0.0f;
  float largest = 0;
  for (const float e : transport.direct) largest = std::max(largest, e);
  std::vector<float> arrived(row);
  for (int sweep = 1; sweep <= mostSweeps; ++sweep) {
    float change = 0;
    for (std::size_t c = 0; c < cells; ++c) {
      std::fill(arrived.begin(), arrived.end(), 0.0f);
      for (std::size_t l = 0; l < transport.linksPerCell; ++l) {
        const Link& link = transport.links[c * transport.linksPerCell + l];
        if (link.cell == none) continue;
        const float* from = radiance_.data() + link.cell * row;
        if (link.filter == none) {
          for (std::size_t k = 0; k < row; ++k) arrived[k] += from[k];
        } else {
          const float* filter = transport.filters.data() + link.filter * stride_;
          for (std::size_t s = 0; s < sources_; ++s)
            for (std::size_t k = 0; k < stride_; ++k) arrived[s * stride_ + k] += from[s * stride_ + k] * filter[k];
        }
      }
      float* own = radiance_.data() + c * row;
      const float* direct = transport.direct.data() + c * row;
      const float* reflectance = transport.reflectance.data() + c * stride_;
      for (std::size_t s = 0; s < sources_; ++s)
        for (std::size_t k = 0; k < stride_; ++k) {
          const std::size_t i = s * stride_ + k;
          const float value = reflectance[k] * overPi * (direct[i] + perLink * arrived[i]);
          change = std::max(change, std::abs(value - own[i]));
          own[i] = value;
        }
    }
    if (change > static_cast<float>(tolerance) * largest * overPi && sweep < mostSweeps) continue;
    interreflected_ = radiance_;
    for (std::size_t c = 0; c < cells; ++c)
      for (std::size_t i = 0; i < row; ++i)
        interreflected_[c * row + i] -=
            transport.reflectance[c * stride_ + i % stride_] * overPi * transport.direct[c * row + i];
    return sweep;
  }
  return mostSweeps;
}

}  // namespace goniolux::solver
