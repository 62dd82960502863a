// What a project takes from a photometric file besides candelas: opening, spectrum, lamp output against tilt.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "project/project.h"
#include "support/temporary_folder.h"

namespace goniolux::project {
namespace {

Project read(const test::TemporaryFolder& folder, const std::string& luminaire) {
  const std::string text = R"({ "format": "goniolux-project", "version": 1, "name": "use of a file", "units": "m",
    "materials": { "grey": { "model": "lambert", "diffuse": 0.5 } },
    "objects": [ { "name": "room", "shape": "box", "min": [0,0,0], "max": [4,4,3], "facing": "inward", "material": "grey" } ],
    "luminaires": [ { "name": "L", "position": [2,2,2], )" +
                           luminaire + R"( } ],
    "grids": [ { "name": "g", "points": [[2,2,0.5]], "normal": [0,0,1], "quantity": "illuminance" } ] })";
  return readProject(folder.write("project.json", text));
}

bool warned(const Project& project, const std::string& words) {
  const auto& all = project.warnings.all();
  return std::any_of(all.begin(), all.end(), [&](const auto& d) { return d.message.find(words) != std::string::npos; });
}

TEST(PhotometricFileUse, ATm33FilesSpectrumIsTakenUnlessTheProjectStatesOne) {
  const test::TemporaryFolder folder;
  const Project own = read(folder, R"("photometry": "traced-opal-panel.xml")");
  const auto& spectrum = own.environment.sourceSpectra.at(own.environment.luminaires.at(0).spectrum);
  EXPECT_GT(spectrum.samples().size(), 20u);
  EXPECT_GT(spectrum.continuum(450), spectrum.continuum(490));  // a phosphor LED: blue peak, then a dip
  const Project stated = read(folder, R"("photometry": "traced-opal-panel.xml", "spectrum": 1)");
  EXPECT_TRUE(stated.environment.sourceSpectra.at(stated.environment.luminaires.at(0).spectrum).isFlat());
}

TEST(PhotometricFileUse, LampOutputAgainstTiltBelongsToTheAim) {
  const test::TemporaryFolder folder;
  folder.write(
      "lamp.ies",
      "IESNA:LM-63-2002\nTILT=INCLUDE\n1\n3\n0 45 90\n1.0 0.9 0.7\n1 1000 1 3 1 1 2 0 0 0\n1 1 10\n0 45 90\n0\n"
      "100 70 0\n");
  const Project upright = read(folder, R"("photometry": "lamp.ies")");
  const Project tilted = read(folder, R"("photometry": "lamp.ies", "aim": [0,1,-1])");
  const Project stated = read(folder, R"("photometry": "lamp.ies", "aim": [0,1,-1], "flux": 500)");
  EXPECT_NEAR(tilted.environment.luminaires[0].flux_lm / upright.environment.luminaires[0].flux_lm, 0.9, 1e-9);
  EXPECT_EQ(stated.environment.luminaires[0].flux_lm, 500);
  EXPECT_FALSE(warned(upright, "is tilted by 45 degrees"));
  EXPECT_TRUE(warned(tilted, "is tilted by 45 degrees"));
}

TEST(PhotometricFileUse, AHorizontalCylinderLiesAlongC0AndTurnsWithTheLuminaire) {
  const test::TemporaryFolder folder;
  const Project project = read(folder, R"("photometry": "tube-pendant.ies", "turn": 90)");
  const scene::Luminaire& luminaire = project.environment.luminaires.at(0);
  using emitter::Opening;
  EXPECT_EQ(luminaire.opening.shape, Opening::Shape::cylinder);
  EXPECT_DOUBLE_EQ(luminaire.opening.height, 1.2);
  EXPECT_DOUBLE_EQ(luminaire.opening.diameter, 0.028);
  const core::Vec3 axis = emitter::axesOf(luminaire.opening, luminaire.frame).z;
  EXPECT_NEAR(std::abs(glm::dot(axis, luminaire.frame.c0)), 1, 1e-12);
  EXPECT_NEAR(std::abs(axis.y), 1, 1e-12);  // C0 lay along x before the turn
}

TEST(PhotometricFileUse, ASurfaceOfRevolutionIsALuminairesOpening) {
  const test::TemporaryFolder folder;
  const Project project = read(folder, R"("photometry": { "goniometric": { "c0": [[0,100],[90,60],[180,0]] } },
      "shape": { "revolution": { "profile": [[0,-0.1],[0.1,-0.05],[0.12,0.05],[0,0.12]] } })");
  EXPECT_EQ(project.environment.luminaires.at(0).opening.profile.size(), 4u);
}

}  // namespace
}  // namespace goniolux::project
