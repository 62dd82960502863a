// A luminaire for Radiance: a `light` whose luminance in a direction is intensity / projected area of the opening.
#pragma once

#include <map>
#include <string>

#include "scene/environment.h"

namespace goniolux::pipeline {

struct RadianceLuminaire {
  std::string pattern;   ///< scene text that defines `modifier`; empty for uniform luminance
  std::string modifier;  ///< of the light: the pattern's name, or "void"
  double luminance = 0;  ///< cd/m2 that the pattern multiplies
  std::string geometry =
      {};  ///< scene text for openings that have none here: a point is a 2 mm sphere, a line a 2 mm tube
  std::map<std::string, std::string> files = {};  ///< table of candelas, functions
};

/// `name` is the identifier of the light in the scene and of its files.
RadianceLuminaire radianceLuminaire(const scene::Luminaire& luminaire, const std::string& name);

}  // namespace goniolux::pipeline
