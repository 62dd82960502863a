#include "scene/housing.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "geometry/inside.h"
#include "geometry/queries.h"

namespace goniolux::scene {

namespace {

constexpr double mostTimesOpening = 1.5, mostBeyondOpening = 0.5;

double extentOf(const emitter::Opening& opening) {
  double across = std::max(opening.diameter, std::hypot(opening.length, opening.width, opening.height));
  for (const core::Vec2& p : opening.profile) across = std::max(across, 2 * std::hypot(p.x, p.y));
  return across;
}

bool isOpaque(const Environment& environment, const Object& object) {
  return std::none_of(object.materials.begin(), object.materials.end(),
                      [&](std::uint32_t index) { return environment.materials[index].model == "dielectric"; });
}

}  // namespace

std::vector<Enclosure> enclosuresOf(const Environment& environment) {
  std::vector<Enclosure> found;
  for (std::uint32_t o = 0; o < environment.objects.size(); ++o) {
    const Object& object = environment.objects[o];
    if (object.facesInward || !object.shape.closed || !isOpaque(environment, object)) continue;
    for (const core::Mat4& place : placesOf(object)) {
      const geometry::Bounds box = geometry::bounds(object.shape, place);
      std::optional<geometry::InsideTest> test;  // dear for a large mesh: only where the box says maybe
      for (std::uint32_t l = 0; l < environment.luminaires.size(); ++l) {
        const Luminaire& luminaire = environment.luminaires[l];
        if (!box.contains(luminaire.center)) continue;
        if (!test) test.emplace(object.shape, place);
        if (!test->contains(luminaire.center)) continue;
        const double most = mostTimesOpening * extentOf(luminaire.opening) + mostBeyondOpening;
        found.push_back({l, o, glm::length(box.extent()) <= most});
      }
    }
  }
  return found;
}

}  // namespace goniolux::scene
