// TM-33: the standard's own layout, its look-alikes, and what is refused, each with its line.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "photometry/photometric_file.h"
#include "photometry/rules.h"

namespace goniolux::photometry {
namespace {

std::string document(const std::string& emitter) {
  return "<?xml version=\"1.0\"?>\n<IESTM33>\n<Version>1.0</Version>\n<Header><Manufacturer>M&amp;N</Manufacturer>"
         "</Header>\n<Emitter>\n" +
         emitter + "</Emitter>\n</IESTM33>\n";
}

const std::string intensities =
    "<LuminousData><LuminousIntensity>\n<IntData h=\"0\" v=\"0\">100</IntData>\n<IntData h=\"0\" v=\"90\">0</IntData>\n"
    "<IntData h=\"90\" v=\"0\">100</IntData>\n<IntData h=\"90\" v=\"90\">20.5</IntData>\n</LuminousIntensity>"
    "</LuminousData>\n";

PhotometricFile read(const std::string& text, Strictness strictness = Strictness::lenient) {
  return readPhotometry(text, "sample.xml", strictness);
}

bool hasWarning(const PhotometricFile& file, const std::string& rule) {
  const auto& all = file.warnings.all();
  return std::any_of(all.begin(), all.end(), [&](const auto& d) { return d.rule == rule; });
}

core::Diagnostic refusal(const std::string& text) {
  try {
    (void)read(text);
  } catch (const core::InputError& error) {
    return error.diagnostics().all().front();
  }
  ADD_FAILURE() << "was read: " << text;
  return {};
}

TEST(Tm33, StandardLayoutGivesTheTableTheOpeningAndTheSpectrum) {
  const PhotometricFile file = read(document(
      "<RatedLumens>500</RatedLumens><InputWattage>12</InputWattage>\n" + intensities +
      "<EmissionAreas><BottomFace><BottomArea><Length>0.5</Length><Width>0.6</Width><LengthOffset>-0.3</LengthOffset>"
      "</BottomArea><BottomArea><Length>0.5</Length><Width>0.6</Width><LengthOffset>0.3</LengthOffset></BottomArea>"
      "</BottomFace></EmissionAreas>\n<SpectralData><EmitterSpectral><PwrData w=\"400\">0.1</PwrData>"
      "<PwrData w=\"500\">1</PwrData></EmitterSpectral></SpectralData>\n"));
  EXPECT_EQ(file.format, "TM-33-18");
  EXPECT_EQ(file.keywords.at("MANUFAC"), "M&N");
  EXPECT_EQ(file.symmetry, "quadrant");
  EXPECT_EQ(file.distribution->candela(1, 1), 20.5);
  EXPECT_EQ(file.declaredLumens, 500);
  EXPECT_EQ(file.inputWatts, 12);
  EXPECT_EQ(file.opening.shape, StatedOpening::Shape::rectangle);
  EXPECT_DOUBLE_EQ(file.opening.length, 1.1);  // both areas, and what lies between
  EXPECT_DOUBLE_EQ(file.opening.width, 0.6);
  ASSERT_TRUE(file.spectrum);
  EXPECT_DOUBLE_EQ(file.spectrum->continuum(450), 0.55);
}

TEST(Tm33, WithoutSymmetryAListOfPlanesGoesAllTheWayRound) {
  std::string text = intensities;
  text.insert(text.find("<IntData"), "<Symm>Symm_None</Symm>");
  const PhotometricFile file = read(document(text));
  EXPECT_EQ(file.symmetry, "none");
  EXPECT_NEAR(file.distribution->atAngles(270, 90), 20.5 / 3, 1e-12);  // from C90 on to C360 = C0
}

TEST(Tm33, PhotonsAreReadUnconvertedWithTheirUnit) {
  std::string text = document(intensities);
  for (const auto& [from, to] :
       {std::pair<std::string, std::string>{"LuminousData", "PhotonData"}, {"LuminousIntensity", "PhotonIntensity"}})
    for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
      text.replace(at, from.size(), to);
  const PhotometricFile file = read(text);
  EXPECT_TRUE(file.radiometric);
  EXPECT_EQ(file.fluxUnit, "umol/s");
  EXPECT_TRUE(hasWarning(file, "radiometric-units"));
  EXPECT_EQ(file.distribution->candela(0, 0), 100);
}

TEST(Tm33, WhatIsMissingOrWrongIsRefusedAtItsLine) {
  std::string missing = document(intensities);
  missing.erase(missing.find("<IntData h=\"90\" v=\"0\">100</IntData>\n"), 36);
  EXPECT_EQ(refusal(missing).rule, "table-incomplete");
  EXPECT_EQ(refusal(missing).position.line, 9);
  std::string word = document(intensities);
  word.replace(word.find("20.5"), 4, "much");
  EXPECT_EQ(refusal(word).rule, "not-a-number");
  EXPECT_EQ(refusal(word).position.line, 10);
  EXPECT_EQ(refusal(document("")).rule, "no-intensities");
  EXPECT_EQ(refusal("<IESTM33>\n<Emitter>\n</IESTM33>").rule, "bad-xml");
  std::string twice = document(intensities);
  twice.replace(twice.find("h=\"90\" v=\"90\""), 13, "h=\"90\" v=\"0\" ");
  EXPECT_EQ(refusal(twice).rule, "table-incomplete");
}

// Found by fuzzing: a table of one direction has no interval to look into.
TEST(Tm33, ATableOfOneVerticalAngleIsRefused) {
  const std::string one =
      "<LuminousData><LuminousIntensity>\n<IntData h=\"90\" "
      "v=\"90\">20</IntData>\n</LuminousIntensity></LuminousData>\n";
  EXPECT_EQ(refusal(document(one)).rule, "bad-count");
  EXPECT_EQ(refusal(document(one)).position.line, 6);
}

TEST(StrictReading, RefusesWhatLenientReadingOnlyWarnsOf) {
  std::string dialect = document(intensities);
  for (const char* tag : {"<IESTM33>", "</IESTM33>"})
    dialect.replace(dialect.find(tag) + std::string(tag).find("IES"), 7, "IESXML ");
  EXPECT_TRUE(hasWarning(read(dialect), "tm33-dialect"));
  EXPECT_THROW((void)read(dialect, Strictness::strict), core::InputError);
  EXPECT_NO_THROW((void)read(document(intensities), Strictness::strict));
  const std::string trailing =
      "IESNA:LM-63-2002\nTILT=NONE\n1 1000 1 2 1 1 2 0 0 0 1 1 10\n0 90\n0\n300 0\n7 and more\n";
  EXPECT_NO_THROW((void)readPhotometry(trailing, "a.ies"));
  try {
    (void)readPhotometry(trailing, "a.ies", Strictness::strict);
    FAIL();
  } catch (const core::InputError& error) {
    ASSERT_EQ(error.diagnostics().all().size(), 1u);
    EXPECT_EQ(error.diagnostics().all().front().rule, "trailing-numbers");
    EXPECT_EQ(error.diagnostics().all().front().position.line, 7);
  }
}

}  // namespace
}  // namespace goniolux::photometry
