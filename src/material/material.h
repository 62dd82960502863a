// Material: a named finish: which reflection model, with which spectral curves and numbers. No algorithm.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/diagnostics.h"
#include "spectrum/spectral_distribution.h"

namespace goniolux::material {

/// Diffuse emission of a surface, on each side that can be seen.
struct Emission {
  double exitance_lm_m2 = 0;
  spectrum::SpectralDistribution spectrum;  ///< relative
};

struct Material {
  std::string name;
  std::string model;                                              ///< a name of the reflection-model registry
  std::map<std::string, spectrum::SpectralDistribution> spectra;  ///< by the model's parameter keys, e.g. "diffuse"
  std::map<std::string, double> numbers;                          ///< e.g. "gloss"
  std::optional<Emission> emission;
  /// A textured finish is mixed of these from place to place; its own curves are then their mean, for whatever does not
  /// look at places.
  std::vector<Material> components = {};
  std::vector<double> shares = {};                    ///< of each component over the whole texture
  std::optional<std::uint32_t> texture, relief = {};  ///< index into scene::Environment::textures, reliefs
  core::SourcePosition position;
};

}  // namespace goniolux::material
