// Stripes that run upwards, one a repeat.
#include "texture/patterns.h"

namespace goniolux::texture {
namespace {

core::Parameter share() {
  return number("share", "Share", 0, 1, "0.5", "of the repeat that the stripe (1) covers; default 0.5");
}

class Stripes final : public Pattern {
 public:
  explicit Stripes(double width) : width_(width) {}
  [[nodiscard]] double at(const Place& place) const override { return fractionOf(place.flat.x) < width_ ? 1 : 0; }
  [[nodiscard]] double mean() const override { return width_; }

 private:
  double width_;
};

}  // namespace

PatternType stripesPattern() {
  PatternType type;
  type.name = "stripes";
  type.title = "Stripes";
  type.parameters = {share()};
  type.make = [](const core::Arguments& arguments) -> std::shared_ptr<const Pattern> {
    return std::make_shared<Stripes>(valueOf(arguments, share()));
  };
  return type;
}

}  // namespace goniolux::texture
