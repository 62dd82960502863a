// Roughness, as a project may state it: alpha itself, the rms slope of the facets, or the exponent of a gloss lobe.
#pragma once

#include <string>
#include <vector>

#include "reflection/bsdf.h"

namespace goniolux::reflection {

/// The parameters "roughness" (alpha), "rms_slope" m (alpha = sqrt(2) m) and "gloss" n (alpha = sqrt(2 / (n + 2))).
std::vector<core::Parameter> roughnessParameters(const std::string& help);
/// alpha by whichever is given; 0 when none is. Never above 1.
double roughnessOf(const material::Material& material);
/// "" or what is wrong: more than one is given.
std::string roughnessComplaint(const material::Material& material);
/// Below this a finish counts as smooth: the lobe is narrower than 0.1 degrees.
inline constexpr double smoothest = 1e-3;

}  // namespace goniolux::reflection
