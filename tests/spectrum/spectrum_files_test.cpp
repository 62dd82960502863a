#include "spectrum/spectrum_files.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "spectrum/cie_data.h"
#include "support/shared_folder.h"
#include "support/temporary_folder.h"

namespace goniolux::spectrum {
namespace {

// All messages of the InputError that `text` gives, one a line; "" when it is read.
std::string complaint(const std::string& text, Role role, const std::string& name = "file.spd") {
  try {
    readSpectrum(text, name, role);
  } catch (const core::InputError& error) {
    std::string all;
    for (const auto& each : error.diagnostics().all()) all += core::toString(each) + "\n";
    return all;
  }
  return "";
}

::testing::AssertionResult says(const std::string& complaint, const std::string& part) {
  if (complaint.find(part) != std::string::npos) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << "'" << part << "' is not in:\n" << complaint;
}

TEST(SpectrumFiles, EverySeparatorGivesTheSameSpectrum) {
  const auto expected =
      SpectralDistribution::sampled({{400, 0.25}, {550.5, 0.5}, {700, 0.125}}, SpectralDistribution::Outside::hold);
  for (const char* text : {"400,0.25\n550.5,0.5\n700,0.125\n", "400;0.25\n550.5;0.5\n700;0.125",
                           "400\t.25\r\n550.5\t.5\r\n700\t.125\r\n", "400 0.25\n550.5   5e-1\n 700 0.125\n",
                           "400, 0.25\n550.5, 0.5\n700, 0.125,\n", "400;0,25\n550,5;0,5\n700;0,125\n",
                           "\xEF\xBB\xBF# caf\xE9, Latin-1\nnm,value\n400,0.25 # blue\n\n550.5,0.5\n700,0.125",
                           "\"400\",\"0.25\"\n\"550.5\",\"0.5\"\n\"700\",\"0.125\"\n",
                           "Model\tX\nLUX\t27.6\n400nm\t0.25\n550.5nm\t0.5\n700 nm\t0.125\n"}) {
    EXPECT_EQ(readSpectrum(text, "paint.csv", Role::reflectance), expected) << text;
  }
}

TEST(SpectrumFiles, FaultsAreNamedWithLineAndColumn) {
  EXPECT_TRUE(
      says(complaint("400,0.1\n500,x\n600,0.1\n", Role::reflectance), "file.spd:2:5: error: 'x' is not a number"));
  EXPECT_TRUE(
      says(complaint("# c\n400 0.1\n500 nan\n600 0.1\n", Role::reflectance), "file.spd:3:5: error: nan is no value"));
  EXPECT_TRUE(says(complaint("400 0.1\n380 0.1\n", Role::reflectance),
                   "file.spd:2:1: error: wavelength 380 nm comes after 400"));
  EXPECT_TRUE(
      says(complaint("400 0.1\n400 0.2\n", Role::reflectance), "file.spd:2:1: error: wavelength 400 nm stands twice"));
  EXPECT_TRUE(
      says(complaint("400 0.1\n500 -0.1\n", Role::reflectance), "file.spd:2:5: error: reflectance -0.1 is negative"));
  EXPECT_TRUE(
      says(complaint("400 0.1\n500 1.2\n", Role::reflectance), "file.spd:2:5: error: reflectance 1.2 is above 1"));
  EXPECT_TRUE(says(complaint("400 12.5\n500 83\n", Role::reflectance), "looks like percent"));
  EXPECT_TRUE(says(complaint("400 0.1\nend\n", Role::reflectance), "file.spd:2:1: error: 'end' is not a wavelength"));
  EXPECT_TRUE(
      says(complaint("400,0.1,0.2\n500,0.1,0.2\n", Role::reflectance), "file.spd:1:9: error: 3 column(s) found"));
  EXPECT_TRUE(says(complaint("0.4 0.1\n0.7 0.2\n", Role::reflectance), "micrometres"));
  EXPECT_TRUE(says(complaint("4000 0.1\n7000 0.2\n", Role::source), "angstroms"));
  EXPECT_TRUE(says(complaint("900 0.1\n1000 0.2\n", Role::source), "no visible light"));
  EXPECT_TRUE(says(complaint("400 1\n500 -0.5\n", Role::source), "source -0.5 is negative"));
  EXPECT_TRUE(says(complaint("nothing here\n", Role::source), "0 line(s)"));
  EXPECT_TRUE(says(complaint("", Role::source), "0 line(s)"));
  EXPECT_TRUE(says(complaint(std::string("4\0\0\0", 4), Role::source), "not a text file"));
}

TEST(SpectrumFiles, AHoleInATableIsReadWithAWarningThatNamesTheLine) {
  core::Diagnostics warnings;
  readSpectrum("400 0.1\n410 0.1\n420 0.1\n530 0.3\n540 0.3\n700 0.3\n", "paint.spd", Role::reflectance, &warnings);
  ASSERT_EQ(warnings.all().size(), 2U);
  EXPECT_TRUE(says(core::toString(warnings.all()[0]), "paint.spd:4:1: warning: nothing stands between 420 and 530 nm"));
  EXPECT_TRUE(says(core::toString(warnings.all()[1]), "paint.spd:6:1"));
  core::Diagnostics none;
  readSpectrum("400 0.1\n500 0.2\n600 0.3\n700 0.3\n", "coarse.spd", Role::reflectance, &none);
  EXPECT_TRUE(none.all().empty()) << "a coarse table has no holes";
}

TEST(SpectrumFiles, EveryFaultIsListedAtOnce) {
  const auto all = complaint("400 0.1\n500 1.2\n600 -1\n700 inf\n", Role::reflectance);
  EXPECT_TRUE(says(all, ":2:"));
  EXPECT_TRUE(says(all, ":3:"));
  EXPECT_TRUE(says(all, ":4:"));
}

TEST(SpectrumFiles, ValuesAboveOneAreFineForSourcesAndCoefficients) {
  EXPECT_EQ(complaint("400 12\n700 90\n", Role::source), "");
  EXPECT_EQ(complaint("400 12\n700 90\n", Role::coefficient), "");
}

TEST(SpectrumFiles, NoiseBelowZeroOfASourceIsCutOffWithAWarning) {
  core::Diagnostics warnings;
  const auto lamp = readSpectrum("380 -0.001\n390 -0.002\n550 1\n780 0\n", "lamp.csv", Role::source, &warnings);
  EXPECT_EQ(lamp.range().first, 0);
  ASSERT_EQ(warnings.all().size(), 1U);
  EXPECT_EQ(warnings.all()[0].position.line, 1);
}

TEST(SpectrumFiles, AFileThatDoesNotCoverTheVisibleRangeIsReadWithAWarning) {
  core::Diagnostics warnings;
  readSpectrum("450 0.2\n650 0.2\n", "paint.spd", Role::reflectance, &warnings);
  ASSERT_EQ(warnings.all().size(), 1U);
  EXPECT_TRUE(says(warnings.all()[0].message, "covers 450 to 650 nm only"));
}

TEST(SpectrumFiles, MissingFileIsAnInputErrorThatNamesIt) {
  try {
    readSpectrumFile("no/such/file.spd", Role::source);
    FAIL() << "expected an InputError";
  } catch (const core::InputError& error) {
    EXPECT_TRUE(says(error.what(), "no/such/file.spd"));
  }
}

constexpr const char* tm27 = R"(<?xml version="1.0"?>
<IESTM2714 xmlns="iestm2714" version="1.0">
  <Header><Description>x</Description></Header>
  <SpectralDistribution>
    <SpectralQuantity>QUANTITY</SpectralQuantity>
    <SpectralData wavelength="400.0">0.5</SpectralData>
    <SpectralData wavelength="700.0"> 0.75 </SpectralData>
  </SpectralDistribution>
</IESTM2714>)";

std::string tm27With(const std::string& quantity) {
  std::string text = tm27;
  return text.replace(text.find("QUANTITY"), 8, quantity);
}

TEST(SpectrumFiles, Tm27IsRead) {
  const auto lamp = readSpectrum(tm27With("relative"), "lamp.spdx", Role::source);
  EXPECT_EQ(lamp, SpectralDistribution::sampled({{400, 0.5}, {700, 0.75}}, SpectralDistribution::Outside::zero));
}

TEST(SpectrumFiles, Tm27WithAnotherQuantityIsRefused) {
  EXPECT_TRUE(says(complaint(tm27With("reflectance"), Role::source, "a.spdx"), "a.spdx:5:"));
  EXPECT_TRUE(says(complaint(tm27With("transmittance"), Role::reflectance, "a.spdx"), "holds a transmittance"));
  EXPECT_TRUE(says(complaint(tm27With("irradiance"), Role::reflectance, "a.spdx"), "spectrum of a source"));
  EXPECT_EQ(complaint(tm27With("reflectance"), Role::reflectance, "a.spdx"), "");
}

TEST(SpectrumFiles, BrokenTm27IsRefusedWithItsPlace) {
  EXPECT_TRUE(
      says(complaint("<?xml version=\"1.0\"?>\n<item></item>", Role::source, "a.SPDX"), "no SpectralDistribution"));
  EXPECT_TRUE(says(complaint("<a>\n<b>\n</a>", Role::source, "a.spdx"), "a.spdx:3:"));
  EXPECT_TRUE(says(complaint("", Role::source, "a.spdx"), "not well-formed"));
  std::string bad = tm27With("relative");
  bad.replace(bad.find("0.5"), 3, "0x5");
  EXPECT_TRUE(says(complaint(bad, Role::source, "a.spdx"), "a.spdx:6:"));
}

TEST(SpectrumFiles, RealFilesOfTheCorpusAreReadOrRefusedWithAMessage) {
  const auto shared = test::sharedFolder();
  if (!shared) GTEST_SKIP() << test::sharedFolderIsAbsent;
  int read = 0;
  for (const char* folder : {"measured", "tm27", "colour-science"}) {
    for (const auto& entry : std::filesystem::directory_iterator(*shared / "corpus/spectra" / folder)) {
      const std::string name = entry.path().filename().string();
      if (name.rfind("ILLUMINANTS", 0) != 0 && name.rfind("LIGHT_SOURCES", 0) != 0 && folder[0] == 'c') continue;
      if (name == "Invalid.spdx") {
        EXPECT_THROW(readSpectrumFile(entry.path(), Role::source), core::InputError);
        continue;
      }
      try {
        EXPECT_GT(readSpectrumFile(entry.path(), Role::source).integral(cie1931().ybar), 0) << name;
        ++read;
      } catch (const core::InputError& error) {
        ADD_FAILURE() << error.what();
      }
    }
  }
  EXPECT_GT(read, 100);
}

}  // namespace
}  // namespace goniolux::spectrum
