// Mixture: of which finishes a place of a textured surface is made.
#pragma once

#include <array>
#include <cstdint>

namespace goniolux::texture {

/// Shares of a material's components (material::Material::components); they add up to 1.
struct Mixture {
  static constexpr std::size_t most = 8;
  std::uint32_t count = 0;
  std::array<std::uint32_t, most> component;
  std::array<float, most> share;

  void add(std::uint32_t which, double weight) {
    component[count] = which;
    share[count++] = static_cast<float>(weight);
  }
};

}  // namespace goniolux::texture
