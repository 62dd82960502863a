// Tiles with joints along two of their edges, one tile a repeat; brickwork where rows are staggered.
#include <cmath>

#include "texture/patterns.h"

namespace goniolux::texture {
namespace {

core::Parameter joint() {
  return number("joint", "Joint", 0, 1, "0.03", "width of the joints (1), as a share of the repeat; default 0.03");
}
core::Parameter stagger() {
  return number("stagger", "Stagger", 0, 1, "0", "shift from row to row in repeats: 0.5 = brickwork; default 0");
}

class Tiles final : public Pattern {
 public:
  Tiles(double joint, double stagger) : joint_(joint), stagger_(stagger) {}
  [[nodiscard]] double at(const Place& place) const override {
    const double row = std::floor(place.flat.y);
    return fractionOf(place.flat.y) < joint_ || fractionOf(place.flat.x + stagger_ * row) < joint_ ? 1 : 0;
  }
  [[nodiscard]] double mean() const override { return 1 - (1 - joint_) * (1 - joint_); }

 private:
  double joint_, stagger_;
};

}  // namespace

PatternType tilesPattern() {
  PatternType type;
  type.name = "tiles";
  type.title = "Tiles with joints, brickwork";
  type.parameters = {joint(), stagger()};
  type.make = [](const core::Arguments& arguments) -> std::shared_ptr<const Pattern> {
    return std::make_shared<Tiles>(valueOf(arguments, joint()), valueOf(arguments, stagger()));
  };
  return type;
}

}  // namespace goniolux::texture
