#include "reflection/paper_terms.h"

#include <algorithm>
#include <limits>

#include "reflection/fresnel.h"
#include "reflection/index_of_refraction.h"
#include "reflection/models.h"

namespace goniolux::reflection {
namespace {

std::vector<float> curve(const material::Material& material, const char* key, double otherwise,
                         const spectrum::SpectralQuadrature& quadrature) {
  const auto found = material.spectra.find(key);
  std::vector<float> values;
  if (found == material.spectra.end()) {
    values.assign(quadrature.wavelengths.size(), static_cast<float>(otherwise));
  } else {
    for (const double v : spectrum::atNodes(found->second, quadrature)) values.push_back(static_cast<float>(v));
  }
  return values;
}

core::Parameter coefficient(const char* key, const char* title, const char* help) {
  core::Parameter parameter = fraction(key, title, false, help);
  parameter.maximum = std::numeric_limits<double>::infinity();
  return parameter;
}

}  // namespace

PaperTerms::PaperTerms(const material::Material& material, const spectrum::SpectralQuadrature& quadrature)
    : kdRd(curve(material, "diffuse", 0, quadrature)),
      ks(curve(material, "specular", 0, quadrature)),
      kt(curve(material, "transmission", 0, quadrature)) {
  if (const auto gloss = material.numbers.find("gloss"); gloss != material.numbers.end()) n = gloss->second;
  inside = mediumOf(material, quadrature);
  const auto perMetre = curve(material, "transmittance_per_m", 1, quadrature);
  for (std::size_t i = 0; i < perMetre.size(); ++i) inside.attenuation[i] = -std::log(std::max(1e-30f, perMetre[i]));
  inside.absorbs = std::any_of(inside.attenuation.begin(), inside.attenuation.end(), [](float a) { return a > 0; });
  opaque = std::all_of(kt.begin(), kt.end(), [](float t) { return t == 0; });
  if (material.spectra.count("fresnel") > 0) constantRf = curve(material, "fresnel", 1, quadrature);
  if (material.spectra.count("k") > 0) k = indexAtNodes(material.spectra.at("k"), quadrature);
}

void PaperTerms::fresnel(double cosine, const Interface& at, float* values) const {
  for (std::size_t i = 0; i < kdRd.size(); ++i) {
    if (!constantRf.empty())
      values[i] = constantRf[i];
    else if (!k.empty())
      values[i] = static_cast<float>(
          conductorReflectance(cosine, static_cast<double>(inside.index[i]), static_cast<double>(k[i])).mean());
    else
      // Nothing is entered at an opaque surface: its own index is then what lies beyond.
      values[i] = static_cast<float>(
          dielectricReflectance(cosine, (opaque ? static_cast<double>(inside.index[i]) : at.beyond(i)) / at.here(i))
              .mean());
  }
}

double halfwayHighlight(const core::Vec3& out, const core::Vec3& in, double n) {
  if (in.z <= 0) return 0;
  const core::Vec3 h = out + in;
  const double length = glm::length(h);
  return length > 0 ? std::pow(std::max(0.0, h.z / length), n) : 0;
}

double mirrorHighlight(const core::Vec3& out, const core::Vec3& in, double n) {
  if (in.z <= 0) return 0;
  return std::pow(std::max(0.0, in.z * out.z - in.x * out.x - in.y * out.y), n);
}

double throughHighlight(const core::Vec3& out, const core::Vec3& in, double sourceIndex, double viewerIndex, double n) {
  if (in.z >= 0) return 0;
  const core::Vec3 h = -(in * sourceIndex + out * viewerIndex);
  const double length = glm::length(h);
  if (!(length > 0)) return 0;
  // It points to the thinner medium; the highlight is the same about either sense of the normal.
  return std::pow(std::abs(h.z) / length, n);
}

std::vector<core::Parameter> paperParameters() {
  core::Parameter gloss = plainNumber("gloss", "gloss exponent", 0, 1e7, "exponent n of the highlight; default 1");
  core::Parameter printed;
  printed.key = "as_printed";
  printed.title = "as printed";
  printed.kind = core::ParameterKind::boolean;
  printed.help = "the formula taken literally";
  return {fraction("diffuse", "diffuse", false, "k_d R_d; default 0"),
          coefficient("specular", "specular coefficient", "k_s; default 0"),
          gloss,
          coefficient("transmission", "transmission coefficient", "k_t; default 0: opaque"),
          refractiveIndex("ior", false, "refractive index, for R_f, T_f and refraction; default 1.5"),
          fraction("transmittance_per_m", "transmittance per metre", false, "F, for one metre of it; default 1"),
          printed};
}

}  // namespace goniolux::reflection
