// Written EULUMDAT files: the five symmetry codes and one rule at a time.
#include "photometry/eulumdat.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace goniolux::photometry {
namespace {

bool hasWarning(const PhotometricFile& file, const std::string& rule) {
  const auto& all = file.warnings.all();
  return std::any_of(all.begin(), all.end(), [&](const core::Diagnostic& d) { return d.rule == rule; });
}

// The fields of a file, one a line, to be changed before it is written.
struct Fields {
  std::string isym = "0", mc = "4", dc = "90", ng = "3", dg = "45";
  std::string length = "600", width = "300", height = "0";
  std::string conversion = "1", ratio = "80";
  std::string lampSets = "1\n2\nT8\n2000\n840\n80\n72\n";
  std::string directRatios = "0\n0\n0\n0\n0\n0\n0\n0\n0\n0\n";
  std::string c = "0\n90\n180\n270\n", gamma = "0\n45\n90\n";
  std::string values = "100\n50\n0\n100\n60\n10\n100\n70\n20\n100\n80\n30\n";

  [[nodiscard]] std::string text() const {
    return "Company\n3\n" + isym + "\n" + mc + "\n" + dc + "\n" + ng + "\n" + dg +
           "\nreport\nluminaire\nnumber\nfile.ldt\ndate\n620\n320\n80\n" + length + "\n" + width + "\n" + height +
           "\n" + height + "\n" + height + "\n" + height + "\n95\n" + ratio + "\n" + conversion + "\n0\n" + lampSets +
           directRatios + c + gamma + values;
  }
};

PhotometricFile read(const Fields& fields) {
  return readEulumdat(fields.text(), "test.ldt");
}

TEST(Eulumdat, IntensitiesArePerThousandLumensOfTheLamps) {
  const PhotometricFile file = read({});
  EXPECT_EQ(file.format, "EULUMDAT");
  EXPECT_EQ(file.symmetry, "none");
  EXPECT_DOUBLE_EQ(file.distribution->atAngles(0, 0), 200);
  EXPECT_DOUBLE_EQ(file.distribution->atAngles(90, 45), 120);
  EXPECT_DOUBLE_EQ(file.distribution->atAngles(315, 45), (160 + 100) / 2.0);
  EXPECT_DOUBLE_EQ(*file.declaredLumens, 2000);
  EXPECT_DOUBLE_EQ(*file.declaredLuminaireLumens, 1600);
  EXPECT_DOUBLE_EQ(*file.lightOutputRatio, 0.8);
  EXPECT_DOUBLE_EQ(*file.downwardFraction, 0.95);
  EXPECT_DOUBLE_EQ(file.inputWatts, 72);
  EXPECT_EQ(file.keywords.at("LUMINAIRE"), "luminaire");
  EXPECT_TRUE(file.warnings.all().empty());
}

TEST(Eulumdat, SymmetryCode1StoresOnePlaneHoweverManyAreListed) {
  Fields fields;
  fields.isym = "1";
  fields.values = "100\n50\n0\n";
  const PhotometricFile file = read(fields);
  EXPECT_EQ(file.symmetry, "rotational");
  EXPECT_DOUBLE_EQ(file.distribution->atAngles(123, 45), 100);
}

TEST(Eulumdat, SymmetryCode2MirrorsAboutC0) {
  Fields fields;
  fields.isym = "2";
  fields.values = "100\n50\n0\n100\n60\n10\n100\n70\n20\n";
  const PhotometricFile file = read(fields);
  EXPECT_EQ(file.symmetry, "C0-C180");
  EXPECT_DOUBLE_EQ(file.distribution->atAngles(90, 45), 120);
  EXPECT_DOUBLE_EQ(file.distribution->atAngles(270, 45), 120);
  EXPECT_DOUBLE_EQ(file.distribution->atAngles(180, 45), 140);
}

TEST(Eulumdat, SymmetryCode3StoresC270ThroughC0ToC90) {
  Fields fields;
  fields.isym = "3";
  fields.values = "100\n50\n0\n100\n60\n10\n100\n70\n20\n";  // planes C270, C0, C90
  const PhotometricFile file = read(fields);
  EXPECT_EQ(file.symmetry, "C90-C270");
  EXPECT_DOUBLE_EQ(file.distribution->atAngles(270, 45), 100);
  EXPECT_DOUBLE_EQ(file.distribution->atAngles(0, 45), 120);
  EXPECT_DOUBLE_EQ(file.distribution->atAngles(180, 45), 120);
  EXPECT_DOUBLE_EQ(file.distribution->atAngles(90, 45), 140);
}

TEST(Eulumdat, SymmetryCode4MirrorsAboutBothPlanes) {
  Fields fields;
  fields.isym = "4";
  fields.values = "100\n50\n0\n100\n60\n10\n";
  const PhotometricFile file = read(fields);
  EXPECT_EQ(file.symmetry, "quadrant");
  for (const double c : {90.0, 270.0}) EXPECT_DOUBLE_EQ(file.distribution->atAngles(c, 45), 120);
  for (const double c : {0.0, 180.0}) EXPECT_DOUBLE_EQ(file.distribution->atAngles(c, 45), 100);
}

TEST(Eulumdat, WithoutSymmetryFewPlanesStillGoAllTheWayRound) {
  Fields fields;
  fields.mc = "2";
  fields.c = "0\n90\n";
  fields.values = "100\n50\n0\n100\n60\n10\n";
  const PhotometricFile file = read(fields);
  EXPECT_EQ(file.symmetry, "none");
  EXPECT_DOUBLE_EQ(file.distribution->atAngles(180, 45), 2 * (60 - 10.0 / 3));  // a third of the way from C90 to C360
}

TEST(Eulumdat, ANegativeLampCountIsAbsolutePhotometry) {
  Fields fields;
  fields.lampSets = "1\n-1\nLED\n1600\n840\n80\n20\n";
  fields.ratio = "100";
  const PhotometricFile file = read(fields);
  EXPECT_TRUE(file.absolute);
  EXPECT_FALSE(file.declaredLumens);
  EXPECT_DOUBLE_EQ(*file.declaredLuminaireLumens, 1600);
  EXPECT_DOUBLE_EQ(file.distribution->atAngles(0, 0), 160);
}

TEST(Eulumdat, TheFirstOfSeveralLampSetsIsUsedAndTheOthersAreNamed) {
  Fields fields;
  fields.lampSets = "2\n1\nA\n3000\n840\n80\n30\n1\nB\n5000\n840\n80\n50\n";
  const PhotometricFile file = read(fields);
  EXPECT_DOUBLE_EQ(file.distribution->atAngles(0, 0), 300);
  EXPECT_DOUBLE_EQ(file.inputWatts, 30);
  ASSERT_TRUE(hasWarning(file, "lamp-sets"));
  EXPECT_NE(file.warnings.all().front().message.find("B 5000 lm"), std::string::npos);
}

TEST(Eulumdat, DistancesOfZeroMeanThatTheListsCount) {
  Fields fields;
  fields.dc = fields.dg = "0";
  fields.gamma = "0\n20\n90\n";
  EXPECT_DOUBLE_EQ(read(fields).distribution->atAngles(0, 20), 100);
}

TEST(Eulumdat, DecimalCommasBlankFieldsAndCrLfAreRead) {
  Fields fields;
  fields.conversion = "1,0";
  fields.directRatios = "\n\n\n\n\n\n\n\n\n\n";
  fields.values = "100,5\n50\n0\n100\n60\n10\n100\n70\n20\n100\n80\n30\n";
  std::string text = fields.text();
  for (std::size_t i = 0; (i = text.find('\n', i)) != std::string::npos; i += 2) text.replace(i, 1, "\r\n");
  const PhotometricFile file = readEulumdat(text, "test.ldt");
  EXPECT_DOUBLE_EQ(file.distribution->atAngles(0, 0), 201);
  EXPECT_TRUE(hasWarning(file, "decimal-comma"));
  EXPECT_TRUE(hasWarning(file, "blank-field"));
}

TEST(Eulumdat, OpeningsAreInMillimetresAndLieAlongC90) {
  using Shape = StatedOpening::Shape;
  const auto opening = [](const char* length, const char* width, const char* height) {
    Fields fields;
    fields.length = length;
    fields.width = width;
    fields.height = height;
    return read(fields).opening;
  };
  const StatedOpening rectangle = opening("600", "300", "0");
  EXPECT_EQ(rectangle.shape, Shape::rectangle);
  EXPECT_DOUBLE_EQ(rectangle.length, 0.6);
  EXPECT_DOUBLE_EQ(rectangle.width, 0.3);
  EXPECT_TRUE(rectangle.lengthAlongC90);
  EXPECT_EQ(opening("600", "300", "50").shape, Shape::box);
  EXPECT_EQ(opening("200", "0", "0").shape, Shape::disc);
  EXPECT_DOUBLE_EQ(opening("200", "0", "0").width, 0.2);
  EXPECT_EQ(opening("200", "0", "50").shape, Shape::cylinder);
  EXPECT_EQ(opening("0", "0", "0").shape, Shape::point);
}

TEST(Eulumdat, TheConversionFactorMultipliesAndIsNamed) {
  Fields fields;
  fields.conversion = "1.5";
  const PhotometricFile file = read(fields);
  EXPECT_DOUBLE_EQ(file.distribution->atAngles(0, 0), 300);
  EXPECT_TRUE(hasWarning(file, "conversion-factor"));
}

}  // namespace
}  // namespace goniolux::photometry
