// A chessboard: a repeat holds two by two fields.
#include "texture/patterns.h"

namespace goniolux::texture {
namespace {

class Checker final : public Pattern {
 public:
  [[nodiscard]] double at(const Place& place) const override {
    return (fractionOf(place.flat.x) < 0.5) == (fractionOf(place.flat.y) < 0.5) ? 0 : 1;
  }
  [[nodiscard]] double mean() const override { return 0.5; }
};

}  // namespace

PatternType checkerPattern() {
  PatternType type;
  type.name = "checker";
  type.title = "Chessboard of two by two fields a repeat";
  type.make = [](const core::Arguments&) -> std::shared_ptr<const Pattern> { return std::make_shared<Checker>(); };
  return type;
}

}  // namespace goniolux::texture
