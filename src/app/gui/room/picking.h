// Picking: what of a scene lies under the mouse. World frame, metres.
#pragma once

#include <limits>
#include <optional>
#include <string>

#include "app/gui/room/room_scene.h"

namespace goniolux::gui {

struct Ray {
  core::Vec3 origin{0}, direction{0, 0, -1};                         ///< unit direction
  double least = 0, most = std::numeric_limits<double>::infinity();  ///< of the distances that count, m
};

/// Cuts away what lies on the far side of an axis-parallel plane.
struct Cut {
  int axis = 2;              ///< 0: x, 1: y, 2: z
  double at = 0;             ///< m
  bool takesGreater = true;  ///< what is cut away has the greater coordinates
  /// What of a ray is left.
  [[nodiscard]] Ray of(Ray ray) const;
};

struct Picked {
  std::string pointer;  ///< the entry of the document
  double distance = 0;  ///< along the ray, m
  int luminaire = -1;   ///< index into RoomScene::luminaires; -1: an object
};

/// The first thing that the ray meets. Surfaces of the room count from inside only, as they are drawn. A luminaire is
/// hit `reach` (m per m of distance, and at least) beside its opening too: small ones are hard to hit.
std::optional<Picked> pick(const RoomScene& scene, const Ray& ray, double reach, bool luminairesOnly = false);

/// Where the ray meets the plane; nothing when it runs along it or away from it.
std::optional<core::Vec3> onPlane(const Ray& ray, const core::Vec3& point, const core::Vec3& normal);

/// Each coordinate at the nearest multiple of `step`; as it is for step 0.
core::Vec3 snapped(const core::Vec3& point, double step);

}  // namespace goniolux::gui
