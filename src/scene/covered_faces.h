// Faces of luminous volumes that lie against a surface: the back of a batten on the ceiling, of a bulkhead on the wall.
//
// A photometric file says which light leaves the whole luminaire. Where its back is against a surface, that light
// leaves by the other faces; shared out to the back as well, it would be lost in the gap (12 battens on the ceiling of
// a room of 6 m x 4 m: 14 % of the illuminance).
#pragma once

#include "emitter/opening.h"
#include "scene/world.h"

namespace goniolux::scene {

/// Opening::covered of a box or round cylinder at `center` (world frame of `world`, whose objects are in place). A face
/// is covered when its middle and the middles of its quarters are nearer to one flat surface than 5 % of its shorter
/// side. 0 where all faces would be: such a luminaire is shut in, and is left as it is.
std::uint8_t coveredFaces(const World& world, const emitter::Opening& opening, const photometry::LuminaireFrame& frame,
                          const core::Vec3& center);

}  // namespace goniolux::scene
