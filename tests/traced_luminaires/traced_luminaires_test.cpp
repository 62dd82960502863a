// The traced files of luminaires/: the tracing against closed forms, and each file against a coarser trace of its
// model. GONIOLUX_UPDATE_LUMINAIRES=1 writes files and page anew (a few minutes).
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "core/document.h"
#include "core/parallel.h"
#include "photometry/comparison.h"
#include "photometry/photometric_file.h"
#include "photometry/writers.h"
#include "spectrum/cie_data.h"
#include "support/generated_block.h"
#include "traced_luminaires/light_tracer.h"
#include "traced_luminaires/shapes.h"

namespace goniolux::traced {
namespace {

namespace fs = std::filesystem;
using core::Vec3;

constexpr int logRays = 24;
constexpr double statedNoise = 0.017;  // largest standard error of a value that luminaires/traced.md states

const fs::path folder = fs::path(GONIOLUX_SOURCE_DIR) / "luminaires";

Fixture bareDisc() {
  Fixture f;
  f.lampFlux = 1000;
  f.planes = {0};
  for (int i = 0; i <= 36; ++i) f.gammas.push_back(2.5 * i);
  f.lamps = {{.kind = Lamp::Kind::disc, .center = {0, 0, 0}, .diameter = 0.1}};
  // Something must stand in the world: a small black disc behind the lamp.
  f.parts = {{disc({0, 0, 0.01}, 0.05), Finish::black}};
  return f;
}

TEST(LightTracer, ABareDiscGivesTheCosineLaw) {
  const TracedLight light = trace(bareDisc(), 18);
  EXPECT_NEAR(light.outputRatio, 1, 1e-9);
  for (const double gamma : {0.0, 20.0, 45.0, 60.0, 80.0})
    EXPECT_NEAR(light.distribution->atAngles(0, gamma), 1000 / core::pi * std::cos(gamma * core::degree),
                0.01 * 1000 / core::pi)
        << gamma;
}

TEST(LightTracer, AWhiteBoxWithAnOpeningGivesTheSeriesOfItsFlux) {
  // A closed sphere of reflectance rho with a port that takes the share s of every reflection: LOR = s / (1 - rho (1 -
  // s)) for a source that reaches the port itself with the chance s, too. Here a sphere with a hole by a flat cut is
  // replaced by a diffuser: one that reflects R and transmits T of what a white surrounding of rho returns: T / (1 -
  // rho R) of it.
  Fixture f;
  f.lampFlux = 100;
  f.planes = {0};
  for (int i = 0; i <= 36; ++i) f.gammas.push_back(5.0 * i);
  f.parts = {{sphere({0, 0, 0}, 0.5), Finish::diffuser, 0.6, 0.3}};
  f.lamps = {{.kind = Lamp::Kind::sphere, .center = {0, 0, 0}, .diameter = 0.1}};
  // Inside the sphere everything comes back to it: the sum of 0.3 * 0.6^n = 0.75.
  EXPECT_NEAR(trace(f, 18).outputRatio, 0.75, 2e-3);
}

TEST(LightTracer, AMirrorTroughAddsTheImageOfItsLamp) {
  // A lamp above a large mirror that faces up: half of its light comes back up, times the reflectance.
  Fixture f;
  f.lampFlux = 100;
  f.planes = {0};
  for (int i = 0; i <= 36; ++i) f.gammas.push_back(5.0 * i);
  f.parts = {{disc({0, 0, -0.01}, 1000), Finish::mirror, 0.9}};
  f.lamps = {{.kind = Lamp::Kind::sphere, .center = {0, 0, 0}, .diameter = 0.002}};
  const TracedLight light = trace(f, 19);
  EXPECT_NEAR(light.outputRatio, 0.95, 2e-3);
  EXPECT_NEAR(light.distribution->atAngles(0, 150), 1.9 * 100 / (4 * core::pi), 0.05 * 100 / (4 * core::pi));
  EXPECT_LT(light.distribution->atAngles(0, 40), 1e-9);
}

TEST(LightTracer, GivesTheSameForAnyNumberOfThreads) {
  Fixture f = fixtures().front();
  core::setThreadCount(1);
  const double one = trace(f, 15).distribution->maximumIntensity();
  core::setThreadCount(2);
  const double two = trace(f, 15).distribution->maximumIntensity();
  core::setThreadCount(0);
  EXPECT_EQ(one, two);
}

photometry::PhotometricFile fileOf(const Fixture& fixture, const TracedLight& light) {
  photometry::PhotometricFile file;
  file.file = fixture.file;
  file.distribution = light.distribution;
  file.opening = fixture.opening;
  file.inputWatts = fixture.watts;
  file.absolute = fixture.absolute;
  if (!fixture.absolute) file.declaredLumens = fixture.lampFlux;
  file.declaredLuminaireLumens = light.distribution->flux();
  file.keywords = {{"MANUFAC", "Goniolux"},
                   {"LUMCAT", fs::path(fixture.file).stem().string()},
                   {"LUMINAIRE", fixture.title},
                   {"LAMP", fixture.absolute ? "LED" : fixture.lamp},
                   {"TEST", "none: traced, not measured"},
                   {"TESTLAB", "none"},
                   {"ISSUEDATE", "2026-11-23"}};
  file.keywords[fixture.file.ends_with(".ldt") ? "FILENAME" : "OTHER"] =
      fixture.file.ends_with(".ldt") ? fixture.file : "Traced by tests/traced_luminaires: " + fixture.how;
  if (fixture.file.ends_with(".xml")) file.spectrum = spectrum::illuminant(fixture.spectrum);
  return file;
}

// The row of the page. Its figures come from the file, so that page and file are of one mind.
std::string row(const Fixture& fixture) {
  const photometry::PhotometricFile file = photometry::readPhotometricFile((folder / fixture.file).string());
  const double flux = file.distribution->flux();
  return fmt::format("| `{}` | {} | {} | {:.0f} | {:.2f} | {:g} | {} | {} | {} |\n", fixture.file, fixture.title,
                     fixture.use, flux, flux / fixture.lampFlux, fixture.watts, file.symmetry, fixture.spectrum,
                     fixture.how);
}

TEST(TracedLuminaires, AreWhatTheirModelsGive) {
  const bool update = std::getenv("GONIOLUX_UPDATE_LUMINAIRES") != nullptr;
  double noise = 0;
  for (const Fixture& fixture : fixtures()) {
    SCOPED_TRACE(fixture.file);
    const std::string path = (folder / fixture.file).string();
    if (update) {
      const TracedLight light = trace(fixture, logRays);
      std::printf("%-32s standard error at most %.2f %%\n", fixture.file.c_str(), 100 * light.noise);
      core::Diagnostics warnings;
      core::writeFile(path, photometry::writePhotometry(fileOf(fixture, light), path, warnings));
      EXPECT_TRUE(warnings.all().empty());
      continue;
    }
    const photometry::PhotometricFile file = photometry::readPhotometricFile(path);
    const TracedLight coarse = trace(fixture, 16);
    const double flux = file.distribution->flux();
    EXPECT_NEAR(coarse.distribution->flux(), flux, 0.01 * flux);
    // 65 536 rays: a few per cent of noise per direction, which misplaces half of its mean size.
    EXPECT_LT(difference(*coarse.distribution, *file.distribution).misplaced, 0.05 * flux);
    noise = std::max(noise, coarse.noise * std::exp2(0.5 * (16 - logRays)));
  }
  if (update) return;
  // What the page says of the files' noise: it falls as the root of the number of rays. An estimate from sixteen parts
  // scatters by 18 %, and the largest of some hundred is looked at.
  std::printf("standard error of a value at most %.2f %% with 2^%d rays\n", 100 * noise, logRays);
  EXPECT_LT(noise, 1.5 * statedNoise);
}

TEST(TracedLuminaires, StandInThePageOfTheLibrary) {
  std::string text =
      "| file | what it is | for | flux, lm | LOR | W | symmetry | spectrum | how it was made "
      "|\n|---|---|---|---|---|---|---|---|---|\n";
  for (const Fixture& fixture : fixtures()) text += row(fixture);
  test::expectGeneratedBlock(folder / "traced.md", "traced luminaires", text);
}

}  // namespace
}  // namespace goniolux::traced
