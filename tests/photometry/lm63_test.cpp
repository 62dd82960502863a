// Written LM-63 files: what the corpus lacks, and one rule at a time.
#include "photometry/lm63.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "support/temporary_folder.h"

namespace goniolux::photometry {
namespace {

PhotometricFile read(const std::string& text) {
  return readLm63(text, "test.ies");
}

bool hasWarning(const PhotometricFile& file, const std::string& rule) {
  const auto& all = file.warnings.all();
  return std::any_of(all.begin(), all.end(), [&](const core::Diagnostic& d) { return d.rule == rule; });
}

// The part from TILT= on: 1000 lm, three gamma angles, one plane.
std::string body(const std::string& dimensions = "0 0 0", const std::string& factors = "1 1 10") {
  return "TILT=NONE\n1 1000 1 3 1 1 2 " + dimensions + "\n" + factors + "\n0 45 90\n0\n100 70 0\n";
}

TEST(Lm63, EveryEditionIsKnownByItsFormatLine) {
  for (const auto& [line, name] : {std::pair{"IESNA86", "LM-63-1986"},
                                   {"IESNA91", "LM-63-1991"},
                                   {"IESNA:LM-63-1995", "LM-63-1995"},
                                   {"IESNA:LM-63-2002", "LM-63-2002"},
                                   {"IES:LM-63-2019", "LM-63-2019"}}) {
    const PhotometricFile file = read(std::string(line) + "\n" + body());
    EXPECT_EQ(file.format, name);
    EXPECT_TRUE(file.warnings.all().empty()) << core::toString(file.warnings.all().front());
  }
}

TEST(Lm63, OddFormatLinesAreReadAsTheNearestEditionAndSaidSo) {
  for (const auto& [line, name] : {std::pair{"IESNA95", "LM-63-1995"},
                                   {"IESNA94", "LM-63-1995"},
                                   {"IESNA:LM-63-2019", "LM-63-2019"},
                                   {"IESNA:LM-63-1991", "LM-63-1991"},
                                   {"iesna:lm-63-2002 ", "LM-63-2002"}}) {
    const PhotometricFile file = read(std::string(line) + "\n" + body());
    EXPECT_EQ(file.format, name) << line;
    EXPECT_EQ(hasWarning(file, "odd-format-line"), line[0] == 'I') << line;
  }
}

TEST(Lm63, WithoutAFormatLineItIs1986) {
  const PhotometricFile file = read("a luminaire\n" + body());
  EXPECT_EQ(file.format, "LM-63-1986");
  EXPECT_TRUE(hasWarning(file, "format-line-missing"));
  EXPECT_EQ(file.keywords.at("TEXT"), "a luminaire");
}

// project-format.md, "Flux": the 12th number multiplies in 1986 and 1991 only.
TEST(Lm63, TheTwelfthNumberIsABallastLampFactorOnlyInTheFirstTwoEditions) {
  for (const auto& [line, factor] :
       {std::pair{"IESNA91", 0.8}, {"IESNA:LM-63-1995", 1.0}, {"IESNA:LM-63-2002", 1.0}, {"IES:LM-63-2019", 1.0}}) {
    const PhotometricFile file = read(std::string(line) + "\n" + body("0 0 0", "0.5 0.8 10"));
    EXPECT_DOUBLE_EQ(file.distribution->maximumIntensity(), 100 * 0.5 * factor) << line;
  }
  EXPECT_TRUE(hasWarning(read("IESNA91\n" + body("0 0 0", "1 0.8 10")), "ballast-lamp-factor"));
  EXPECT_TRUE(hasWarning(read("IESNA:LM-63-2002\n" + body("0 0 0", "1 0.8 10")), "future-use"));
  EXPECT_FALSE(hasWarning(read("IES:LM-63-2019\n" + body("0 0 0", "1 1.0001 10")), "future-use"));
}

TEST(Lm63, MultiplierAndBallastFactorMultiplyTheCandelas) {
  const PhotometricFile file = read("IESNA:LM-63-2002\nTILT=NONE\n2 1500 3 2 1 1 1 0 0 0 0.5 1 40\n0 90\n0\n10 4\n");
  EXPECT_DOUBLE_EQ(file.distribution->candela(0, 0), 15);
  EXPECT_DOUBLE_EQ(file.distribution->candela(0, 1), 6);
  EXPECT_DOUBLE_EQ(*file.declaredLumens, 3000);
  EXPECT_DOUBLE_EQ(file.inputWatts, 40);
  EXPECT_FALSE(file.absolute);
}

TEST(Lm63, MinusOneLumensIsAbsolutePhotometry) {
  const PhotometricFile file =
      read("IESNA:LM-63-2002\n[_TOTALLUMINAIRELUMENS] 300\nTILT=NONE\n4 -1 1 2 1 1 2 0 0 0\n1 1 40\n0 90\n0\n10 4\n");
  EXPECT_TRUE(file.absolute);
  EXPECT_FALSE(file.declaredLumens);
  EXPECT_DOUBLE_EQ(*file.declaredLuminaireLumens, 300);
}

TEST(Lm63, LineEndsTabsCommasAndWrappedNumbersMakeNoDifference) {
  const std::string plain = "IESNA:LM-63-2002\n[TEST] x\n" + body();
  const double flux = read(plain).distribution->flux();
  for (const std::string& text :
       {std::string("IESNA:LM-63-2002\r\n[TEST] x\r\nTILT=NONE\r\n1 1000 1 3 1 1 2 0 0 0\r\n1 1 10\r\n0 45 "
                    "90\r\n0\r\n100 70 0\r\n"),
        std::string("IESNA:LM-63-2002\r[TEST] x\rTILT=NONE\r1 1000 1 3 1 1 2 0 0 0\r1 1 10\r0 45 90\r0\r100 70 0"),
        std::string("IESNA:LM-63-2002\n[TEST] x\n TILT = NONE "
                    "\n1\n1000\n1\n3\n1\n1\n2\n0\n0\n0\n1\n1\n10\n0\n45\n90\n0\n100\n70\n0\n"),
        std::string(
            "IESNA:LM-63-2002\n\n[TEST] x\ntilt=none\n\t1\t1000\t1\t3\t1\t1\t2\t0\t0\t0 1 1 10 0 45 90 0 100 70 0"),
        std::string("IESNA:LM-63-2002\n[TEST] x\nTILT=NONE\n1,1000,1,3,1,1,2,0,0,0\n1,1,10\n0,45,90\n0\n100, 70, 0\n"),
        std::string("IESNA:LM-63-2002\n[TEST]x\nTILT=NONE\n1 1000 1 3 1 1 2 0 0 0\n1 1 10\n0 45 90\n0\n1.0E+0002 7e1 "
                    "0\n\x1A garbage")}) {
    const PhotometricFile file = read(text);
    EXPECT_DOUBLE_EQ(file.distribution->flux(), flux);
    EXPECT_EQ(file.keywords.at("TEST"), "x");
    EXPECT_TRUE(file.warnings.all().empty()) << core::toString(file.warnings.all().front());
  }
}

TEST(Lm63, DecimalCommasAreReadWhereNothingElseMakesSense) {
  const PhotometricFile file = read(
      "IESNA:LM-63-2002\nTILT=NONE\n1 1000 1,0 3 1 1 2 0,6 0,6 0\n1,0 1,0 10,5\n0,0 45,0 90,0\n0,0\n100,5 70,25 0,0\n");
  EXPECT_TRUE(hasWarning(file, "decimal-comma"));
  EXPECT_DOUBLE_EQ(file.distribution->candela(0, 0), 100.5);
  EXPECT_DOUBLE_EQ(file.opening.length, 0.6);
  EXPECT_DOUBLE_EQ(file.inputWatts, 10.5);
}

TEST(Lm63, MoreContinuesAKeywordAndRepeatsAreKept) {
  const PhotometricFile file =
      read("IESNA:LM-63-2002\n[LUMINAIRE] first\n[MORE] second\n[OTHER] a\n[OTHER] b\n[lumcat]L1\n" + body());
  EXPECT_EQ(file.keywords.at("LUMINAIRE"), "first\nsecond");
  EXPECT_EQ(file.keywords.at("OTHER"), "a\nb");
  EXPECT_EQ(file.keywords.at("LUMCAT"), "L1");
}

TEST(Lm63, KeywordsBecomeUtf8FromLatin1AndShiftJis) {
  EXPECT_EQ(read("IESNA:LM-63-2002\n[MANUFAC] L\xE4ngle\n" + body()).keywords.at("MANUFAC"), "L\xC3\xA4ngle");
  EXPECT_EQ(read("IESNA:LM-63-2002\n[MANUFAC] \x92\xE8\x8A\x69\n" + body()).keywords.at("MANUFAC"),
            "\xE5\xAE\x9A\xE6\xA0\xBC");
  EXPECT_EQ(read("\xEF\xBB\xBFIESNA:LM-63-2002\n[MANUFAC] L\xC3\xA4ngle\n" + body()).keywords.at("MANUFAC"),
            "L\xC3\xA4ngle");
}

TEST(Lm63, TiltIncludeIsKeptAndTheFactorOfZeroDegreesMultiplies) {
  const PhotometricFile file = read(
      "IESNA:LM-63-2002\nTILT=INCLUDE\n2\n3\n0 45 90\n1.0 0.9 0.8\n1 1000 1 3 1 1 2 0 0 0\n1 1 10\n0 45 90\n0\n100 70 "
      "0\n");
  ASSERT_TRUE(file.tilt);
  EXPECT_EQ(file.tilt->lampToLuminaireGeometry, 2);
  EXPECT_EQ(file.tilt->angles, (std::vector<double>{0, 45, 90}));
  EXPECT_EQ(file.tilt->factors, (std::vector<double>{1.0, 0.9, 0.8}));
  EXPECT_TRUE(hasWarning(file, "tilt-factor"));
  EXPECT_DOUBLE_EQ(tiltFactor(*file.tilt, 22.5), 0.95);
  EXPECT_DOUBLE_EQ(tiltFactor(*file.tilt, 120), 0.8);
  EXPECT_DOUBLE_EQ(file.distribution->maximumIntensity(), 100);
  const PhotometricFile odd = read(
      "IESNA:LM-63-2002\nTILT=INCLUDE\n1\n2\n0 90\n0.5 1.0\n1 1000 1 3 1 1 2 0 0 0\n1 1 10\n0 45 90\n0\n100 70 0\n");
  EXPECT_DOUBLE_EQ(odd.distribution->maximumIntensity(), 50);
  // What it changes stands in the message, in lumens.
  const double flux = odd.distribution->flux();
  EXPECT_NE(odd.warnings.all().front().message.find(fmt::format("{:.6g} lm otherwise", 2 * flux)), std::string::npos)
      << odd.warnings.all().front().message;
}

TEST(Lm63, ATiltFileIsFoundBesideThePhotometricFile) {
  const test::TemporaryFolder folder;
  folder.write("lamp.tlt", "1\n2\n0 90\n1 0.7\n");
  const std::string text = "IESNA:LM-63-2002\nTILT=lamp.tlt\n1 1000 1 3 1 1 2 0 0 0\n1 1 10\n0 45 90\n0\n100 70 0\n";
  const PhotometricFile found = readLm63(text, (folder.path() / "a.ies").string());
  ASSERT_TRUE(found.tilt);
  EXPECT_EQ(found.tilt->factors, (std::vector<double>{1, 0.7}));
  const PhotometricFile missing = readLm63(text, (folder.path() / "elsewhere" / "a.ies").string());
  EXPECT_FALSE(missing.tilt);
  EXPECT_TRUE(hasWarning(missing, "tilt-file-missing"));
}

TEST(Lm63, TypeAAndTypeBAreReadWithTheirAngles) {
  for (const auto& [code, type] : {std::pair{"3", PhotometryType::a}, {"2", PhotometryType::b}}) {
    const PhotometricFile file = read(std::string("IESNA:LM-63-2002\nTILT=NONE\n1 -1 1 3 3 ") + code +
                                      " 2 0.3 0.4 0\n1 1 100\n-90 0 90\n-90 0 90\n0 0 0\n0 1000 0\n0 0 0\n");
    EXPECT_EQ(file.distribution->type(), type);
    EXPECT_NEAR(file.distribution->intensity({0, 0, 1}), 1000, 1e-9);
    EXPECT_EQ(file.symmetry, "none");
    // I = 1000 (1 - |a|/90)(1 - |b|/90): the cosine-weighted angle integrates to 2 (2/pi), the other to pi/2.
    EXPECT_NEAR(file.distribution->flux(), 1000 * (4 / core::pi) * (core::pi / 2), 1e-6);
  }
}

TEST(Lm63, HorizontalRangesNameTheSymmetry) {
  const auto withPlanes = [](const std::string& planes, int count) {
    std::string text =
        "IESNA:LM-63-2002\nTILT=NONE\n1 -1 1 2 " + std::to_string(count) + " 1 2 0 0 0\n1 1 9\n0 90\n" + planes + "\n";
    for (int i = 0; i < count; ++i) text += "10 5\n";
    return read(text);
  };
  EXPECT_EQ(withPlanes("0", 1).symmetry, "rotational");
  EXPECT_EQ(withPlanes("0 45 90", 3).symmetry, "quadrant");
  EXPECT_EQ(withPlanes("0 90 180", 3).symmetry, "C0-C180");
  EXPECT_EQ(withPlanes("90 180 270", 3).symmetry, "C90-C270");
  EXPECT_EQ(withPlanes("0 180 360", 3).symmetry, "none");
  EXPECT_EQ(withPlanes("0 120 240", 3).symmetry, "none");
  EXPECT_FALSE(hasWarning(withPlanes("0 120 240", 3), "horizontal-gap"));
  EXPECT_TRUE(hasWarning(withPlanes("0 100 200", 3), "horizontal-gap"));  // 160 degrees without a plane
}

TEST(Lm63, OpeningsOfEveryEditionBecomeShapes) {
  using Shape = StatedOpening::Shape;
  struct Case {
    Lm63Edition edition;
    double w, l, h;
    Shape shape;
    double length, width, height;
  };
  const auto e86 = Lm63Edition::e1986, e95 = Lm63Edition::e1995, e02 = Lm63Edition::e2002;
  for (const Case& c : std::vector<Case>{{e02, 0, 0, 0, Shape::point, 0, 0, 0},
                                         {e02, 0.3, 1.2, 0, Shape::rectangle, 1.2, 0.3, 0},
                                         {e02, 0.3, 1.2, 0.1, Shape::box, 1.2, 0.3, 0.1},
                                         {e95, -0.2, 0, 0, Shape::disc, 0.2, 0.2, 0},
                                         {e02, -0.2, 0, 0, Shape::disc, 0.2, 0.2, 0},
                                         {e02, -0.2, -0.2, 0, Shape::disc, 0.2, 0.2, 0},
                                         {e86, -0.2, -0.2, 0, Shape::disc, 0.2, 0.2, 0},
                                         {e95, -0.2, 0, 0.3, Shape::cylinder, 0.2, 0.2, 0.3},
                                         {e02, -0.2, -0.2, 0.3, Shape::cylinder, 0.2, 0.2, 0.3},
                                         {e95, -0.2, 0, -0.2, Shape::sphere, 0.2, 0.2, 0.2},
                                         {e02, -0.2, -0.2, -0.2, Shape::sphere, 0.2, 0.2, 0.2},
                                         {e02, -0.2, 0, -0.2, Shape::disc, 0, 0.2, 0.2},
                                         {e02, -0.2, -0.4, 0, Shape::disc, 0.4, 0.2, 0},
                                         {e95, 0, 1.2, -0.03, Shape::cylinder, 1.2, 0.03, 0.03},
                                         {e02, -0.03, 1.2, -0.03, Shape::cylinder, 1.2, 0.03, 0.03}}) {
    const StatedOpening opening = lm63Opening(c.edition, c.w, c.l, c.h, 1);
    EXPECT_EQ(opening.shape, c.shape) << c.w << " " << c.l << " " << c.h;
    EXPECT_DOUBLE_EQ(opening.length, c.length);
    EXPECT_DOUBLE_EQ(opening.width, c.width);
    EXPECT_DOUBLE_EQ(opening.height, c.height);
    EXPECT_EQ(opening.note.empty(), c.shape != Shape::other);
    EXPECT_FALSE(opening.lengthAlongC90);
  }
  using Axis = StatedOpening::Axis;
  EXPECT_EQ(lm63Opening(e02, -0.03, 1.2, -0.03, 1).axis, Axis::lengthwise);
  EXPECT_EQ(lm63Opening(e02, 0.6, -0.03, -0.03, 1).axis, Axis::widthwise);
  EXPECT_EQ(lm63Opening(e02, -0.2, 0, -0.2, 1).axis, Axis::lengthwise);
  EXPECT_EQ(lm63Opening(e86, -0.2, 0.4, 0.1, 1).shape, Shape::sphere);  // an ellipsoid
  EXPECT_EQ(lm63Opening(e95, -0.2, 0.4, 0.1, 1).shape, Shape::cylinder);
  EXPECT_EQ(lm63Opening(e02, 0, 1.2, 0, 1).shape, Shape::line);
  EXPECT_FALSE(lm63Opening(e02, 0, -0.1, 0.2, 1).note.size() > 0);
  EXPECT_EQ(lm63Opening(e02, 0, 0, -1, 1).shape, Shape::other);
  EXPECT_FALSE(lm63Opening(e02, 0, 0, -1, 1).note.empty());
}

TEST(Lm63, FeetBecomeMetres) {
  EXPECT_DOUBLE_EQ(lm63Opening(Lm63Edition::e2002, 2, 4, 0, 0.3048).length, 1.2192);
  const PhotometricFile file = read("IESNA:LM-63-2002\nTILT=NONE\n1 -1 1 2 1 1 1 2 4 0\n1 1 9\n0 90\n0\n10 5\n");
  EXPECT_DOUBLE_EQ(file.opening.length, 1.2192);
  EXPECT_DOUBLE_EQ(file.opening.width, 0.6096);
}

TEST(Lm63, RadiometricFilesAreSaidToBeSo) {
  const PhotometricFile file = read("IESNA:LM-63-2002\n[_INTENSITYUNITS] mW/sr\n" + body());
  EXPECT_TRUE(file.radiometric);
  EXPECT_TRUE(hasWarning(file, "radiometric-units"));
  EXPECT_DOUBLE_EQ(file.distribution->maximumIntensity(), 100);
}

TEST(Lm63, WhatFollowsTheLastCandelaIsReported) {
  EXPECT_TRUE(hasWarning(read("IESNA:LM-63-2002\n" + body() + "1 2 3\n"), "trailing-numbers"));
  EXPECT_TRUE(hasWarning(read("IESNA:LM-63-2002\n" + body() + "the end\n"), "trailing-text"));
  EXPECT_TRUE(read("IESNA:LM-63-2002\n" + body() + " \r\n\t\n").warnings.all().empty());
}

TEST(Lm63, ClaimsThatDifferAtThePolesAndTheSeamAreReported) {
  const PhotometricFile file =
      read("IESNA:LM-63-2002\nTILT=NONE\n1 -1 1 2 3 1 2 0 0 0\n1 1 9\n0 90\n0 180 360\n100 5\n90 5\n100 15\n");
  EXPECT_TRUE(hasWarning(file, "pole-differs"));
  EXPECT_TRUE(hasWarning(file, "seam-differs"));
}

TEST(Lm63, TheRealRangeOfVerticalAnglesIsKept) {
  const PhotometricFile file =
      read("IESNA:LM-63-2002\nTILT=NONE\n1 -1 1 3 1 1 2 0 0 0\n1 1 9\n0 90 140\n0\n100 50 20\n");
  EXPECT_TRUE(hasWarning(file, "vertical-range"));
  EXPECT_EQ(file.distribution->atAngles(0, 141), 0);
  EXPECT_EQ(file.distribution->atAngles(0, 140), 20);
}

}  // namespace
}  // namespace goniolux::photometry
