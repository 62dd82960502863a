// The paper's local shading models: what each term gives, and what each does to the energy balance (catalogue of
// validation cases, 3.8 and 4.5).
#include <gtest/gtest.h>

#include <cmath>

#include "reflection/cases.h"
#include "reflection/fresnel.h"
#include "reflection/paper_terms.h"
#include "reflection/shading.h"

namespace goniolux::reflection {
namespace {

using core::Vec3;

Vec3 at(double degrees, double azimuth = 0) {
  const double sine = std::sin(degrees * core::degree);
  return {sine * std::cos(azimuth), sine * std::sin(azimuth), std::cos(degrees * core::degree)};
}

std::unique_ptr<LocalShading> make(const std::string& model, const std::vector<std::pair<std::string, double>>& spectra,
                                   const std::vector<std::pair<std::string, double>>& numbers, bool asPrinted) {
  return findShadingModel(model)->make(finish(model, spectra, numbers), oneNode(), asPrinted);
}

// Exitance for 1 lx of illuminance from one direction: the directional albedo. Midpoint rule over the hemisphere.
double albedo(const LocalShading& shading, const Vec3& in) {
  constexpr int rows = 400, columns = 800;
  double sum = 0;
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) {
      const double z2 = (i + 0.5) / rows, angle = 2 * core::pi * (j + 0.5) / columns, r = std::sqrt(1 - z2);
      float value = 0;
      shading.addSource({r * std::cos(angle), r * std::sin(angle), std::sqrt(z2)}, in, 1 / in.z, {}, &value);
      sum += static_cast<double>(value) * core::pi / (rows * columns);
    }
  return sum;
}

TEST(PaperModels, DiffuseTermIsLambertsLawAsMeantAndPiTimesThatAsPrinted) {
  EXPECT_NEAR(albedo(*make("hall", {{"diffuse", 0.6}}, {}, false), at(40)), 0.6, 1e-4);
  EXPECT_NEAR(albedo(*make("hall", {{"diffuse", 0.6}}, {}, true), at(40)), 0.6 * core::pi, 1e-3);
}

// The highlight (N.H)^n has the albedo S_n / cos(theta): it is not normalised, and grows without bound towards grazing.
TEST(PaperModels, HighlightsAreNotNormalised) {
  const struct {
    double n, angle, albedo, tolerance;
  } rows[] = {{1, 0, 2.860, 1e-3},   {1, 80, 11.13, 1e-2}, {10, 0, 1.501, 1e-3},  {10, 60, 1.202, 1e-3},
              {10, 85, 2.322, 2e-3}, {50, 0, .4475, 3e-4}, {50, 80, .1712, 3e-4}, {200, 0, .1220, 2e-4}};
  for (const auto& row : rows) {
    const auto printed = make("whitted", {{"specular", 1}}, {{"gloss", row.n}}, true);
    EXPECT_NEAR(albedo(*printed, at(row.angle)), row.albedo, row.tolerance) << row.n << " at " << row.angle;
    const auto meant = make("whitted", {{"specular", 1}}, {{"gloss", row.n}}, false);
    EXPECT_NEAR(albedo(*meant, at(row.angle)), row.albedo / core::pi, row.tolerance) << row.n << " at " << row.angle;
  }
  // Closed form at normal incidence: 8 pi (n + 2^(-n/2)) / ((n + 2)(n + 4)).
  for (const double n : {2.0, 20.0})
    EXPECT_NEAR(albedo(*make("whitted", {{"specular", 1}}, {{"gloss", n}}, true), at(0)),
                8 * core::pi * (n + std::pow(2, -n / 2)) / ((n + 2) * (n + 4)), 1e-3);
}

TEST(PaperModels, AsPrintedTheDiffuseSumsOfPhongAndWhittedDoNotKnowTheLamp) {
  for (const char* model : {"phong", "whitted"}) {
    const auto printed = make(model, {{"diffuse", 0.6}}, {}, true), meant = make(model, {{"diffuse", 0.6}}, {}, false);
    float dim = 0, bright = 0;
    printed->addSource(at(0), at(60), 1, {}, &dim);
    printed->addSource(at(0), at(60), 1000, {}, &bright);
    EXPECT_EQ(dim, bright);
    EXPECT_NEAR(dim, 0.3, 1e-6);
    float one = 0, thousand = 0;
    meant->addSource(at(0), at(60), 1, {}, &one);
    meant->addSource(at(0), at(60), 1000, {}, &thousand);
    EXPECT_NEAR(thousand, 1000 * one, 1e-4);
    EXPECT_NEAR(one, 0.3 / core::pi, 1e-7);
    float ambient = 0;
    printed->ambientFactor(&ambient);
    EXPECT_EQ(ambient, 1);
    meant->ambientFactor(&ambient);
    EXPECT_NEAR(ambient, 0.6, 1e-7);
  }
}

TEST(PaperModels, PhongHasNoGlobalTermsAndItsHighlightIsAtTheMirrorDirection) {
  const auto phong = make("phong", {{"specular", 1}, {"transmission", 1}}, {{"gloss", 50}}, false);
  float factor = 1;
  phong->reflectedFactor(at(30), {}, &factor);
  EXPECT_EQ(factor, 0);
  float atMirror = 0, beside = 0;
  phong->addSource(at(30), at(30, core::pi), 1, {}, &atMirror);
  phong->addSource(at(30), at(45, core::pi), 1, {}, &beside);
  EXPECT_NEAR(atMirror, 1 / core::pi, 1e-6);
  EXPECT_NEAR(beside, std::pow(std::cos(15 * core::degree), 50) / core::pi, 1e-6);
}

TEST(PaperModels, HallsRaysFollowFresnel) {
  const auto hall = make("hall", {{"specular", 1}, {"transmission", 1}, {"ior", 1.5}}, {}, false);
  const std::vector<float> glass{1.5f};
  const Interface fromAir{nullptr, glass.data(), 0};
  for (const double angle : {0.0, 45.0, 60.0, 85.0}) {
    float r = 0, t = 0;
    hall->reflectedFactor(at(angle), fromAir, &r);
    hall->transmittedFactor(at(angle), fromAir, &t);
    EXPECT_NEAR(r, dielectricReflectance(std::cos(angle * core::degree), 1.5).mean(), 1e-5);
    EXPECT_NEAR(r + t, 1, 1e-6);
  }
}

// Lacquer: an opaque surface reflects by its own index, though no ray enters it.
TEST(PaperModels, OpaqueHallMaterialsReflectByTheirOwnIndex) {
  const auto lacquer = make("hall", {{"diffuse", 0.5}, {"specular", 1}, {"ior", 1.5}}, {}, false);
  float r = 0;
  lacquer->reflectedFactor(at(60), {}, &r);
  EXPECT_NEAR(r, .089187, 1e-5);
}

// F = 0.9 per metre over 2 m: 0.81 as meant; the printed product gives 1.8, more light than there was.
TEST(PaperModels, HallsDistanceFactorIsAPowerAndWasPrintedAsAProduct) {
  Medium medium;
  medium.index = {1.0f};
  medium.attenuation = {static_cast<float>(-std::log(0.9))};
  medium.absorbs = true;
  float meant = 1, printed = 1;
  make("hall", {}, {}, false)->attenuate({2, &medium}, &meant);
  make("hall", {}, {}, true)->attenuate({2, &medium}, &printed);
  EXPECT_NEAR(meant, 0.81, 1e-6);
  EXPECT_NEAR(printed, 1.8, 1e-6);
}

// H' = -(n1 L + n2 V): the highlight through the surface is 1 where Snell's law sends the light.
TEST(PaperModels, ThroughHighlightIsWhereSnellsLawSendsTheLight) {
  for (const double angle : {0.0, 20.0, 40.0, 70.0}) {
    const double sine = std::sin(angle * core::degree) / 1.5;
    const Vec3 out = at(angle), in{-sine, 0, -std::sqrt(1 - sine * sine)};
    EXPECT_NEAR(throughHighlight(out, in, 1.5, 1, 100), 1, 1e-9) << angle;
    EXPECT_LT(throughHighlight(out, glm::normalize(in + Vec3(0.1, 0, 0)), 1.5, 1, 100), 0.999) << angle;
  }
}

TEST(PaperModels, OpaqueMaterialsHaveNoRefractedRay) {
  EXPECT_FALSE(make("hall", {{"diffuse", 0.5}, {"specular", 1}}, {}, false)->transmits());
  EXPECT_TRUE(make("hall", {{"transmission", 0.5}}, {}, false)->transmits());
}

}  // namespace
}  // namespace goniolux::reflection
