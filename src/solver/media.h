// Media: what transparent things a light path is inside of.
//
// Bodies may overlap: the later object of the project displaces the earlier ones there (a glass set into water is
// glass, with an interface glass - water and no air between). A surface of a body that is displaced on both sides is no
// interface. A path that begins inside a body finds out when it leaves it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "reflection/bsdf.h"

namespace goniolux::solver {

class Media {
 public:
  Media() {}  // NOLINT: does not clear the list, for a path is made for every sample

  /// The medium here; null: air.
  [[nodiscard]] const reflection::Medium* here() const { return count_ > 0 ? inside_[strongest()].medium : nullptr; }

  void enter(std::uint32_t object, const reflection::Medium* medium) {
    if (contains(object) || count_ == inside_.size()) return;
    inside_[count_++] = {object, medium};
  }
  void leave(std::uint32_t object) {
    for (std::size_t i = 0; i < count_; ++i)
      if (inside_[i].object == object) {
        inside_[i] = inside_[--count_];
        return;
      }
  }
  [[nodiscard]] bool contains(std::uint32_t object) const {
    for (std::size_t i = 0; i < count_; ++i)
      if (inside_[i].object == object) return true;
    return false;
  }

 private:
  struct Body {
    std::uint32_t object;
    const reflection::Medium* medium;
  };
  [[nodiscard]] std::size_t strongest() const {
    std::size_t best = 0;
    for (std::size_t i = 1; i < count_; ++i)
      if (inside_[i].object > inside_[best].object) best = i;
    return best;
  }

  std::array<Body, 8> inside_;  // the first count_ of them
  std::size_t count_ = 0;
};

}  // namespace goniolux::solver
