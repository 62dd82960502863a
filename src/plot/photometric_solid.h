// PhotometricSolid: the surface at the distance I(C, gamma) in every direction, as a figure (kind "photometric-solid"
// of "goniolux-figure", version 1) for the drawing helper.
#pragma once

#include <string>
#include <vector>

#include "core/document.h"

namespace goniolux::plot {

struct PhotometricSolid {
  std::string title, subtitle, footer;
  std::vector<std::string> facts;
  std::string unit = "cd";
  std::vector<double> planes;  ///< C, degrees, ascending from 0 to 360
  std::vector<double> gammas;  ///< degrees, ascending from 0 to 180
  std::vector<double> values;  ///< [plane * gammas.size() + gamma], not below 0
};

core::Value toJson(const PhotometricSolid& solid);
/// Throws core::InputError with positions on anything that cannot be drawn.
PhotometricSolid photometricSolidFromJson(const core::Value& document);

}  // namespace goniolux::plot
