// Opening: the luminous opening of a luminaire as geometry, in the luminaire frame (C0, C90, aim). Lengths in metres.
#pragma once

#include <cstdint>
#include <vector>

#include "core/vector.h"
#include "photometry/intensity_distribution.h"

namespace goniolux::emitter {

/// The centre of the opening (of a volume: its centre) is the luminaire's position. Shapes stand in axes (x, y, z) that
/// are (C0, C90, aim) unless `along` names another z:
/// rectangle: length along x, width along y, perpendicular to z; disc: perpendicular to z; box: height along z;
/// cylinder: axis along z, caps included; revolution: `profile` turned about the aim, emitting outside (its zero is the
/// position); sphere; tube: side only, along `axis`; line: along `axis`, no geometry. A
/// disc, cylinder or sphere with diameter 0 is elliptical: length, width and (sphere) height are its diameters.
struct Opening {
  enum class Shape { point, rectangle, disc, box, cylinder, sphere, tube, line, revolution };
  enum class Along { aim, c0, c90 };
  Shape shape = Shape::point;
  double length = 0, width = 0, height = 0, diameter = 0;
  core::Vec3 axis{1, 0, 0};  ///< tube and line: unit, WORLD direction (as in the project file)
  Along along = Along::aim;
  /// Faces of a box, and caps of a round cylinder, that lie against a surface and let no light out: bit 2 i for the one
  /// towards axis i (x, y, z), bit 2 i + 1 for the one opposite. The others then emit all of the light.
  std::uint8_t covered = 0;
  [[nodiscard]] bool isCovered(int face) const { return (covered >> face & 1) != 0; }
  std::vector<core::Vec2> profile = {};  ///< revolution: (radius, place along the aim), convex, outside on its right
};

/// The profile of a closed surface of revolution (it begins and ends on the axis) in the direction that has the outside
/// on its right, r to the right and z up; empty where it is not closed, so that some directions would see nothing of
/// it, or not convex, so that parts of it would hide others.
std::vector<core::Vec2> convexProfile(std::vector<core::Vec2> profile);

/// The axes of an opening in the world; unit.
struct OpeningAxes {
  core::Vec3 x, y, z;
};
inline OpeningAxes axesOf(const Opening& opening, const photometry::LuminaireFrame& frame) {
  switch (opening.along) {
    case Opening::Along::c0:
      return {frame.c90, frame.aim, frame.c0};
    case Opening::Along::c90:
      return {frame.aim, frame.c0, frame.c90};
    case Opening::Along::aim:
      break;
  }
  return {frame.c0, frame.c90, frame.aim};
}

/// Diameters along x, y and z of a disc, cylinder (x, y) or sphere, m.
inline core::Vec3 diametersOf(const Opening& opening) {
  return opening.diameter > 0 ? core::Vec3(opening.diameter)
                              : core::Vec3(opening.length, opening.width, opening.height);
}
inline bool isRound(const Opening& opening) {
  const core::Vec3 d = diametersOf(opening);
  return d.x == d.y && (opening.shape != Opening::Shape::sphere || d.x == d.z);
}

}  // namespace goniolux::emitter
