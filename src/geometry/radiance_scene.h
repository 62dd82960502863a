// Radiance scene files (.rad): the documented subset of primitives that describe surfaces, for import.
//
// Read: polygon, sphere, bubble, cylinder, tube, cone, cup, ring; plastic, metal, mirror; alias. Everything else, and
// every command ("!…"), is listed with its line and left out. Format: the Radiance reference manual.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/diagnostics.h"
#include "geometry/shape.h"

namespace goniolux::geometry {

struct RadianceMaterial {
  std::string name, type;  ///< plastic, metal or mirror
  double red = 0, green = 0, blue = 0;
  double specularity = 0;
  /// Luminous reflectance by Radiance's own weights of its three channels.
  [[nodiscard]] double luminous() const { return 0.265 * red + 0.670 * green + 0.065 * blue; }
};

struct RadianceRound {
  enum class Kind { sphere, cylinder, cone, ring };
  Kind kind = Kind::sphere;
  core::Vec3 a{0}, b{0};  ///< centre or base; top, or the ring's normal
  double r0 = 0, r1 = 0;  ///< radius; at the base and at the top; inner and outer
  std::string material;
};

struct RadianceScene {
  std::vector<RadianceMaterial> materials;
  Mesh mesh;                           ///< all polygons
  std::vector<std::string> partNames;  ///< of the mesh: the polygons' modifiers
  std::vector<RadianceRound> rounds;
  core::Diagnostics left;  ///< warnings: what was not understood, with its line
};

/// Coordinates are as in the file. Throws core::InputError with the line when the text is damaged: counts that are no
/// numbers, too few arguments, numbers that are not finite.
RadianceScene readRadianceScene(std::string_view text, const std::string& fileName);

}  // namespace goniolux::geometry
