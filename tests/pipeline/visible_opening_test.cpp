// Luminaires are seen in pictures with the luminance of their opening: L(d) = I(d) / A_proj(d), cd/m2, for every shape,
// from files and built in.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "image/exr.h"
#include "photometry/photometric_file.h"
#include "pipeline/stages.h"
#include "support/temporary_folder.h"

namespace goniolux::pipeline {
namespace {

using core::Vec3;

constexpr double flux = 3000, size = 0.1;

struct Case {
  const char* name;
  const char* luminaire;  ///< members of its entry
  const char* file;       ///< its distribution; "" = diffuse
  double (*projectedArea)(const Vec3& towards);
  double dimming = 1;
};

// The frame of an unturned luminaire: C0 = +x, C90 = +y, aim = -z.
const Case cases[] = {
    {"panel, from its file", R"("photometry": "panel-600-microprismatic.ies")", "panel-600-microprismatic.ies",
     [](const Vec3& d) { return 0.36 * std::abs(d.z); }},
    {"pendant, from its file, length along C90", R"("photometry": "linear-pendant.ldt")", "linear-pendant.ldt",
     [](const Vec3& d) { return 1.2 * 0.06 * std::abs(d.z); }},
    {"downlight, dimmed", R"("photometry": "downlight-60.ies", "dimming": 0.25)", "downlight-60.ies",
     [](const Vec3& d) { return 0.25 * core::pi * 0.15 * 0.15 * std::abs(d.z); }, 0.25},
    {"bare tube",
     R"("photometry": "diffuse", "flux": 3000, "shape": { "tube": { "length": 1.2, "diameter": 0.026, "axis": [1,0,0] } })",
     "", [](const Vec3& d) { return 1.2 * 0.026 * std::hypot(d.y, d.z); }},
    {"web on a tube",
     R"("photometry": "linear-pendant.ldt", "shape": { "tube": { "length": 1.2, "diameter": 0.026, "axis": [0,1,0] } })",
     "linear-pendant.ldt", [](const Vec3& d) { return 1.2 * 0.026 * std::hypot(d.x, d.z); }},
    {"sphere", R"("photometry": "street.ldt", "shape": { "sphere": { "diameter": 0.1 } })", "street.ldt",
     [](const Vec3&) { return 0.25 * core::pi * size * size; }},
    {"box", R"("photometry": "street.ldt", "shape": { "box": { "length": 0.5, "width": 0.2, "height": 0.1 } })",
     "street.ldt",
     [](const Vec3& d) { return 0.2 * 0.1 * std::abs(d.x) + 0.5 * 0.1 * std::abs(d.y) + 0.5 * 0.2 * std::abs(d.z); }}};

std::string projectText(const std::string& luminaire, const Vec3& eye) {
  return R"({ "format": "goniolux-project", "version": 1, "name": "seen", "units": "m",
    "materials": { "black": { "model": "lambert", "diffuse": 0.0 } },
    "objects": [ { "name": "ground", "shape": "rectangle", "origin": [-9,-9,-9], "u": [18,0,0], "v": [0,18,0], "material": "black" } ],
    "luminaires": [ { "name": "L", "position": [0,0,0], )" +
         luminaire + R"( } ],
    "views": [ { "name": "v", "eye": [)" +
         std::to_string(eye.x) + "," + std::to_string(eye.y) + "," + std::to_string(eye.z) +
         R"(], "target": [0,0,0], "up": [0.1,0.2,1], "fov": 0.002, "width": 2, "height": 2 } ] })";
}

TEST(VisibleOpening, HasTheLuminanceOfItsIntensityOverItsProjectedArea) {
  const test::TemporaryFolder folder;
  for (const Case& each : cases) {
    double worst = 0, least = 1e300, most = 0;
    for (const auto& [c, gamma] : {std::pair{0.0, 10.0}, {0.0, 40.0}, {37.0, 55.0}, {90.0, 30.0}, {215.0, 70.0}}) {
      const double g = gamma * core::degree, a = c * core::degree;
      const Vec3 local(std::sin(g) * std::cos(a), std::sin(g) * std::sin(a), std::cos(g));  // C0, C90, aim
      const Vec3 world(local.x, local.y, -local.z);
      folder.write("project.json", projectText(each.luminaire, 4.0 * world));
      StageRequest request;
      request.inputs = {folder.path().string()};
      request.common.output = folder.path().string();
      core::SilentProgress silent;
      (void)renderStage().run(request, silent);
      const image::XyzImage image = image::readExr((folder.path() / "v.exr").string());
      const double area = each.projectedArea(world);
      const double expected =
          std::string(each.file).empty()
              ? flux / (core::pi * core::pi * 1.2 * 0.026)  // uniform: flux / (pi x area of the side)
              : each.dimming *
                    photometry::readPhotometricFile(std::string(GONIOLUX_SOURCE_DIR) + "/luminaires/" + each.file)
                        .distribution->intensity(local) /
                    area;
      for (std::size_t i = 0; i < 4; ++i) {
        // The pixel is 2e-5 rad wide and its number has single precision.
        EXPECT_NEAR(image.y[i], expected, static_cast<double>(image.halfWidth[i]) + 2e-4 * expected)
            << each.name << " at C " << c << ", gamma " << gamma;
        worst = std::max(worst, std::abs(static_cast<double>(image.y[i]) / expected - 1));
      }
      least = std::min(least, expected);
      most = std::max(most, expected);
    }
    std::printf("%-42s %8.0f to %8.0f cd/m2, largest error %.1e\n", each.name, least, most, worst);
  }
}

}  // namespace
}  // namespace goniolux::pipeline
