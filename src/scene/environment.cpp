#include "scene/environment.h"

namespace goniolux::scene {

std::vector<core::Mat4> placesOf(const Object& object) {
  std::vector<core::Mat4> places{object.transform};
  places.insert(places.end(), object.copies.begin(), object.copies.end());
  return places;
}

const material::Material* openGlassOf(const Environment& environment, const Object& object) {
  if (object.shape.closed) return nullptr;
  for (const std::uint32_t index : object.materials) {
    const material::Material& material = environment.materials[index];
    if (material.model == "dielectric" && !material.numbers.contains("thickness_m")) return &material;
  }
  return nullptr;
}

}  // namespace goniolux::scene
