#include "reflection/index_of_refraction.h"

#include <algorithm>
#include <utility>

namespace goniolux::reflection {

core::Parameter refractiveIndex(std::string key, bool required, std::string help) {
  core::Parameter parameter;
  parameter.key = std::move(key);
  parameter.title = "refractive index";
  parameter.unit = "1";
  parameter.kind = core::ParameterKind::refractiveIndex;
  parameter.required = required;
  parameter.minimum = 0;
  parameter.minimumIsAllowed = false;
  parameter.help = std::move(help);
  return parameter;
}

std::vector<float> indexAtNodes(const spectrum::SpectralDistribution& index,
                                const spectrum::SpectralQuadrature& quadrature) {
  std::vector<float> values;
  for (const double nm : quadrature.wavelengths) values.push_back(static_cast<float>(index.continuum(nm)));
  return values;
}

Medium mediumOf(const material::Material& material, const spectrum::SpectralQuadrature& quadrature) {
  const std::size_t count = quadrature.wavelengths.size();
  Medium medium;
  const auto index = material.spectra.find("ior");
  medium.index =
      index == material.spectra.end() ? std::vector<float>(count, 1.5f) : indexAtNodes(index->second, quadrature);
  medium.attenuation.assign(count, 0.0f);
  if (const auto given = material.spectra.find("attenuation_per_m"); given != material.spectra.end())
    medium.attenuation = indexAtNodes(given->second, quadrature);
  medium.absorbs = std::any_of(medium.attenuation.begin(), medium.attenuation.end(), [](float a) { return a > 0; });
  medium.disperses =
      std::any_of(medium.index.begin(), medium.index.end(), [&](float n) { return n != medium.index.front(); });
  return medium;
}

}  // namespace goniolux::reflection
