// The materials that the property tests try with every model of the registry. A model without a line here fails the
// tests: a newcomer cannot escape them.
#pragma once

#include <string>
#include <vector>

#include "material/material.h"
#include "reflection/bsdf.h"
#include "spectrum/spectral_quadrature.h"

namespace goniolux::reflection {

struct Case {
  std::string name;
  material::Material material;
  double inside = 1, outside = 1;  ///< refractive indices on the two sides, for what transmits
};

inline material::Material finish(const std::string& model, const std::vector<std::pair<std::string, double>>& spectra,
                                 const std::vector<std::pair<std::string, double>>& numbers = {}) {
  material::Material material;
  material.name = material.model = model;
  for (const auto& [key, value] : spectra) material.spectra[key] = spectrum::SpectralDistribution::flat(value);
  for (const auto& [key, value] : numbers) material.numbers[key] = value;
  return material;
}

/// Finishes that lose no light, or as little as their model can; several of each model.
inline std::vector<Case> whiteCases() {
  std::vector<Case> cases;
  cases.push_back({"lambert", finish("lambert", {{"diffuse", 1}})});
  cases.push_back({"mirror", finish("mirror", {{"reflectance", 1}})});
  for (const double roughness : {0.0, 0.3, 0.6, 1.0})
    cases.push_back({"oren-nayar " + std::to_string(roughness),
                     finish("oren-nayar", {{"diffuse", 1}}, {{"roughness", roughness}})});
  cases.push_back({"glass from air", finish("dielectric", {{"ior", 1.5}}), 1.5, 1});
  cases.push_back({"glass from inside", finish("dielectric", {{"ior", 1.5}}), 1, 1.5});
  cases.push_back({"pane", finish("dielectric", {{"ior", 1.52}}, {{"thickness_m", 0.006}})});
  return cases;
}

inline spectrum::SpectralQuadrature oneNode() {
  return spectrum::flatQuadrature({spectrum::SpectralDistribution::flat(1)});
}

}  // namespace goniolux::reflection
