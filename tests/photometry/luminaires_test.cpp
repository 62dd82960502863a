// The repository's own photometric files: every one read, and its flux integrated a second way.
#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "photometry/flux_check.h"
#include "photometry/photometric_file.h"
#include "photometry/sphere_quadrature.h"

namespace goniolux::photometry {
namespace {

std::vector<std::filesystem::path> ownFiles() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::filesystem::path(GONIOLUX_SOURCE_DIR) / "luminaires")) {
    const std::string extension = entry.path().extension().string();
    if (extension == ".ies" || extension == ".ldt" || extension == ".xml") files.push_back(entry.path());
  }
  return files;
}

TEST(OwnLuminaires, AreReadWithoutAnyWarning) {
  const auto files = ownFiles();
  EXPECT_GE(files.size(), 12u);
  for (const auto& path : files) {
    const PhotometricFile file = readPhotometricFile(path.string());
    for (const core::Diagnostic& d : file.warnings.all()) ADD_FAILURE() << core::toString(d);
    EXPECT_NE(file.opening.shape, StatedOpening::Shape::other) << path;
    EXPECT_GT(file.inputWatts, 0) << path;
    EXPECT_EQ(file.opening.lengthAlongC90, path.extension() == ".ldt");
  }
}

// The files carry six digits.
TEST(OwnLuminaires, HaveTheFluxTheyDeclare) {
  for (const auto& path : ownFiles()) {
    const PhotometricFile file = readPhotometricFile(path.string());
    ASSERT_TRUE(file.declaredLuminaireLumens) << path;
    EXPECT_NEAR(file.distribution->flux(), *file.declaredLuminaireLumens, 1e-5 * *file.declaredLuminaireLumens) << path;
  }
}

// Composite Gauss quadrature of intensity() over directions, which knows nothing of the table's cells: its 0.5 x 1
// degree panels cut through kinks of the interpolant in C, hence 2e-4 for type C and 1e-3 for type B, whose lines lie
// across.
TEST(OwnLuminaires, HaveAFluxThatIndependentIntegrationConfirms) {
  for (const auto& path : ownFiles()) {
    const PhotometricFile file = readPhotometricFile(path.string());
    const TabulatedDistribution& d = *file.distribution;
    const double tolerance = d.type() == PhotometryType::c ? 2e-4 : 1e-3;
    EXPECT_NEAR(test::quadratureFlux(d), d.flux(), tolerance * d.flux()) << path;
    EXPECT_NEAR(test::quadratureFlux(d, 0, 90), d.forwardFlux(), tolerance * d.flux()) << path;
  }
}

TEST(OwnLuminaires, CoverEverySymmetryAndTheCommonOpenings) {
  std::set<std::string> symmetries;
  std::set<StatedOpening::Shape> shapes;
  std::set<StatedOpening::Axis> axes;
  std::set<PhotometryType> types;
  for (const auto& path : ownFiles()) {
    const PhotometricFile file = readPhotometricFile(path.string());
    symmetries.insert(file.symmetry + (path.extension() == ".ldt" ? " ldt" : ""));
    shapes.insert(file.opening.shape);
    axes.insert(file.opening.axis);
    types.insert(file.distribution->type());
  }
  for (const char* symmetry : {"rotational", "quadrant", "C0-C180", "C90-C270", "none", "lateral", "rotational ldt",
                               "quadrant ldt", "C0-C180 ldt", "C90-C270 ldt", "none ldt"}) {
    EXPECT_TRUE(symmetries.contains(symmetry)) << symmetry;
  }
  using Shape = StatedOpening::Shape;
  for (const Shape shape : {Shape::rectangle, Shape::disc, Shape::box, Shape::cylinder, Shape::sphere})
    EXPECT_TRUE(shapes.contains(shape));
  EXPECT_TRUE(types.contains(PhotometryType::a) && types.contains(PhotometryType::b));
  EXPECT_TRUE(axes.contains(StatedOpening::Axis::lengthwise));
  EXPECT_GE(ownFiles().size(), 25u);
}

TEST(OwnLuminaires, ThePanelIsLambertianAtItsTableAngles) {
  const PhotometricFile panel = readPhotometricFile(std::string(GONIOLUX_SOURCE_DIR) + "/luminaires/panel-600.ies");
  const TabulatedDistribution& d = *panel.distribution;
  for (const double gamma : d.verticalAngles()) {
    EXPECT_NEAR(d.atAngles(0, gamma), d.maximumIntensity() * std::cos(gamma * core::degree),
                5e-6 * d.maximumIntensity());
  }
}

// The tube lies along C90: I = I_perp sin(angle to the tube) wherever the spine above does not shade it.
TEST(OwnLuminaires, TheBattenFollowsTheSineLawOfATube) {
  const PhotometricFile batten = readPhotometricFile(std::string(GONIOLUX_SOURCE_DIR) + "/luminaires/batten-t8.ldt");
  const TabulatedDistribution& d = *batten.distribution;
  EXPECT_NEAR(d.atAngles(0, 45), d.atAngles(0, 0), 5e-6 * d.maximumIntensity());
  EXPECT_NEAR(d.atAngles(90, 60), d.atAngles(0, 0) * 0.5, 5e-6 * d.maximumIntensity());
}

}  // namespace
}  // namespace goniolux::photometry
