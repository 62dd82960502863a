#include "pipeline/polar.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "pipeline/luminaire_figures.h"
#include "support/temporary_folder.h"

namespace goniolux::pipeline {
namespace {

photometry::PhotometricFile sample(const std::vector<double>& horizontal) {
  std::vector<double> vertical, candelas;
  for (int v = 0; v <= 90; v += 5) vertical.push_back(v);
  for (const double h : horizontal) {
    for (const double v : vertical) candelas.push_back(1000 * std::cos(v * core::degree) * (1 + h / 180));
  }
  photometry::PhotometricFile file;
  file.file = "folder/panel <1>.ies";
  file.format = "LM-63-2002";
  file.symmetry = horizontal.size() == 1 ? "rotational" : "quadrant";
  file.distribution = std::make_shared<photometry::TabulatedDistribution>(photometry::PhotometryType::c, horizontal,
                                                                          vertical, candelas);
  return file;
}

double at(const plot::PolarCurve& curve, double degrees) {
  for (const auto& [angle, value] : curve.points) {
    if (angle == degrees) return value;
  }
  return -1;
}

TEST(PolarDiagram, HasTheFilesIntensitiesAtItsAngles) {
  const plot::PolarDiagram diagram = polarDiagramOf(sample({0, 90}));
  ASSERT_EQ(diagram.curves.size(), 2U);
  for (const double gamma : {5.0, 30.0, -30.0, 85.0}) {
    EXPECT_NEAR(at(diagram.curves[0], gamma), 1000 * std::cos(gamma * core::degree), 1e-6) << gamma;
    EXPECT_NEAR(at(diagram.curves[1], gamma), 1500 * std::cos(gamma * core::degree), 1e-6) << gamma;
  }
  EXPECT_EQ(at(diagram.curves[0], 120), 0);
}

TEST(PolarDiagram, HasOneCurveWhereAllPlanesAreAlike) {
  EXPECT_EQ(polarDiagramOf(sample({0})).curves.size(), 1U);
}

TEST(PolarDiagram, IsDrawnAndReadBack) {
  const test::TemporaryFolder folder;
  for (const char* name : {"polar.svg", "polar.png"}) {
    core::Diagnostics warnings;
    EXPECT_TRUE(drawLuminaire(sample({0, 90}), "polar", (folder.path() / name).string(), warnings));
    EXPECT_TRUE(warnings.all().empty());
    EXPECT_GT(std::filesystem::file_size(folder.path() / name), 5000U);
  }
  const std::string svg = test::contentOf(folder.path() / "polar.svg");
  for (const char* words : {">90°</text>", ">0°</text>", ">1500</text>", "panel &lt;1&gt;.ies", "C90 (right) – C270"}) {
    EXPECT_NE(svg.find(words), std::string::npos) << words;
  }
  const std::string text = core::toJson(plot::toJson(polarDiagramOf(sample({0, 90}))));
  core::Diagnostics diagnostics;
  EXPECT_EQ(core::toJson(plot::toJson(plot::polarDiagramFromJson(core::parseJson(text, "f", diagnostics)))), text);
}

TEST(LuminaireFigures, OfEveryKindAreDrawnAndReadBack) {
  const test::TemporaryFolder folder;
  photometry::PhotometricFile file = sample({0, 90});
  file.opening.shape = photometry::StatedOpening::Shape::rectangle;
  file.opening.length = file.opening.width = 0.6;
  for (const char* kind : {"cartesian", "solid", "near-field"}) {
    SCOPED_TRACE(kind);
    core::Diagnostics warnings;
    const std::string picture = (folder.path() / (std::string(kind) + ".svg")).string();
    EXPECT_TRUE(drawLuminaire(file, kind, picture, warnings));
    EXPECT_GT(std::filesystem::file_size(picture), 5000U);
  }
  const auto roundTrip = [](const core::Value& figure) {
    core::Diagnostics diagnostics;
    return core::parseJson(core::toJson(figure), "f", diagnostics);
  };
  const core::Value chart = plot::toJson(cartesianDiagramOf(file));
  EXPECT_EQ(core::toJson(plot::toJson(plot::lineChartFromJson(roundTrip(chart)))), core::toJson(chart));
  const core::Value solid = plot::toJson(photometricSolidOf(file));
  EXPECT_EQ(core::toJson(plot::toJson(plot::photometricSolidFromJson(roundTrip(solid)))), core::toJson(solid));
  core::Diagnostics warnings;
  EXPECT_THROW(drawLuminaire(file, "round", (folder.path() / "x.svg").string(), warnings), core::InputError);
  EXPECT_THROW(nearFieldChartOf(sample({0})), core::InputError);  // no opening
}

// The legend's end is the largest intensity that the title states, in whatever plane it lies.
TEST(PhotometricSolid, IsAsLongAsTheLargestIntensityOfItsFile) {
  for (const char* name : {"traced-batten-reflector.ldt", "traced-spot-barn-doors.ies", "street.ldt",
                           "floodlight-b.ies", "searchlight-a.ies", "wall-washer.ies", "downlight-15.ies"}) {
    const auto file = photometry::readPhotometricFile(std::string(GONIOLUX_SOURCE_DIR) + "/luminaires/" + name);
    const plot::PhotometricSolid solid = photometricSolidOf(file);
    const double largest = *std::max_element(solid.values.begin(), solid.values.end());
    EXPECT_NEAR(largest / file.distribution->maximumIntensity(), 1, 1e-9) << name;
  }
}

TEST(PolarDiagram, SaysWhenItCannotBeDrawnAndRefusesOtherEndings) {
  const test::TemporaryFolder folder;
  setenv("GONIOLUX_PLOT", "/nonexistent", 1);
  core::Diagnostics warnings;
  EXPECT_FALSE(drawLuminaire(sample({0}), "polar", (folder.path() / "polar.png").string(), warnings));
  unsetenv("GONIOLUX_PLOT");
  ASSERT_EQ(warnings.all().size(), 1U);
  EXPECT_THROW(drawLuminaire(sample({0}), "polar", (folder.path() / "polar.jpg").string(), warnings), core::InputError);
}

}  // namespace
}  // namespace goniolux::pipeline
