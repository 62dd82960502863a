// Luminaires inside bodies: in a model of their housing, or shut in by mistake.
#pragma once

#include <vector>

#include "scene/environment.h"

namespace goniolux::scene {

/// A luminaire whose centre is inside an opaque closed body.
struct Enclosure {
  std::uint32_t luminaire = 0, object = 0;  ///< indices into Environment::luminaires and objects
  /// The body is about as large as the luminaire: a model of its housing. Photometric files describe the light that has
  /// left the housing, so it must not shade that light again (IES LM-63, EN 13032-1: the luminaire is measured whole).
  bool isHousing = false;
};

/// All of them, by object. A housing's box is no longer across than one and a half times the opening and half a metre.
std::vector<Enclosure> enclosuresOf(const Environment& environment);

}  // namespace goniolux::scene
