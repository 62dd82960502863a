// Value noise: random numbers on a lattice, joined smoothly, at several scales (K. Perlin, "An image synthesizer",
// SIGGRAPH 1985, with values instead of gradients). By symmetry its mean is one half.
#include <cmath>
#include <cstdint>

#include "core/random.h"
#include "texture/patterns.h"

namespace goniolux::texture {
namespace {

using core::Vec3;

core::Parameter detail() {
  return number("detail", "Detail", 1, 10, "4", "scales, each half as large as the one before; default 4");
}
core::Parameter contrast() {
  return number("contrast", "Contrast", 0, 10, "2", "1 = as the sum of random numbers comes; default 2");
}

double latticeValue(std::int64_t x, std::int64_t y, std::int64_t z, std::uint64_t scale) {
  std::uint64_t key = core::combine(0x7e27, scale);
  for (const std::int64_t c : {x, y, z}) key = core::combine(key, static_cast<std::uint64_t>(c));
  return static_cast<double>(key >> 11) * 0x1p-53;
}

double smooth(double t) {
  return t * t * t * (t * (6 * t - 15) + 10);
}

double valueNoise(const Vec3& p, std::uint64_t scale) {
  const Vec3 base = glm::floor(p), t = p - base;
  const double u = smooth(t.x), v = smooth(t.y), w = smooth(t.z);
  double sum = 0;
  for (int k = 0; k < 8; ++k) {
    const int i = k & 1, j = k >> 1 & 1, l = k >> 2;
    sum += (i ? u : 1 - u) * (j ? v : 1 - v) * (l ? w : 1 - w) *
           latticeValue(static_cast<std::int64_t>(base.x) + i, static_cast<std::int64_t>(base.y) + j,
                        static_cast<std::int64_t>(base.z) + l, scale);
  }
  return sum;
}

class Noise final : public Pattern {
 public:
  Noise(int detail, double contrast) : detail_(detail), contrast_(contrast) {}
  [[nodiscard]] double at(const Place& place) const override {
    double sum = 0, whole = 0, weight = 1;
    Vec3 p = place.solid;
    for (int k = 0; k < detail_; ++k, weight *= 0.5, p *= 2.0) {
      sum += weight * (valueNoise(p, static_cast<std::uint64_t>(k)) - 0.5);
      whole += weight;
    }
    return 0.5 + 0.5 * std::tanh(2 * contrast_ * sum / whole);
  }
  [[nodiscard]] double mean() const override { return 0.5; }
  [[nodiscard]] double step() const override { return 0.05 * std::ldexp(1.0, -detail_); }

 private:
  int detail_;
  double contrast_;
};

}  // namespace

PatternType noisePattern() {
  PatternType type;
  type.name = "noise";
  type.title = "Cloudy noise: stone, plaster, worn surfaces";
  type.parameters = {detail(), contrast()};
  type.make = [](const core::Arguments& arguments) -> std::shared_ptr<const Pattern> {
    return std::make_shared<Noise>(static_cast<int>(valueOf(arguments, detail())), valueOf(arguments, contrast()));
  };
  return type;
}

}  // namespace goniolux::texture
