// Mappings: how the luminances of a scene become those of a device. One file each; the registry is in mappings.cpp.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/parameter.h"
#include "display/exposure.h"
#include "display/tone_curve.h"
#include "image/xyz_image.h"

namespace goniolux::display {

/// What a mapping is made for.
struct MappingTask {
  const image::XyzImage& image;
  LuminanceStatistics statistics;
  double white_cd_m2 = 0;  ///< of the device; 0: not known
  double darkest = 0;      ///< black and flare of the device, as a fraction of its white
};

struct ToneMap {
  std::shared_ptr<const ToneCurve> curve;
  std::string method;  ///< what was done, for the report
  /// Luminance of the scene that is shown as the device's white; 0 where no single one is.
  double white_cd_m2 = 0;
  /// Stands for the image: as the eye sees it (glare, acuity), or false colours.
  std::optional<image::XyzImage> seen;
  /// Colours are those of the device's white already: no chromatic adaptation.
  bool coloursAreFixed = false;
};

struct MappingType {
  std::string name, title, source;
  std::vector<core::Parameter> parameters;
  ToneMap (*make)(const MappingTask& task, const core::Arguments& arguments);
};

/// The registry of mappings.
const std::vector<MappingType>& mappingTypes();

/// "NAME" or "NAME:KEY=VALUE,KEY,…" ("ward:glare,colour"); a key without value means yes.
struct MappingChoice {
  const MappingType* type = nullptr;
  core::Arguments arguments;  ///< all parameters, defaults filled in
};
/// core::InputError names what is not known and what is.
MappingChoice mappingNamed(const std::string& text);

inline double numberOf(const core::Arguments& arguments, const char* key) {
  return std::get<double>(arguments.at(key));
}
inline const std::string& textOf(const core::Arguments& arguments, const char* key) {
  return std::get<std::string>(arguments.at(key));
}
inline bool isOn(const core::Arguments& arguments, const char* key) {
  return numberOf(arguments, key) != 0;
}

}  // namespace goniolux::display
