// What is written is read back: every candela of every own file, in all three formats.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "photometry/comparison.h"
#include "photometry/photometric_file.h"
#include "photometry/transform.h"
#include "photometry/writers.h"
#include "support/shared_folder.h"

namespace goniolux::photometry {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> ownFiles() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(fs::path(GONIOLUX_SOURCE_DIR) / "luminaires"))
    for (const char* extension : {".ies", ".ldt", ".xml"})
      if (entry.path().extension() == extension) files.push_back(entry.path());
  return files;
}

double change(const TabulatedDistribution& before, const TabulatedDistribution& after) {
  const double largest = largestChange(before, after);
  return before.maximumIntensity() > 0 ? largest / before.maximumIntensity() : largest;
}

void expectKept(const PhotometricFile& file, const std::string& name) {
  for (const auto& [extension, allowed] : {std::pair{".ies", 0.0}, {".xml", 0.0}, {".ldt", 2.3e-16}}) {
    SCOPED_TRACE(name + " as " + extension);
    if (std::string(extension) == ".ldt" && file.distribution->type() != PhotometryType::c) continue;
    core::Diagnostics warnings;
    const PhotometricFile back =
        readPhotometry(writePhotometry(file, "x" + std::string(extension), warnings), "x" + std::string(extension));
    const auto& lost = warnings.all();
    if (std::any_of(lost.begin(), lost.end(), [](const auto& d) { return d.rule == "seam-lost"; })) continue;
    EXPECT_LE(change(*file.distribution, *back.distribution), allowed);
    EXPECT_EQ(back.distribution->verticalAngles(), file.distribution->verticalAngles());
    EXPECT_NEAR(back.distribution->flux(), file.distribution->flux(), 1e-12 * file.distribution->flux());
    EXPECT_EQ(back.inputWatts, file.inputWatts);
    EXPECT_EQ(back.declaredLumens.has_value(), file.declaredLumens.has_value());
    EXPECT_EQ(back.declaredLumens.value_or(0), file.declaredLumens.value_or(0));
  }
}

TEST(RoundTrip, KeepsEveryCandelaOfEveryOwnFileInEveryFormat) {
  int files = 0;
  for (const fs::path& path : ownFiles()) {
    expectKept(readPhotometricFile(path.string()), path.filename().string());
    ++files;
  }
  EXPECT_GE(files, 19);
}

// Files of makers have every oddity; the first of every ten that can be read.
TEST(RoundTrip, KeepsEveryCandelaOfFilesFromTheWild) {
  const auto shared = test::sharedFolder();
  if (!shared) GTEST_SKIP() << test::sharedFolderIsAbsent;
  int seen = 0, files = 0;
  std::vector<fs::path> paths;
  for (const auto& entry : fs::recursive_directory_iterator(*shared / "corpus" / "photometry"))
    if (entry.is_regular_file()) paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());
  for (const fs::path& path : paths) {
    if (++seen % 10 != 0) continue;
    try {
      expectKept(readPhotometricFile(path.string()), path.filename().string());
      ++files;
    } catch (const core::InputError&) {  // a broken file: nothing to keep
    }
  }
  EXPECT_GE(files, 20);
}

TEST(RoundTrip, KeepsOpeningsWhereTheFormatKnowsThem) {
  PhotometricFile file = readPhotometricFile((fs::path(GONIOLUX_SOURCE_DIR) / "luminaires" / "street.ldt").string());
  using Shape = StatedOpening::Shape;
  using Axis = StatedOpening::Axis;
  const auto kept = [&](const StatedOpening& opening, const char* extension) {
    file.opening = opening;
    core::Diagnostics warnings;
    const std::string name = std::string("x") + extension;
    const StatedOpening back = readPhotometry(writePhotometry(file, name, warnings), name).opening;
    const auto along = [](const StatedOpening& o, bool c90) { return o.lengthAlongC90 == c90 ? o.length : o.width; };
    EXPECT_EQ(back.shape, opening.shape);
    EXPECT_DOUBLE_EQ(along(back, false), along(opening, false));
    EXPECT_DOUBLE_EQ(along(back, true), along(opening, true));
    EXPECT_DOUBLE_EQ(back.height, opening.height);
    EXPECT_EQ((back.axis == Axis::lengthwise) != back.lengthAlongC90 && back.axis != Axis::aim,
              (opening.axis == Axis::lengthwise) != opening.lengthAlongC90 && opening.axis != Axis::aim);
    EXPECT_TRUE(warnings.all().empty());
  };
  for (const bool alongC90 : {false, true}) {
    const auto made = [&](Shape shape, Axis axis, double l, double w, double h) {
      StatedOpening opening;
      opening.shape = shape;
      opening.axis = axis;
      opening.length = l;
      opening.width = w;
      opening.height = h;
      opening.lengthAlongC90 = alongC90;
      return opening;
    };
    for (const char* extension : {".ies", ".ldt"}) {
      SCOPED_TRACE(extension);
      kept(made(Shape::point, Axis::aim, 0, 0, 0), extension);
      kept(made(Shape::rectangle, Axis::aim, 1.2, 0.3, 0), extension);
      kept(made(Shape::box, Axis::aim, 1.2, 0.3, 0.1), extension);
      kept(made(Shape::disc, Axis::aim, 0.2, 0.2, 0), extension);
      kept(made(Shape::cylinder, Axis::aim, 0.2, 0.2, 0.3), extension);
    }
    kept(made(Shape::rectangle, Axis::aim, 1.2, 0.3, 0), ".xml");
    kept(made(Shape::disc, Axis::aim, 0.4, 0.2, 0), ".ies");
    kept(made(Shape::sphere, Axis::aim, 0.4, 0.2, 0.3), ".ies");
    kept(made(Shape::disc, Axis::lengthwise, 0, 0.2, 0.2), ".ies");
    kept(made(Shape::cylinder, Axis::lengthwise, 1.2, 0.03, 0.03), ".ies");
    kept(made(Shape::cylinder, Axis::widthwise, 0.03, 1.2, 0.03), ".ies");
  }
}

TEST(Turning, IsWhatAQuarterTurnOfTheDirectionsIs) {
  for (const char* name : {"street.ldt", "wall-washer.ies", "linear-pendant.ldt", "downlight-gimbal.ldt"}) {
    SCOPED_TRACE(name);
    const PhotometricFile file = readPhotometricFile((fs::path(GONIOLUX_SOURCE_DIR) / "luminaires" / name).string());
    for (const double turn : {90.0, 180.0, 270.0, 37.0}) {
      const PhotometricFile other = turned(file, turn);
      const DistributionDifference apart = difference(*other.distribution, TurnedDistribution(file.distribution, turn));
      EXPECT_LT(apart.largest, 1e-9 * file.distribution->maximumIntensity()) << turn << " " << other.symmetry;
      EXPECT_NEAR(other.distribution->flux(), file.distribution->flux(), 1e-9 * file.distribution->flux());
    }
    const PhotometricFile back = turned(turned(file, 90), -90);
    EXPECT_EQ(back.symmetry, file.symmetry);
    EXPECT_EQ(back.opening.lengthAlongC90, file.opening.lengthAlongC90);
    EXPECT_EQ(change(*file.distribution, *back.distribution), 0);
  }
}

TEST(Diagrams, OfARotationalFileAreTheFileAndOneOfAnAsymmetricFileIsNot) {
  const auto file = [](const char* name) {
    return readPhotometricFile((fs::path(GONIOLUX_SOURCE_DIR) / "luminaires" / name).string());
  };
  const PhotometricFile round = file("high-bay.ldt"), washer = file("wall-washer.ies");
  EXPECT_LT(difference(*round.distribution, *oneDiagram(*round.distribution)).misplaced,
            1e-9 * round.distribution->flux());
  EXPECT_LT(difference(*round.distribution, *twoDiagrams(*round.distribution)).misplaced,
            1e-9 * round.distribution->flux());
  // The mean over C keeps the flux; what it cannot keep is where the light goes.
  const auto one = oneDiagram(*washer.distribution);
  EXPECT_NEAR(one->flux(), washer.distribution->flux(), 1e-3 * washer.distribution->flux());
  EXPECT_GT(difference(*washer.distribution, *one).misplaced, 0.2 * washer.distribution->flux());
}

}  // namespace
}  // namespace goniolux::photometry
