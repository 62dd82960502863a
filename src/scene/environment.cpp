#include "scene/environment.h"

namespace goniolux::scene {

std::vector<core::Mat4> placesOf(const Object& object) {
  std::vector<core::Mat4> places{object.transform};
  places.insert(places.end(), object.copies.begin(), object.copies.end());
  return places;
}

}  // namespace goniolux::scene
