// Texture: how the finishes of a surface are mixed from place to place; Relief: how high it is.
#pragma once

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "texture/mixture.h"
#include "texture/pattern.h"

namespace goniolux::texture {

class Texture {
 public:
  explicit Texture(const Projection& projection) : projection_(projection) {}
  virtual ~Texture() = default;
  [[nodiscard]] Mixture at(const SurfacePlace& place) const { return mix(projection_.at(place)); }
  /// Mean share of each component over a whole repeat.
  [[nodiscard]] virtual std::vector<double> meanShares() const = 0;

 protected:
  [[nodiscard]] virtual Mixture mix(const Place& place) const = 0;

 private:
  Projection projection_;
};

/// Two finishes: component 0 where the pattern is 0, component 1 where it is 1.
class PatternTexture final : public Texture {
 public:
  PatternTexture(const Projection& projection, std::shared_ptr<const Pattern> pattern)
      : Texture(projection), pattern_(std::move(pattern)) {}
  [[nodiscard]] std::vector<double> meanShares() const override { return {1 - pattern_->mean(), pattern_->mean()}; }

 protected:
  [[nodiscard]] Mixture mix(const Place& place) const override;

 private:
  std::shared_ptr<const Pattern> pattern_;
};

/// Heights for a normal that leans: `depth` m from the pattern's 0 to its 1.
struct Relief {
  Projection projection;
  std::shared_ptr<const Pattern> pattern;
  double depth = 0;

  [[nodiscard]] double heightAt(const SurfacePlace& place) const { return depth * pattern->at(projection.at(place)); }
  /// m, where the projection is by box; for its own coordinates the surface's extent comes in.
  [[nodiscard]] double step() const { return pattern->step() * std::min(projection.size.x, projection.size.y); }
};

}  // namespace goniolux::texture
