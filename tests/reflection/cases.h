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
  for (const double alpha : {0.03, 0.1, 0.3, 0.6, 1.0}) {
    const std::string name = std::to_string(alpha);
    // n = 0 and a large k: a mirror at every angle (F = 1 to 1e-10).
    cases.push_back({"white metal " + name, finish("conductor", {{"ior", 1e-4}, {"k", 1e5}}, {{"roughness", alpha}})});
    cases.push_back(
        {"rough glass from air " + name, finish("dielectric", {{"ior", 1.5}}, {{"roughness", alpha}}), 1.5, 1});
    cases.push_back(
        {"rough glass from inside " + name, finish("dielectric", {{"ior", 1.5}}, {{"roughness", alpha}}), 1, 1.5});
    cases.push_back({"ward " + name, finish("ward", {{"diffuse", 0.5}, {"specular", 0.5}}, {{"roughness", alpha}})});
  }
  cases.push_back({"smooth white metal", finish("conductor", {{"ior", 1e-4}, {"k", 1e5}})});
  cases.push_back({"gold", finish("conductor", {{"ior", 0.35}, {"k", 2.714}}, {{"roughness", 0.2}})});
  cases.push_back({"opal film", finish("diffuse-transmission", {{"diffuse", 0.4}, {"transmission", 0.6}})});
  return cases;
}

inline spectrum::SpectralQuadrature oneNode() {
  return spectrum::flatQuadrature({spectrum::SpectralDistribution::flat(1)});
}

}  // namespace goniolux::reflection
