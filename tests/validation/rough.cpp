// Rough surfaces and the terms of the paper's models: what share of the light they send on. No chance is involved.
#include <fmt/format.h>

#include <cmath>

#include "reflection/bsdf.h"
#include "reflection/ggx.h"
#include "reflection/paper_terms.h"
#include "reflection/shading.h"
#include "spectrum/spectral_quadrature.h"
#include "support/mirror_scenes.h"
#include "validation/sections.h"

namespace goniolux::validation {
namespace {

using core::pi;
using core::Vec3;

Vec3 direction(double polar, double azimuth) {
  return {std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth), std::cos(polar)};
}

/// The integral of f(in) cos over the hemisphere: midpoints in the sine's square and half of the azimuth, the scene
/// being the same on both sides of the plane of incidence.
template <typename F>
double overHemisphere(const F& f) {
  constexpr int rings = 600, sectors = 300;
  double sum = 0;
  for (int i = 0; i < rings; ++i) {
    const double polar = std::asin(std::sqrt((i + 0.5) / rings));
    for (int j = 0; j < sectors; ++j) sum += f(direction(polar, pi * (j + 0.5) / sectors));
  }
  return pi * sum / (rings * sectors);
}

// White facets that scatter once: the rest is lost to facets that stand before them.
std::vector<Number> onceScattered() {
  const double cosines[] = {1, .7, .4, .2, .1};
  const struct {
    double alpha, albedo[5];
  } rows[] = {{.1, {.988304, .981457, .956921, .904542, .883457}},
              {.3, {.877358, .844530, .815253, .838511, .888804}},
              {.5, {.687849, .682954, .716358, .789929, .860105}},
              {1, {1 - std::log(2.0), .378888, .498895, .641648, .760210}}};
  std::vector<Number> numbers;
  for (const auto& row : rows) {
    const reflection::AlbedoTable table = reflection::reflectionAlbedo(reflection::Ggx(row.alpha));
    for (std::size_t i = 0; i < 5; ++i)
      numbers.push_back(
          {fmt::format("α {:g}, cos {:g}", row.alpha, cosines[i]), row.albedo[i], table.value(cosines[i]), 0});
  }
  return numbers;
}

/// What a finish sends on of light from one direction (by reciprocity: of even light, to one direction).
double albedo(const material::Material& material, double cosine) {
  const std::vector<spectrum::SpectralDistribution> source{spectrum::SpectralDistribution::flat(1)};
  const auto quadrature = spectrum::flatQuadrature(source);
  const auto bsdf = reflection::makeBsdf(material, quadrature);
  const Vec3 out = direction(std::acos(cosine), 0);
  return overHemisphere([&](const Vec3& in) {
    float value = 0;
    bsdf->evaluate(out, in, {}, &value);
    return static_cast<double>(value);
  });
}

// A metal of index 1 + 2000 i reflects 0.999999 at all angles.
std::vector<Number> allScattered() {
  std::vector<Number> numbers{{"Lambert, cos 0.4", 1, albedo(test::flatFinish("lambert", "diffuse", 1), .4), 0}};
  for (const double roughness : {.3, .5, 1.0})
    for (const double cosine : {1.0, .7, .4, .2}) {
      material::Material metal = test::flatFinish("conductor", "ior", 1);
      metal.spectra["k"] = spectrum::SpectralDistribution::flat(2000);
      metal.numbers["roughness"] = roughness;
      numbers.push_back(
          {fmt::format("metal, roughness {:g}, cos {:g}", roughness, cosine), 1, albedo(metal, cosine), 0});
    }
  return numbers;
}

// S_n / cos = integral of (N.H)^n cos' over the hemisphere, over the cosine of the source: what k_s multiplies.
std::vector<Number> highlights() {
  const double angles[] = {0, 30, 60, 80, 85};
  const struct {
    double n, s[5];
  } rows[] = {{1, {2.86028, 3.15346, 4.68485, 11.1317, 20.7602}},
              {10, {1.50067, 1.39430, 1.20151, 1.52382, 2.32240}},
              {50, {.447520, .392733, .251192, .171180, .198567}},
              {200, {.121980, .105990, .0628199, .0281452, .0236051}}};
  std::vector<Number> numbers;
  for (const auto& row : rows)
    for (std::size_t i = 0; i < 5; ++i) {
      const Vec3 source = direction(angles[i] * core::degree, 0);
      const double s =
          overHemisphere([&](const Vec3& out) { return reflection::halfwayHighlight(out, source, row.n); });
      numbers.push_back({fmt::format("n {:g}, {:g}°", row.n, angles[i]), row.s[i], s / source.z, 0});
    }
  return numbers;
}

// F = 0.9 per metre over d metres: a power as meant, a product as printed, which gains light beyond 1.11 m.
std::vector<Number> distanceFactor() {
  material::Material glass = test::flatFinish("hall", "transmittance_per_m", 0.9);
  glass.spectra["transmission"] = spectrum::SpectralDistribution::flat(1);
  glass.spectra["specular"] = spectrum::SpectralDistribution::flat(1);
  const std::vector<spectrum::SpectralDistribution> source{spectrum::SpectralDistribution::flat(1)};
  const auto quadrature = spectrum::flatQuadrature(source);
  std::vector<Number> numbers;
  for (const bool asPrinted : {false, true}) {
    const auto shading = reflection::findShadingModel("hall")->make(glass, quadrature, asPrinted);
    for (const double d : {.5, 1.0, 2.0, 5.0}) {
      float value = 1;
      shading->attenuate({d, shading->medium()}, &value);
      numbers.push_back({fmt::format("{}, d {:g} m", asPrinted ? "as printed" : "as meant", d),
                         asPrinted ? 0.9 * d : std::pow(0.9, d), static_cast<double>(value), 0});
    }
  }
  // N.H' is 1 where Snell's law sends the light.
  for (const double degrees : {0.0, 30.0, 60.0, 85.0}) {
    const double above = degrees * core::degree, below = std::asin(std::sin(above) / 1.5);
    const Vec3 out = direction(above, 0), in{-std::sin(below), 0, -std::cos(below)};
    numbers.push_back({fmt::format("highlight through glass, {:g}°", degrees), 1,
                       reflection::throughHighlight(out, in, 1.5, 1, 50), 0});
  }
  return numbers;
}

}  // namespace

Section roughSection() {
  Section section;
  section.title = "Rough surfaces and the paper's terms";
  section.introduction =
      "Directional albedos: the share of light from one direction that is sent on at all. A white surface sends on 1. "
      "The highlights of the paper's models send on more, which is why they are not for photometric numbers.";
  section.cases = {
      {"3.8", "GGX, scattered once", "", "white facets of roughness α, correlated masking, cosine of the view",
       "quadrature by another program; at α 1 and cos 1 it is 1 − ln 2", "the usual model loses 69 % at α 1", 1e-3, 1,
       false, onceScattered},
      {"3.8w", "White surfaces, all scatterings", "", "`lambert`, and `conductor` with a reflectance of 1",
       "energy: 1 (the lobe of later scatterings is fitted: 1 %)", "0.31 to 0.99 without that lobe", 1e-2, 0, false,
       allScattered},
      {"3.8h", "The paper's highlight", "", "∫ (N·H)ⁿ cos / cos of the source, by the source's angle",
       "quadrature by another program; at 0° it is 8π (n + 2^(−n/2)) / ((n + 2)(n + 4))", "", 2e-3, 0, false,
       highlights},
      {"4.5", "The paper's distance factor", "", "`hall`, transmittance 0.9 per metre; index 1.5",
       "F^d as meant, F d as printed; Snell's law", "", 1e-6, 0, false, distanceFactor},
  };
  return section;
}

}  // namespace goniolux::validation
